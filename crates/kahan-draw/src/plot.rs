//! Pictures: points, orbits in space and grids of numbers as drawings with axes.
//!
//! One description of a figure ([`Plot`], [`Space`], [`Grid`]) becomes a [`Drawing`], which is SVG
//! within a page, or a file of its own, as SVG or as PNG. Drawings take colours and type from a
//! style sheet that knows light and dark, scale with the window, and are read out by their label.
//! Lengths are units of the view box; text stays legible on a telephone because the box is small.

mod drawing;
mod grid;
mod number_line;
mod palette;
mod path;
mod ramp;
#[cfg(any(feature = "png", feature = "pdf"))]
mod render;
#[cfg(test)]
mod sight;
mod space;
#[cfg(test)]
mod tests;

use maud::{Markup, html};

pub use drawing::{Drawing, Format, NoFile, Sheet};
pub use grid::Grid;
use number_line::Tick;
pub use number_line::{NumberLine, decimal};
use palette::Paint;
pub use palette::Theme;
pub(crate) use palette::{style, variables};
use path::{Place, dots, line, polyline, stroked, tenths, text};
pub use space::{Cloud, Space};

/// How the points of a series are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A line through them.
    Line,
    /// A dot each.
    Dots,
    /// A small dot each.
    Points,
    /// A dot each that is as fine as can be seen, for very many.
    Fine,
    /// A thin line with a dot at each.
    Both,
}

/// Where the label of a series stands, seen from its last point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Above, to the right or to the left, where there is room.
    Above,
    /// Above, to the left.
    Left,
    /// Below.
    Below,
}

impl Mark {
    fn has_line(self) -> bool {
        matches!(self, Mark::Line | Mark::Both)
    }

    fn has_dots(self) -> bool {
        self != Mark::Line
    }

    /// The width of its dots.
    fn dot(self) -> f64 {
        match self {
            Mark::Points => 2.4,
            Mark::Fine => 1.1,
            _ => 4.0,
        }
    }

    /// The width of its line in a colour; the sixth is for what others are compared with.
    fn line(self, colour: usize) -> f64 {
        match self {
            _ if colour == 6 => 1.4,
            Mark::Both => 1.0,
            _ => 2.0,
        }
    }
}

/// Points that belong together.
#[derive(Clone, Debug)]
pub struct Series {
    /// What stands where it ends; may be empty.
    pub label: String,
    /// Where its label stands.
    pub side: Side,
    /// The colour, 1 to 6.
    pub colour: usize,
    /// How it is drawn.
    pub mark: Mark,
    /// (x, y) in the units of the axes; what these do not show is left out, and no line leads
    /// there.
    pub points: Vec<(f64, f64)>,
}

impl Series {
    /// A series with its label above its end.
    #[must_use]
    pub fn new(label: &str, colour: usize, mark: Mark, points: Vec<(f64, f64)>) -> Self {
        Series { label: label.to_owned(), side: Side::Above, colour, mark, points }
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
    /// Horizontal lines for comparison: height and label.
    pub levels: Vec<(f64, String)>,
    /// What is drawn, each over those before.
    pub series: Vec<Series>,
}

const LEFT: f64 = 66.0;
const RIGHT: f64 = 18.0;
const TOP: f64 = 16.0;
const BOTTOM: f64 = 50.0;

impl Plot {
    /// A drawing without levels, whose axes show all points.
    #[must_use]
    pub fn around(description: &str, [x, y]: [&str; 2], series: Vec<Series>) -> Self {
        let points = || series.iter().flat_map(|series| &series.points);
        Plot {
            description: description.to_owned(),
            sheet: Sheet::page(480, 320),
            x: NumberLine::around(x, points().map(|point| point.0)),
            y: NumberLine::around(y, points().map(|point| point.1)),
            levels: Vec::new(),
            series,
        }
    }

