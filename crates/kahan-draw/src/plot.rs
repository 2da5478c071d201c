//! Drawings with axes: points in the plane, orbits in space, and grids of numbers.
//!
//! A [`Plot`], [`SpacePlot`] or [`Grid`] becomes a [`Drawing`]. Lengths are in units of the view
//! box. A small view box keeps text legible on telephones.

#[cfg(test)]
mod colour_vision;
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
mod space_plot;
#[cfg(test)]
mod tests;

use maud::{Markup, html};

pub use drawing::{Canvas, Drawing, DrawingFileError, Format};
pub use grid::Grid;
use label::{LARGE_FONT_SIZE, SMALL_FONT_SIZE, fit_to_width, reach, text, width};
use legend::Legend;
use number_line::Tick;
pub use number_line::{NumberLine, TickKind, decimal};
use palette::Paint;
pub use palette::Theme;
pub(crate) use palette::{style, variables};
use path::{Place, dots, line, polyline, rings, stroked};
pub(crate) use script::{subscript, superscript};
pub use space_plot::{SpacePlot, SpaceSeries};

/// The style of a series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A line through the points.
    Line,
    /// A thin line, for thousands of points.
    Thin,
    /// A broad pale line, drawn below others.
    Band,
    /// A dashed line that marks a constant value.
    Level,
    /// Dots.
    Dots,
    /// Small dots.
    Points,
    /// The finest visible dots, for tens of thousands of points.
    Fine,
    /// A thin line with dots.
    Both,
    /// A thin line with small rings.
    Rings,
    /// Large rings.
    Ring,
}

impl Mark {
    fn has_line(self) -> bool {
        !matches!(self, Mark::Dots | Mark::Points | Mark::Fine | Mark::Ring)
    }

    fn dot(self) -> Option<f64> {
        match self {
            Mark::Dots | Mark::Both => Some(4.0),
            Mark::Points => Some(2.4),
            Mark::Fine => Some(1.1),
            _ => None,
        }
    }

    fn ring(self) -> Option<f64> {
        match self {
            Mark::Rings => Some(2.2),
            Mark::Ring => Some(6.0),
            _ => None,
        }
    }

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

    /// Returns the dash pattern that distinguishes a colour from the others in grey print.
    fn dashes(self, colour: usize) -> Option<&'static str> {
        match (self, colour) {
            (Mark::Level, _) => Some("5 4"),
            (Mark::Band, _) => None,
            _ => [None, Some("8 5"), Some("0.5 4"), Some("9 5 0.5 5"), Some("16 5"), None][colour - 1],
        }
    }
}

/// Points drawn in one style.
#[derive(Clone, Debug)]
pub struct Series {
    /// The label in the legend. Series without a label are omitted there.
    pub label: String,
    /// The colour, 1 to 6.
    pub colour: usize,
    /// The style.
    pub mark: Mark,
    /// The points in the coordinates of the axes. Points outside the axes are omitted, and lines
    /// are clipped.
    pub points: Vec<(f64, f64)>,
}

impl Series {
    /// Makes a series.
    #[must_use]
    pub fn new(label: &str, colour: usize, mark: Mark, points: Vec<(f64, f64)>) -> Self {
        Series { label: label.to_owned(), colour, mark, points }
    }

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
    /// The description for screen readers.
    pub description: String,
    /// The canvas to draw on.
    pub sheet: Canvas,
    /// The horizontal axis.
    pub x: NumberLine,
    /// The vertical axis.
    pub y: NumberLine,
    /// The series in drawing order. Later series cover earlier series.
    pub series: Vec<Series>,
    /// A note after the legend. An empty note is omitted.
    pub note: String,
}

impl Plot {
    /// Makes a plot whose axes show all points.
    #[must_use]
    pub fn around(description: &str, [x, y]: [&str; 2], series: Vec<Series>) -> Self {
        let points = || series.iter().flat_map(|series| &series.points);
        Plot {
            description: description.to_owned(),
            sheet: Canvas::page(480, 320),
            x: NumberLine::around(x, points().map(|point| point.0)),
            y: NumberLine::around(y, points().map(|point| point.1)),
            series,
            note: String::new(),
        }
    }

    fn shows(&self, &(x, y): &(f64, f64)) -> bool {
        self.x.shows(x) && self.y.shows(y)
    }

    fn lines(&self, points: &[(f64, f64)]) -> Vec<Vec<(f64, f64)>> {
        let mut lines: Vec<Vec<(f64, f64)>> = Vec::new();
        for pair in points.windows(2) {
            let Some([from, to]) = self.visible_part(pair[0], pair[1]) else { continue };
            match lines.last_mut() {
                Some(line) if line.last() == Some(&from) => line.push(to),
                _ => lines.push(vec![from, to]),
            }
        }
        let alone = points.iter().filter(|point| points.len() == 1 && self.shows(point));
        lines.extend(alone.map(|point| vec![*point]));
        lines
    }

    fn visible_part(&self, from: (f64, f64), to: (f64, f64)) -> Option<[(f64, f64); 2]> {
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

    /// Counts the points outside the axes.
    #[must_use]
    pub fn outside(&self) -> usize {
        self.series.iter().flat_map(|series| &series.points).filter(|point| !self.shows(point)).count()
    }

    /// Draws the plot.
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
            (frame.grid_lines(&self.x, &self.y))
            (frame.axes(&self.x, &self.y))
            @for series in &self.series { (drawn(series)) }
            (legend.drawn())
        };
        Drawing { description: self.description.clone(), sheet: self.sheet, body }
    }
}

