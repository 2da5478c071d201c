//! Draws orbits in space in parallel projection. Near points and lines are wider than distant ones.

use std::cell::Cell;

use maud::{Markup, html};

use super::label::{LARGE_FONT_SIZE, SMALL_FONT_SIZE, text, width};
use super::palette::Paint;
use super::path::{Place, dots, line, polyline, stroked};
use super::{Canvas, Drawing, Mark, NumberLine, Theme, grid, name, placed_labels};

/// Points in space drawn in one style.
#[derive(Clone, Debug)]
pub struct SpaceSeries {
    /// The colour, 1 to 6.
    pub colour: usize,
    /// The style.
    pub mark: Mark,
    /// The points in the coordinates of the axes. Points outside the axes are omitted and interrupt
    /// lines.
    pub points: Vec<[f64; 3]>,
}

/// A drawing in space.
#[derive(Clone, Debug)]
pub struct SpacePlot {
    /// The description for screen readers.
    pub description: String,
    /// The canvas to draw on.
    pub sheet: Canvas,
    /// The axes to the right, to the back and upwards.
    pub axes: [NumberLine; 3],
    /// The series of points.
    pub clouds: Vec<SpaceSeries>,
}

const RIGHT_MARGIN: f64 = 16.0;
const TOP_MARGIN: f64 = 10.0;
const BOTTOM_MARGIN: f64 = 40.0;
const LINE_WIDTH: f64 = 1.4;
const THIN_LINE_WIDTH: f64 = 0.7;
const AZIMUTH: f64 = 0.62;
const ELEVATION: f64 = 0.5;
/// The number of depth layers. Each layer has one line width.
const DEPTH_LAYERS: usize = 24;
/// Axes have separate scales if the longest edge of the box exceeds the shortest by this factor.
const STRETCH_RATIO: f64 = 4.0;
const MAX_STRETCHED_WIDTH: f64 = 2.0;

/// Returns the coordinates of a point to the right, upwards, and towards the eye. The eye is in
/// front of the box, slightly to the right and above.
fn rotated([x, y, z]: [f64; 3]) -> [f64; 3] {
    let (right, back) =
        (x * libm::cos(AZIMUTH) - y * libm::sin(AZIMUTH), x * libm::sin(AZIMUTH) + y * libm::cos(AZIMUTH));
    [
        right,
        z * libm::cos(ELEVATION) + back * libm::sin(ELEVATION),
        z * libm::sin(ELEVATION) - back * libm::cos(ELEVATION),
    ]
}

struct View {
    centre: Place,
    middle: [f64; 3],
    stretch: [f64; 3],
    scale: f64,
    depth: f64,
}

impl View {
    fn of(axes: &[NumberLine; 3], size: (f64, f64)) -> Self {
        let lengths = axes.each_ref().map(|axis| axis.high - axis.low);
        let middle = axes.each_ref().map(|axis| axis.low + (axis.high - axis.low) / 2.0);
        let (short, long) =
            (lengths.into_iter().fold(f64::MAX, f64::min), lengths.into_iter().fold(0.0, f64::max));
        let reach = |stretch: [f64; 3]| -> [f64; 3] {
            let corners = (0..8).map(|bits| rotated(half_diagonal(bits, lengths, stretch)).map(f64::abs));
            corners.fold([0.0; 3], |far, corner| std::array::from_fn(|i| far[i].max(corner[i])))
        };
        let left = 27.0 + (7.0 + widest(&axes[2])).max(14.0 + widest(&axes[1]) / 2.0);
        let right = RIGHT_MARGIN.max(12.0 + widest(&axes[0]) / 2.0);
        let (width, height) = (size.0 - left - right, size.1 - TOP_MARGIN - BOTTOM_MARGIN);
        let scale = |reach: [f64; 3]| (width / 2.0 / reach[0]).min(height / 2.0 / reach[1]);
        let stretch = if long > STRETCH_RATIO * short {
            let broad = |by: f64| [by / lengths[0], by / lengths[1], 1.0 / lengths[2]];
            let boxes =
                (0..=10).map(|part| broad(1.0 + (MAX_STRETCHED_WIDTH - 1.0) * f64::from(part) / 10.0));
            let area = |stretch: [f64; 3]| {
                let reach = reach(stretch);
                reach[0] * reach[1] * scale(reach).powi(2)
            };
            boxes.max_by(|one, other| area(*one).total_cmp(&area(*other))).expect("there are eleven")
        } else {
            [long.recip(); 3]
        };
        let reach = reach(stretch);
        let (scale, depth) = (scale(reach), reach[2]);
        let centre = (left + width / 2.0, TOP_MARGIN + height / 2.0);
        View { centre, middle, stretch, scale, depth }
    }