    fn frame(&self) -> Frame {
        let (width, height) = self.sheet.view_box;
        let (right, bottom) = (width - RIGHT, height - BOTTOM);
        Frame { left: LEFT, right, top: TOP, bottom, theme: self.sheet.theme }
    }

    /// The place of a point in the view box.
    fn place(&self, point: (f64, f64)) -> (f64, f64) {
        self.frame().place(&self.x, &self.y, point)
    }

    fn shows(&self, &(x, y): &(f64, f64)) -> bool {
        self.x.shows(x) && self.y.shows(y)
    }

    /// How many points there are that the axes do not show.
    #[must_use]
    pub fn outside(&self) -> usize {
        self.series.iter().flat_map(|series| &series.points).filter(|point| !self.shows(point)).count()
    }

    /// The drawing.
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        let body = html! {
            (self.frame().axes(&self.x, &self.y))
            @for (level, label) in &self.levels { (self.level(*level, label)) }
            @for series in &self.series { (self.series(series)) }
            // Labels last, so that no curve runs through them.
            @for (colour, place, anchor, words) in self.labels() {
                (haloed(self.sheet.theme, Paint::label(colour), 600, &text(place, anchor, words)))
            }
        };
        Drawing { description: self.description.clone(), sheet: self.sheet, body }
    }

    fn level(&self, level: f64, label: &str) -> Markup {
        if !self.y.shows(level) {
            return html! {};
        }
        let (right, y) = self.place((self.x.high, level));
        let rule = html! { g stroke-dasharray="5 4" { (line((LEFT, y), (right, y))) } };
        html! {
            (Paint::LEVEL.group(self.sheet.theme, &rule))
            (haloed(self.sheet.theme, Paint::LEVEL_NAME, 400, &text(self.level_name(level), "end", label)))
        }
    }

    /// Where the name of a level ends.
    fn level_name(&self, level: f64) -> Place {
        let (right, y) = self.place((self.x.high, level));
        (right - 4.0, y - 5.0)
    }

    fn series(&self, series: &Series) -> Markup {
        let parts = series.points.split(|point| !self.shows(point));
        let parts: Vec<Vec<(f64, f64)>> =
            parts.map(|part| part.iter().map(|&point| self.place(point)).collect()).collect();
        let (mark, colour, theme) = (series.mark, series.colour, self.sheet.theme);
        Paint::curve(colour).group(theme, &html! {
            @if mark.has_line() {
                (stroked("line", &parts.iter().map(|part| polyline(part)).collect::<String>(), theme.line(mark.line(colour))))
            }
            @if mark.has_dots() { (stroked("dots", &dots(&parts.concat()), theme.line(mark.dot()))) }
        })
    }

    /// The colour, place, anchor and words of each label: beside the last point, on the side where
    /// there is room, and below another one that would be in its way, or above it where the drawing
    /// ends.
    fn labels(&self) -> Vec<(usize, Place, &'static str, &str)> {
        const LINE: f64 = 16.0;

        let mut labels: Vec<(usize, Place, &'static str, &str)> = Vec::new();
        let levels: Vec<Place> = self.levels.iter().map(|(level, _)| self.level_name(*level)).collect();
        for series in self.series.iter().filter(|series| !series.label.is_empty()) {
            let last = series.points.iter().rev().find(|point| self.shows(point));
            let Some(&last) = last else { continue };
            let (x, y) = self.place(last);
            let anchor =
                if series.side == Side::Left || x > 0.7 * self.sheet.view_box.0 { "end" } else { "start" };
            let y = if series.side == Side::Below || y < TOP + 10.0 { y + 24.0 } else { y - 10.0 };
            let is_taken = |y: f64| {
                let mut others = labels.iter().map(|label| &label.1).chain(&levels);
                others.any(|(at, height)| (at - x).abs() < 2.0 * LINE && (height - y).abs() < LINE)
            };
            let below = (0..).map(|i| y + f64::from(i) * LINE).take_while(|y| *y < self.frame().bottom);
            let above = (1..self.series.len() + 2).map(|i| y - i as f64 * LINE);
            let y = below.chain(above).find(|y| !is_taken(*y)).unwrap_or(y);
            labels.push((series.colour, (x, y), anchor, &series.label));
        }
        labels
    }
}

/// The rectangle within a drawing that two axes span.
#[derive(Clone, Copy, Debug)]
struct Frame {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
    theme: Theme,
}

impl Frame {
    fn place(&self, x: &NumberLine, y: &NumberLine, point: (f64, f64)) -> (f64, f64) {
        (x.place(point.0, self.left, self.right), y.place(point.1, self.bottom, self.top))
    }

