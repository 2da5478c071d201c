//! Pictures: points, orbits in space and grids of numbers as drawings with axes.
//!
//! One description of a figure ([`Plot`], [`Space`], [`Grid`]) becomes a [`Drawing`], which is SVG
//! within a page, or a file of its own, as SVG or as PNG. Drawings take colours and type from a
//! style sheet that knows light and dark, scale with the window, and are read out by their label.
//! Lengths are units of the view box; text stays legible on a telephone because the box is small.

mod drawing;
mod grid;
mod label;
mod legend;
mod number_line;
mod palette;
mod path;
mod ramp;
#[cfg(any(feature = "png", feature = "pdf"))]
mod render;
mod script;
#[cfg(test)]
mod sight;
mod space;
#[cfg(test)]
mod tests;

use maud::{Markup, html};

pub use drawing::{Drawing, Format, NoFile, Sheet};
pub use grid::Grid;
use label::{LARGE, SMALL, fitted, reach, text, width};
use legend::Legend;
use number_line::Tick;
pub use number_line::{Marks, NumberLine, decimal};
use palette::Paint;
pub use palette::Theme;
pub(crate) use palette::{style, variables};
use path::{Place, dots, line, polyline, rings, stroked};
pub(crate) use script::{lowered, raised};
pub use space::{Cloud, Space};

/// How the points of a series are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A line through them.
    Line,
    /// A thin line through very many of them.
    Thin,
    /// A broad pale line, to be drawn below others.
    Band,
    /// A dashed line, for comparison.
    Level,
    /// A dot each.
    Dots,
    /// A small dot each.
    Points,
    /// A dot each that is as fine as can be seen, for very many.
    Fine,
    /// A thin line with a dot at each.
    Both,
    /// A thin line with a small ring at each.
    Rings,
    /// A large ring around each.
    Ring,
}

impl Mark {
    fn has_line(self) -> bool {
        !matches!(self, Mark::Dots | Mark::Points | Mark::Fine | Mark::Ring)
    }

    /// The width of its dots.
    fn dot(self) -> Option<f64> {
        match self {
            Mark::Dots | Mark::Both => Some(4.0),
            Mark::Points => Some(2.4),
            Mark::Fine => Some(1.1),
            _ => None,
        }
    }

    /// The radius of its rings.
    fn ring(self) -> Option<f64> {
        match self {
            Mark::Rings => Some(2.2),
            Mark::Ring => Some(6.0),
            _ => None,
        }
    }

    /// The width of its line in a colour; the sixth is for what others are compared with.
    fn line(self, colour: usize) -> f64 {
        match self {
            Mark::Band => 7.0,
            Mark::Thin => 0.8,
            _ if colour == 6 => 1.4,
            Mark::Both | Mark::Rings => 1.0,
            Mark::Ring => 1.6,
            _ => 2.0,
        }
    }

    /// The dashes of its line, which tell colours apart where all are grey. They have round ends.
    fn dashes(self, colour: usize) -> Option<&'static str> {
        match (self, colour) {
            (Mark::Level, _) => Some("5 4"),
            (Mark::Band, _) => None,
            _ => [None, Some("8 5"), Some("0.5 4"), Some("9 5 0.5 5"), Some("16 5"), None][colour - 1],
        }
    }
}

/// Points that belong together.
#[derive(Clone, Debug)]
pub struct Series {
    /// What the legend calls it; may be empty.
    pub label: String,
    /// The colour, 1 to 6.
    pub colour: usize,
    /// How it is drawn.
    pub mark: Mark,
    /// (x, y) in the units of the axes. What these do not show is left out, and lines end where
    /// they leave what is shown.
    pub points: Vec<(f64, f64)>,
}

impl Series {
    /// A series of these points.
    #[must_use]
    pub fn new(label: &str, colour: usize, mark: Mark, points: Vec<(f64, f64)>) -> Self {
        Series { label: label.to_owned(), colour, mark, points }
    }

    /// Its lines through parts, and its dots or rings at places.
    fn shape(&self, theme: Theme, parts: &[Vec<Place>], places: &[Place]) -> Markup {
        let Series { mark, colour, .. } = *self;
        let paint = if mark == Mark::Band { Paint::BAND } else { Paint::curve(colour) };
        let is_dashed = mark == Mark::Level || !self.label.is_empty() || theme == Theme::Paper;
        let dashes = mark.dashes(colour).filter(|_| is_dashed);
        let lines = || parts.iter().map(|part| polyline(part)).collect::<String>();
        paint.group(theme, &html! {
            @if mark.has_line() { (stroked("line", &lines(), theme.line(mark.line(colour)), dashes)) }
            @if let Some(dot) = mark.dot() { (stroked("dots", &dots(places), theme.line(dot), None)) }
            @if let Some(radius) = mark.ring() { (stroked("rings", &rings(places, radius), theme.line(mark.line(colour)), None)) }
        })
    }
}

