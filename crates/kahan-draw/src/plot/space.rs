//! Orbits in space: a parallel projection of a box with its axes, near points and lines wider than
//! far ones.

use maud::{Markup, html};

use super::palette::Paint;
use super::path::{Place, dots, line, polyline, stroked, tenths, text};
use super::{Drawing, Mark, NumberLine, Sheet, grid, names_of_axes, placed, ticks};

/// Points in space that belong together.
#[derive(Clone, Debug)]
pub struct Cloud {
    /// The colour, 1 to 6.
    pub colour: usize,
    /// How it is drawn.
    pub mark: Mark,
    /// In the units of the axes; what these do not show is left out, and no line leads there.
    pub points: Vec<[f64; 3]>,
}

/// A drawing in space.
#[derive(Clone, Debug)]
pub struct Space {
    /// What is seen, for those who do not see it.
    pub description: String,
    /// What it is drawn on.
    pub sheet: Sheet,
    /// To the right, to the back, upwards.
    pub axes: [NumberLine; 3],
    /// What is drawn.
    pub clouds: Vec<Cloud>,
}

/// Room that is left around the box: on the left and below for words.
const LEFT: f64 = 62.0;
const RIGHT: f64 = 24.0;
const TOP: f64 = 14.0;
const BOTTOM: f64 = 46.0;
/// The width of lines in the middle of the box.
const LINE: f64 = 1.4;
const TURN: f64 = 0.62;
const TILT: f64 = 0.5;
/// Layers of depth, from the back: so many that the width of a line changes less from one to the
/// next than can be seen.
const LAYERS: usize = 24;
/// Boxes that are longer than this many times their width are drawn as cubes.
const SLENDER: f64 = 4.0;

/// To the right, upwards, and towards the eye: from the front, a little from the right and from
/// above.
fn turned([x, y, z]: [f64; 3]) -> [f64; 3] {
    let (right, back) = (x * TURN.cos() - y * TURN.sin(), x * TURN.sin() + y * TURN.cos());
    [right, z * TILT.cos() + back * TILT.sin(), z * TILT.sin() - back * TILT.cos()]
}

/// The projection that fills a drawing with a box.
struct View {
    /// Where the middle of the box is drawn.
    centre: Place,
    middle: [f64; 3],
    /// What the box's lengths are multiplied by before they are turned.
    stretch: [f64; 3],
    scale: f64,
    /// The greatest depth before the middle, and behind it.
    depth: f64,
}

impl View {
    fn of(axes: &[NumberLine; 3], size: (f64, f64)) -> Self {
        let lengths = axes.each_ref().map(|axis| axis.high - axis.low);
        let middle = axes.each_ref().map(|axis| axis.low + (axis.high - axis.low) / 2.0);
        let (short, long) =
            (lengths.into_iter().fold(f64::MAX, f64::min), lengths.into_iter().fold(0.0, f64::max));
        let stretch = if long > SLENDER * short { lengths.map(f64::recip) } else { [long.recip(); 3] };
        let reach = |i: usize| {
            let corners = (0..8).map(|bits| turned(half(bits, lengths, stretch))[i].abs());
            corners.fold(0.0, f64::max)
        };
        let (width, height) = (size.0 - LEFT - RIGHT, size.1 - TOP - BOTTOM);
        let scale = (width / 2.0 / reach(0)).min(height / 2.0 / reach(1));
        let centre = (LEFT + width / 2.0, TOP + height / 2.0);
        View { centre, middle, stretch, scale, depth: reach(2) }
    }

    fn turned(&self, point: [f64; 3]) -> [f64; 3] {
        turned(std::array::from_fn(|i| (point[i] - self.middle[i]) * self.stretch[i]))
    }

    fn place(&self, point: [f64; 3]) -> Place {
        let [right, up, _] = self.turned(point);
        (self.centre.0 + self.scale * right, self.centre.1 - self.scale * up)
    }

    /// How near a point is: 0 at the back of the box, 1 at the front.
    fn nearness(&self, point: [f64; 3]) -> f64 {
        (self.turned(point)[2] / self.depth + 1.0) / 2.0
    }