    /// Both axes with their names, round values and lines across.
    fn axes(&self, x: &NumberLine, y: &NumberLine) -> Markup {
        let Frame { left, right, top, bottom, theme } = *self;
        let xs = placed(x, |value| (x.place(value, left, right), bottom));
        let ys = placed(y, |value| (left, y.place(value, bottom, top)));
        let across = html! {
            @for ((x, _), _) in &xs { (line((*x, top), (*x, bottom))) }
            @for ((_, y), _) in &ys { (line((left, *y), (right, *y))) }
        };
        let axes = html! {
            (line((left, bottom), (right, bottom)))
            (line((left, top), (left, bottom)))
        };
        let values = html! {
            @for ((x, _), value) in &xs { (text((*x, bottom + 18.0), "middle", value)) }
            @for ((_, y), value) in &ys { (text((left - 7.0, y + 4.5), "end", value)) }
        };
        let names = html! {
            (text(((left + right) / 2.0, bottom + 42.0), "middle", &x.name()))
            text transform=(format!("translate(16 {}) rotate(-90)", tenths((top + bottom) / 2.0))) text-anchor="middle" {
                (y.name())
            }
        };
        html! {
            (grid(theme, &across))
            (Paint::AXES.group(theme, &axes))
            (ticks(theme, &values))
            (names_of_axes(theme, &names))
        }
    }
}

/// The ticks of an axis where they are drawn, as many as have room for their words.
fn placed(axis: &NumberLine, at: impl Fn(f64) -> Place) -> Vec<(Place, String)> {
    /// The width of a digit, and the height of a line, with what is left free around them.
    const DIGIT: f64 = 7.0;
    const LINE: f64 = 13.0;
    const FREE: f64 = 5.0;

    let width = |tick: &Tick| DIGIT * tick.text.chars().count() as f64 + FREE;
    let fits = |ticks: &[Tick]| {
        ticks.windows(2).all(|pair| {
            let ((x, y), (next_x, next_y)) = (at(pair[0].value), at(pair[1].value));
            (next_y - y).abs() >= LINE || (next_x - x).abs() >= (width(&pair[0]) + width(&pair[1])) / 2.0
        })
    };
    axis.ticks(fits).into_iter().map(|tick| (at(tick.value), tick.text)).collect()
}

/// Lines behind what is drawn.
fn grid(theme: Theme, lines: &Markup) -> Markup {
    html! { g stroke-width=(theme.line(0.8)) { (Paint::GRID.group(theme, lines)) } }
}

/// The values at the ticks of axes.
fn ticks(theme: Theme, values: &Markup) -> Markup {
    html! { g font-size="12" { (Paint::TICKS.group(theme, values)) } }
}

/// What axes are called.
fn names_of_axes(theme: Theme, names: &Markup) -> Markup {
    html! { g font-size="13" font-style="italic" { (Paint::NAMES.group(theme, names)) } }
}

/// Words on top of what is drawn there, with paper around them; they are written twice, as not
/// every program that reads SVG can paint the outline of a letter below it.
fn haloed(theme: Theme, paint: Paint, weight: u32, words: &Markup) -> Markup {
    html! {
        g font-size="12.5" font-weight=(weight) {
            g stroke-width="3" stroke-linejoin="round" aria-hidden="true" { (Paint::HALO.group(theme, words)) }
            (paint.group(theme, words))
        }
    }
}