    fn rotated(&self, point: [f64; 3]) -> [f64; 3] {
        rotated(std::array::from_fn(|i| (point[i] - self.middle[i]) * self.stretch[i]))
    }

    fn place(&self, point: [f64; 3]) -> Place {
        let [right, up, _] = self.rotated(point);
        (self.centre.0 + self.scale * right, self.centre.1 - self.scale * up)
    }

    fn nearness(&self, point: [f64; 3]) -> f64 {
        (self.rotated(point)[2] / self.depth + 1.0) / 2.0
    }

    fn layer(&self, point: [f64; 3]) -> usize {
        ((self.nearness(point) * DEPTH_LAYERS as f64) as usize).min(DEPTH_LAYERS - 1)
    }
}

fn widest(axis: &NumberLine) -> f64 {
    let most = Cell::new(0.0_f64);
    axis.ticks(|ticks| {
        ticks.iter().for_each(|tick| most.set(most.get().max(width(&tick.text, SMALL_FONT_SIZE))));
        false
    });
    most.get()
}

/// Returns the width of lines or dots in a layer, given the width in the middle layer.
fn width_in(layer: usize, middle: f64) -> f64 {
    const AT_THE_BACK: f64 = 0.7;
    let nearness = (layer as f64 + 0.5) / DEPTH_LAYERS as f64;
    middle * (AT_THE_BACK + 2.0 * (1.0 - AT_THE_BACK) * nearness)
}

/// Returns the vector from the box's centre to a corner. Bit i of `bits` selects an end of axis i.
fn half_diagonal(bits: usize, lengths: [f64; 3], stretch: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| lengths[i] * stretch[i] * if bits >> i & 1 == 1 { 0.5 } else { -0.5 })
}