    /// Which layer of depth a point is in.
    fn layer(&self, point: [f64; 3]) -> usize {
        ((self.nearness(point) * LAYERS as f64) as usize).min(LAYERS - 1)
    }
}

/// The width of lines or dots in a layer of depth, of those that are so wide in the middle.
fn width_in(layer: usize, middle: f64) -> f64 {
    const AT_THE_BACK: f64 = 0.7;
    let nearness = (layer as f64 + 0.5) / LAYERS as f64;
    middle * (AT_THE_BACK + 2.0 * (1.0 - AT_THE_BACK) * nearness)
}

/// From the middle of the box to a corner: a bit that is set means the greater end of that axis.
fn half(bits: usize, lengths: [f64; 3], stretch: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| lengths[i] * stretch[i] * if bits >> i & 1 == 1 { 0.5 } else { -0.5 })
}

impl Space {
    /// The drawing.
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        let view = View::of(&self.axes, self.sheet.view_box);
        let body = html! {
            (self.edges(&view))
            @for layer in 0..LAYERS {
                @for cloud in &self.clouds { (self.cloud(&view, cloud, layer)) }
            }
            (self.names(&view))
        };
        Drawing { description: self.description.clone(), sheet: self.sheet, body }
    }

    /// How many points there are that the axes do not show.
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

    /// What of a cloud lies in one layer of depth.
    fn cloud(&self, view: &View, cloud: &Cloud, layer: usize) -> Markup {
        let is_here = |point: &[f64; 3]| self.shows(point) && view.layer(*point) == layer;
        let places = |points: &[[f64; 3]]| points.iter().map(|point| view.place(*point)).collect::<Vec<_>>();
        let here: Vec<[f64; 3]> = cloud.points.iter().copied().filter(is_here).collect();
        if here.is_empty() {
            return html! {};
        }
        // A part goes on to the first point of the next layer, so that the line has no gaps.
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
        Paint::curve(cloud.colour).group(theme, &html! {
            @if mark.has_line() { (stroked("line", &lines(), width_in(layer, theme.line(LINE)))) }
            @if mark.has_dots() { (stroked("dots", &dots(&places(&here)), width_in(layer, theme.line(mark.dot())))) }
        })
    }

    /// Round values along the edges of the axes, and the names of these further out.
    fn names(&self, view: &View) -> Markup {
        let along = |axis: usize| {
            let ((from, _), line) = (AXES[axis], &self.axes[axis]);
            let beside = move |value: f64, (right, down): Place| {
                let mut point = self.corner(from);
                point[axis] = value;
                let (x, y) = view.place(point);
                (x + right, y + down)
            };
            let middle = line.low + (line.high - line.low) / 2.0;
            let values = placed(line, |value| beside(value, BESIDE[axis]));
            (values, beside(middle, NAMES[axis]))
        };
        let axes: Vec<_> = (0..3).map(along).collect();
        let values = html! {
            @for ((values, _), anchor) in axes.iter().zip(ANCHORS) {
                @for (place, value) in values { (text(*place, anchor, value)) }
            }
        };
        let [x, y, z] = self.axes.each_ref().map(NumberLine::name);
        let (right, up) = (tenths(axes[2].1.0), tenths(axes[2].1.1));
        let names = html! {
            (text(axes[0].1, "start", &x))
            (text(axes[1].1, "end", &y))
            text transform=(format!("translate({right} {up}) rotate(-90)")) text-anchor="middle" { (z) }
        };
        html! {
            (ticks(self.sheet.theme, &values))
            (names_of_axes(self.sheet.theme, &names))
        }
    }
}

/// The edges of the outline that carry the axes: two below, one on the left.
const AXES: [(usize, usize); 3] = [(0b000, 0b001), (0b000, 0b010), (0b010, 0b110)];
/// How far to the right of its edge, and below it, an axis has its values.
const BESIDE: [Place; 3] = [(8.0, 16.0), (-14.0, 14.0), (-7.0, 4.5)];
/// On which side of these places the values are.
const ANCHORS: [&str; 3] = ["middle", "middle", "end"];
/// The same of its name.
const NAMES: [Place; 3] = [(20.0, 32.0), (-28.0, 28.0), (-50.0, 0.0)];