/// The rectangle that two axes span within a drawing.
#[derive(Clone, Copy, Debug)]
struct Frame {
    sheet: Canvas,
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

const TOP: f64 = 12.0;
const BOTTOM: f64 = 42.0;

impl Frame {
    /// Returns the largest frame that leaves room for labels. The legend has height `above`, and
    /// the right margin has width `beside`.
    fn around(sheet: Canvas, above: f64, beside: f64, x: &NumberLine, y: &NumberLine) -> Self {
        let (across, upwards) = sheet.view_box;
        let frame = Frame { sheet, left: 0.0, right: across, top: above + TOP, bottom: upwards - BOTTOM };
        let widest = |ticks: Vec<(Place, String)>| {
            ticks.iter().map(|(_, value)| width(value, SMALL_FONT_SIZE)).fold(0.0, f64::max)
        };
        let left = 20.0 + 6.0 + widest(frame.y_labels(y)) + 7.0;
        // Half of the last label may extend beyond the right end of the axis.
        let out = widest(Frame { left, ..frame }.x_labels(x)) / 2.0 + 4.0;
        Frame { left, right: across - beside.max(out.max(14.0)), ..frame }
    }

    fn place(&self, x: &NumberLine, y: &NumberLine, point: (f64, f64)) -> Place {
        (x.place(point.0, self.left, self.right), y.place(point.1, self.bottom, self.top))
    }

    fn x_labels(&self, x: &NumberLine) -> Vec<(Place, String)> {
        placed_labels(x, |value| (x.place(value, self.left, self.right), self.bottom))
    }

    fn y_labels(&self, y: &NumberLine) -> Vec<(Place, String)> {
        placed_labels(y, |value| (self.left, y.place(value, self.bottom, self.top)))
    }

    fn grid_lines(&self, x: &NumberLine, y: &NumberLine) -> Markup {
        grid(
            self.sheet.theme,
            &html! {
                @for ((x, _), _) in self.x_labels(x) { (line((x, self.top), (x, self.bottom))) }
                @for ((_, y), _) in self.y_labels(y) { (line((self.left, y), (self.right, y))) }
            },
        )
    }

    /// Returns the top and the bottom of the space for the name of the vertical axis.
    fn height(&self) -> [f64; 2] {
        [self.top - TOP, self.bottom + BOTTOM / 2.0]
    }

    fn axes(&self, x: &NumberLine, y: &NumberLine) -> Markup {
        let Frame { sheet, left, right, top, bottom } = *self;
        let axes = html! {
            (line((left, bottom), (right, bottom)))
            (line((left, top), (left, bottom)))
        };
        let values = html! {
            @for ((x, _), value) in self.x_labels(x) { (text((x, bottom + 16.0), 0, "middle", SMALL_FONT_SIZE, &value)) }
            @for ((_, y), value) in self.y_labels(y) { (text((left - 7.0, y + 4.2), 0, "end", SMALL_FONT_SIZE, &value)) }
        };
        html! {
            (Paint::AXES.group(sheet.theme, &axes))
            (Paint::TICKS.group(sheet.theme, &values))
            (name(sheet.theme, [0.0, sheet.view_box.0], ((left + right) / 2.0, bottom + 34.0), 0, &x.name()))
            (name(sheet.theme, self.height(), (16.0, (top + bottom) / 2.0), -90, &y.name()))
        }
    }
}

/// Draws the name of an axis within the range from `from` to `to`. The name is centred at its
/// position if possible.
fn name(theme: Theme, [from, to]: [f64; 2], (x, y): Place, turn: i32, words: &str) -> Markup {
    const FREE: f64 = 5.0;
    let (words, size) = fit_to_width(words, LARGE_FONT_SIZE, to - from - 2.0 * FREE);
    let half = reach(&words, size) + FREE;
    let within = |middle: f64| middle.min(to - half).max(from + half);
    let place = if turn == 0 { (within(x), y) } else { (x, within(y)) };
    Paint::NAMES.group(theme, &text(place, turn, "middle", size, &words))
}

/// Returns positions and labels of ticks. Labels do not overlap.
fn placed_labels(axis: &NumberLine, at: impl Fn(f64) -> Place) -> Vec<(Place, String)> {
    /// The smallest vertical distance of two labels.
    const LINE: f64 = 14.0;
    const FREE: f64 = 7.0;

    let fits = |ticks: &[Tick]| {
        ticks.windows(2).all(|pair| {
            let ((x, y), (next_x, next_y)) = (at(pair[0].value), at(pair[1].value));
            let both = width(&pair[0].text, SMALL_FONT_SIZE) + width(&pair[1].text, SMALL_FONT_SIZE);
            (next_y - y).abs() >= LINE || (next_x - x).abs() >= both / 2.0 + FREE
        })
    };
    axis.ticks(fits).into_iter().map(|tick| (at(tick.value), tick.text)).collect()
}

fn grid(theme: Theme, lines: &Markup) -> Markup {
    html! { g stroke-width=(theme.line(0.8)) { (Paint::GRID.group(theme, lines)) } }
}