/// A drawing in the plane.
#[derive(Clone, Debug)]
pub struct Plot {
    /// What is seen, for those who do not see it.
    pub description: String,
    /// What it is drawn on.
    pub sheet: Sheet,
    /// To the right.
    pub x: NumberLine,
    /// Upwards.
    pub y: NumberLine,
    /// What is drawn, each over those before.
    pub series: Vec<Series>,
    /// What stands behind the legend; may be empty.
    pub note: String,
}

impl Plot {
    /// A drawing whose axes show all points.
    #[must_use]
    pub fn around(description: &str, [x, y]: [&str; 2], series: Vec<Series>) -> Self {
        let points = || series.iter().flat_map(|series| &series.points);
        Plot {
            description: description.to_owned(),
            sheet: Sheet::page(480, 320),
            x: NumberLine::around(x, points().map(|point| point.0)),
            y: NumberLine::around(y, points().map(|point| point.1)),
            series,
            note: String::new(),
        }
    }

    fn shows(&self, &(x, y): &(f64, f64)) -> bool {
        self.x.shows(x) && self.y.shows(y)
    }

    /// The lines from point to point, as far as the axes show them.
    fn lines(&self, points: &[(f64, f64)]) -> Vec<Vec<(f64, f64)>> {
        let mut lines: Vec<Vec<(f64, f64)>> = Vec::new();
        for pair in points.windows(2) {
            let Some([from, to]) = self.part(pair[0], pair[1]) else { continue };
            match lines.last_mut() {
                Some(line) if line.last() == Some(&from) => line.push(to),
                _ => lines.push(vec![from, to]),
            }
        }
        let alone = points.iter().filter(|point| points.len() == 1 && self.shows(point));
        lines.extend(alone.map(|point| vec![*point]));
        lines
    }

    /// The part of the line between two points that the axes show.
    fn part(&self, from: (f64, f64), to: (f64, f64)) -> Option<[(f64, f64); 2]> {
        let mut ends = [0.0_f64, 1.0];
        for (axis, from, to) in [(&self.x, from.0, to.0), (&self.y, from.1, to.1)] {
            if axis.shows(from) && axis.shows(to) {
                continue;
            }
            let at = [axis.low, axis.high].map(|end| (end - from) / (to - from));
            if !at.iter().all(|at| at.is_finite()) {
                return None;
            }
            ends = [ends[0].max(at[0].min(at[1])), ends[1].min(at[0].max(at[1]))];
        }
        let between =
            |from: f64, to: f64, part: f64| if part == 1.0 { to } else { from + part * (to - from) };
        let at = |part: f64| (between(from.0, to.0, part), between(from.1, to.1, part));
        (ends[0] <= ends[1]).then(|| ends.map(at))
    }

    /// How many points there are that the axes do not show.
    #[must_use]
    pub fn outside(&self) -> usize {
        self.series.iter().flat_map(|series| &series.points).filter(|point| !self.shows(point)).count()
    }

    /// The drawing.
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        let legend = Legend::of(&self.series, &self.note, self.sheet);
        let frame = Frame::around(self.sheet, legend.height(), 0.0, &self.x, &self.y);
        let drawn = |series: &Series| {
            let place = |point: &(f64, f64)| frame.place(&self.x, &self.y, *point);
            let lines: Vec<Vec<Place>> =
                self.lines(&series.points).iter().map(|line| line.iter().map(place).collect()).collect();
            let shown = series.points.iter().filter(|point| self.shows(point));
            series.shape(self.sheet.theme, &lines, &shown.map(place).collect::<Vec<_>>())
        };
        let body = html! {
            (frame.across(&self.x, &self.y))
            (frame.axes(&self.x, &self.y))
            @for series in &self.series { (drawn(series)) }
            (legend.drawn())
        };
        Drawing { description: self.description.clone(), sheet: self.sheet, body }
    }
}