impl SpacePlot {
    /// Draws the box with its axes and the series of points.
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        let view = View::of(&self.axes, self.sheet.view_box);
        let body = html! {
            (self.edges(&view))
            @for layer in 0..DEPTH_LAYERS {
                @for cloud in &self.clouds { (self.cloud(&view, cloud, layer)) }
            }
            (self.names(&view))
        };
        Drawing { description: self.description.clone(), sheet: self.sheet, body }
    }

    /// Counts the points outside the axes.
    #[must_use]
    pub fn outside(&self) -> usize {
        self.clouds.iter().flat_map(|cloud| &cloud.points).filter(|point| !self.shows(point)).count()
    }

    fn shows(&self, point: &[f64; 3]) -> bool {
        self.axes.iter().zip(point).all(|(axis, value)| axis.shows(*value))
    }

    fn corner(&self, bits: usize) -> [f64; 3] {
        std::array::from_fn(|i| if bits >> i & 1 == 1 { self.axes[i].high } else { self.axes[i].low })
    }

    fn edges(&self, view: &View) -> Markup {
        let edges = (0..8_usize).flat_map(|from| [1, 2, 4].map(|bit| (from, from | bit)));
        let edges = edges.filter(|(from, to)| from != to).map(|ends| (ends, AXES.contains(&ends)));
        let (axes, others): (Vec<_>, Vec<_>) = edges.partition(|(_, is_axis)| *is_axis);
        let theme = self.sheet.theme;
        let drawn = |((from, to), _): &((usize, usize), bool)| {
            line(view.place(self.corner(*from)), view.place(self.corner(*to)))
        };
        html! {
            (grid(theme, &html! { @for edge in &others { (drawn(edge)) } }))
            (Paint::AXES.group(theme, &html! { @for edge in &axes { (drawn(edge)) } }))
        }
    }

    fn cloud(&self, view: &View, cloud: &SpaceSeries, layer: usize) -> Markup {
        let is_here = |point: &[f64; 3]| self.shows(point) && view.layer(*point) == layer;
        let places = |points: &[[f64; 3]]| points.iter().map(|point| view.place(*point)).collect::<Vec<_>>();
        let here: Vec<[f64; 3]> = cloud.points.iter().copied().filter(is_here).collect();
        if here.is_empty() {
            return html! {};
        }
        // Each piece of a line ends at the first point of the next piece, so lines have no gaps.
        let lines = || {
            let mut path = String::new();
            let mut from = 0;
            while let Some(start) = (from..cloud.points.len()).find(|&i| is_here(&cloud.points[i])) {
                let end = (start..cloud.points.len()).find(|&i| !is_here(&cloud.points[i]));
                let end = end.unwrap_or(cloud.points.len());
                let is_shown = |i: usize| cloud.points.get(i).is_some_and(|point| self.shows(point));
                path += &polyline(&places(&cloud.points[start..if is_shown(end) { end + 1 } else { end }]));
                from = end;
            }
            path
        };
        let (mark, theme) = (cloud.mark, self.sheet.theme);
        let dashes = mark.dashes(cloud.colour).filter(|_| theme == Theme::Paper);
        let middle = theme.line(if mark == Mark::Thin { THIN_LINE_WIDTH } else { LINE_WIDTH });
        Paint::curve(cloud.colour).group(theme, &html! {
            @if mark.has_line() { (stroked("line", &lines(), width_in(layer, middle), dashes)) }
            @if let Some(dot) = mark.dot() { (stroked("dots", &dots(&places(&here)), width_in(layer, theme.line(dot)), None)) }
        })
    }

    fn names(&self, view: &View) -> Markup {
        let beside = |axis: usize, value: f64, (right, down): Place| {
            let mut point = self.corner(AXES[axis].0);
            point[axis] = value;
            let (x, y) = view.place(point);
            (x + right, y + down)
        };
        let middle = |axis: usize| {
            let line = &self.axes[axis];
            line.low + (line.high - line.low) / 2.0
        };
        let mut boxes: Vec<[f64; 4]> = Vec::new();
        let mut values = Vec::new();
        for axis in [2, 0, 1] {
            for (place, value) in placed_labels(&self.axes[axis], |value| beside(axis, value, BESIDE[axis])) {
                let long = width(&value, SMALL_FONT_SIZE);
                let left = place.0 - if axis == 2 { long } else { long / 2.0 };
                let own = [left - 4.0, place.1 - 11.0, left + long + 4.0, place.1 + 2.0];
                if boxes.iter().all(|other| (0..2).any(|i| own[i] > other[i + 2] || other[i] > own[i + 2])) {
                    boxes.push(own);
                    values.push((place, ANCHORS[axis], value));
                }
            }
        }
        let (across, upwards) = self.sheet.view_box;
        let (corner, lowest) = view.place(self.corner(AXES[0].0));
        let below = |axis: usize| {
            let (named, (right, down)) = (self.axes[axis].name(), NAMES[axis]);
            let out = right + right.signum() * widest(&self.axes[axis]) / 2.0;
            let (x, y) = beside(axis, middle(axis), (out, down));
            let is_long = width(&named, LARGE_FONT_SIZE) > 2.0 * LARGE_FONT_SIZE;
            let room = if axis == 0 { [corner, across] } else { [0.0, corner] };
            name(
                self.sheet.theme,
                room,
                (x, if is_long { lowest + 34.0 } else { y }.min(upwards - 6.0)),
                0,
                &named,
            )
        };
        let (leftmost, theme) = (boxes.iter().map(|own| own[0]).fold(across, f64::min), self.sheet.theme);
        let y = beside(2, middle(2), (0.0, 0.0)).1;
        let foot = view.place(self.corner(AXES[2].0)).1;
        html! {
            (Paint::TICKS.group(theme, &html! {
                @for (place, anchor, value) in &values { (text(*place, 0, anchor, SMALL_FONT_SIZE, value)) }
            }))
            (below(0)) (below(1))
            (name(theme, [0.0, foot], (leftmost - 4.0, y), -90, &self.axes[2].name()))
        }
    }
}

/// The corners at both ends of each axis. Bit i of a corner is 1 at the upper end of axis i.
const AXES: [(usize, usize); 3] = [(0b000, 0b001), (0b000, 0b010), (0b010, 0b110)];
const BESIDE: [Place; 3] = [(8.0, 16.0), (-14.0, 14.0), (-7.0, 4.5)];
const ANCHORS: [&str; 3] = ["middle", "middle", "end"];
/// The offsets of names of the two lower axes, to the right and downwards.
const NAMES: [Place; 2] = [(20.0, 32.0), (-26.0, 28.0)];
