//! Orbits in space: a parallel projection of a box with its axes, near points larger and clearer
//! than far ones.

use maud::{Markup, html};

use super::path::{Place, dots, line, polyline, text};
use super::{Drawing, Mark, NumberLine};

/// Points in space that belong together.
#[derive(Clone, Debug)]
pub(crate) struct Cloud {
    /// The colour, 1 to 6.
    pub(crate) colour: usize,
    /// How it is drawn.
    pub(crate) mark: Mark,
    /// In the units of the axes; what these do not show is left out, and no line leads there.
    pub(crate) points: Vec<[f64; 3]>,
}

/// A drawing in space.
#[derive(Clone, Debug)]
pub(crate) struct Space {
    /// What is seen, for those who do not see it.
    pub(crate) description: String,
    /// Width and height of the view box.
    pub(crate) size: (f64, f64),
    pub(crate) axes: [NumberLine; 3],
    pub(crate) clouds: Vec<Cloud>,
}

/// Room that is left around the box.
const ROOM: f64 = 40.0;
const TURN: f64 = 0.62;
const TILT: f64 = 0.36;
/// Layers of depth, from the back, and the class of each.
const LAYERS: [&str; 3] = ["far", "between", "near"];
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
    size: (f64, f64),
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
        let scale = ((size.0 / 2.0 - ROOM) / reach(0)).min((size.1 / 2.0 - ROOM) / reach(1));
        View { size, middle, stretch, scale, depth: reach(2) }
    }

    fn turned(&self, point: [f64; 3]) -> [f64; 3] {
        turned(std::array::from_fn(|i| (point[i] - self.middle[i]) * self.stretch[i]))
    }

    fn place(&self, point: [f64; 3]) -> Place {
        let [right, up, _] = self.turned(point);
        (self.size.0 / 2.0 + self.scale * right, self.size.1 / 2.0 - self.scale * up)
    }

    /// Which layer of depth a point is in.
    fn layer(&self, point: [f64; 3]) -> usize {
        let part = (self.turned(point)[2] / self.depth + 1.0) / 2.0;
        ((part * LAYERS.len() as f64) as usize).min(LAYERS.len() - 1)
    }
}

/// From the middle of the box to a corner: a bit that is set means the greater end of that axis.
fn half(bits: usize, lengths: [f64; 3], stretch: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| lengths[i] * stretch[i] * if bits >> i & 1 == 1 { 0.5 } else { -0.5 })
}

impl Space {
    /// The drawing.
    pub(crate) fn drawing(&self) -> Drawing {
        let view = View::of(&self.axes, self.size);
        let body = html! {
            (self.edges(&view))
            @for (layer, class) in LAYERS.iter().enumerate() {
                @for cloud in &self.clouds { (self.cloud(&view, cloud, layer, class)) }
            }
            (self.names(&view))
        };
        Drawing { description: self.description.clone(), size: self.size, body }
    }

    /// How many points there are that the axes do not show.
    pub(crate) fn outside(&self) -> usize {
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
        let drawn = |((from, to), _): &((usize, usize), bool)| {
            line(view.place(self.corner(*from)), view.place(self.corner(*to)))
        };
        html! {
            g.grid { @for edge in &others { (drawn(edge)) } }
            g.axes { @for edge in &axes { (drawn(edge)) } }
        }
    }

    /// What of a cloud lies in one layer of depth.
    fn cloud(&self, view: &View, cloud: &Cloud, layer: usize, class: &str) -> Markup {
        let is_here = |point: &[f64; 3]| self.shows(point) && view.layer(*point) == layer;
        let places = |points: &[[f64; 3]]| points.iter().map(|point| view.place(*point)).collect::<Vec<_>>();
        let here: Vec<[f64; 3]> = cloud.points.iter().copied().filter(is_here).collect();
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
        html! {
            g class=(format!("c{}", cloud.colour)) {
                @if cloud.mark.has_line() { path.(format!("line {class}")) d=(lines()) {} }
                @if cloud.mark.has_dots() { path.(format!("{} {class}", cloud.mark.dots())) d=(dots(&places(&here))) {} }
            }
        }
    }

    /// The names of the axes beside the middle of their edges, and round values along these.
    fn names(&self, view: &View) -> Markup {
        let along = |axis: usize| {
            let ((from, _), (right, down)) = (AXES[axis], BESIDE[axis]);
            let at = move |value: f64| {
                let mut point = self.corner(from);
                point[axis] = value;
                let (x, y) = view.place(point);
                (x + right, y + down)
            };
            let ticks = self.axes[axis].ticks();
            let ends: Vec<_> = match &ticks[..] {
                [first, .., last] => {
                    vec![(at(first.value), first.text.clone()), (at(last.value), last.text.clone())]
                }
                _ => Vec::new(),
            };
            let line = &self.axes[axis];
            let (x, y) = at(line.low + (line.high - line.low) / 2.0);
            ((x + 0.3 * right, y + 0.3 * down), ends)
        };
        let axes: Vec<_> = (0..3).map(along).collect();
        html! {
            g.ticks {
                @for (_, ends) in &axes { @for (place, value) in ends { (text(*place, "middle", value)) } }
            }
            g.names {
                @for ((place, _), axis) in axes.iter().zip(&self.axes) { (text(*place, "middle", &axis.name())) }
            }
        }
    }
}

/// The edges of the outline that carry the axes: two below, one on the left.
const AXES: [(usize, usize); 3] = [(0b000, 0b001), (0b000, 0b010), (0b010, 0b110)];
/// How far to the right of its edge, and below it, an axis has its words.
const BESIDE: [(f64, f64); 3] = [(12.0, 20.0), (-14.0, 18.0), (-16.0, 5.0)];