/// The rectangle within a drawing that two axes span.
#[derive(Clone, Copy, Debug)]
struct Frame {
    sheet: Sheet,
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

/// Room above the frame and below it.
const TOP: f64 = 12.0;
const BOTTOM: f64 = 42.0;

impl Frame {
    /// The largest one beside and above which the values at the ticks and the names have room;
    /// other things have so much room above, and on the right.
    fn around(sheet: Sheet, above: f64, beside: f64, x: &NumberLine, y: &NumberLine) -> Self {
        let (across, upwards) = sheet.view_box;
        let frame = Frame { sheet, left: 0.0, right: across, top: above + TOP, bottom: upwards - BOTTOM };
        let widest = |ticks: Vec<(Place, String)>| {
            ticks.iter().map(|(_, value)| width(value, SMALL)).fold(0.0, f64::max)
        };
        let left = 20.0 + 6.0 + widest(frame.up(y)) + 7.0;
        // A value below the right end of an axis stands out half its width.
        let out = widest(Frame { left, ..frame }.along(x)) / 2.0 + 4.0;
        Frame { left, right: across - beside.max(out.max(14.0)), ..frame }
    }

    fn place(&self, x: &NumberLine, y: &NumberLine, point: (f64, f64)) -> Place {
        (x.place(point.0, self.left, self.right), y.place(point.1, self.bottom, self.top))
    }

    /// The ticks below it.
    fn along(&self, x: &NumberLine) -> Vec<(Place, String)> {
        placed(x, |value| (x.place(value, self.left, self.right), self.bottom))
    }

    /// The ticks beside it.
    fn up(&self, y: &NumberLine) -> Vec<(Place, String)> {
        placed(y, |value| (self.left, y.place(value, self.bottom, self.top)))
    }

    /// Lines across at round values, behind what is drawn.
    fn across(&self, x: &NumberLine, y: &NumberLine) -> Markup {
        grid(
            self.sheet.theme,
            &html! {
                @for ((x, _), _) in self.along(x) { (line((x, self.top), (x, self.bottom))) }
                @for ((_, y), _) in self.up(y) { (line((self.left, y), (self.right, y))) }
            },
        )
    }

    /// From below the legend to above the name of the lower axis, where the others have room.
    fn height(&self) -> [f64; 2] {
        [self.top - TOP, self.bottom + BOTTOM / 2.0]
    }

    /// Both axes with their names and round values.
    fn axes(&self, x: &NumberLine, y: &NumberLine) -> Markup {
        let Frame { sheet, left, right, top, bottom } = *self;
        let axes = html! {
            (line((left, bottom), (right, bottom)))
            (line((left, top), (left, bottom)))
        };
        let values = html! {
            @for ((x, _), value) in self.along(x) { (text((x, bottom + 16.0), 0, "middle", SMALL, &value)) }
            @for ((_, y), value) in self.up(y) { (text((left - 7.0, y + 4.2), 0, "end", SMALL, &value)) }
        };
        html! {
            (Paint::AXES.group(sheet.theme, &axes))
            (Paint::TICKS.group(sheet.theme, &values))
            (name(sheet.theme, [0.0, sheet.view_box.0], ((left + right) / 2.0, bottom + 34.0), 0, &x.name()))
            (name(sheet.theme, self.height(), (16.0, (top + bottom) / 2.0), -90, &y.name()))
        }
    }
}

/// The name of an axis, with its middle at a place, or as near to it as it has room between two
/// ends: along the lower side, or upwards or downwards along another.
fn name(theme: Theme, [from, to]: [f64; 2], (x, y): Place, turn: i32, words: &str) -> Markup {
    const FREE: f64 = 5.0;
    let (words, size) = fitted(words, LARGE, to - from - 2.0 * FREE);
    let half = reach(&words, size) + FREE;
    let within = |middle: f64| middle.min(to - half).max(from + half);
    let place = if turn == 0 { (within(x), y) } else { (x, within(y)) };
    Paint::NAMES.group(theme, &text(place, turn, "middle", size, &words))
}

/// The ticks of an axis where they are drawn, as many as have room for their words.
fn placed(axis: &NumberLine, at: impl Fn(f64) -> Place) -> Vec<(Place, String)> {
    /// The height of a line, and what is left free between words.
    const LINE: f64 = 14.0;
    const FREE: f64 = 7.0;

    let fits = |ticks: &[Tick]| {
        ticks.windows(2).all(|pair| {
            let ((x, y), (next_x, next_y)) = (at(pair[0].value), at(pair[1].value));
            let both = width(&pair[0].text, SMALL) + width(&pair[1].text, SMALL);
            (next_y - y).abs() >= LINE || (next_x - x).abs() >= both / 2.0 + FREE
        })
    };
    axis.ticks(fits).into_iter().map(|tick| (at(tick.value), tick.text)).collect()
}

/// Lines behind what is drawn.
fn grid(theme: Theme, lines: &Markup) -> Markup {
    html! { g stroke-width=(theme.line(0.8)) { (Paint::GRID.group(theme, lines)) } }
}
