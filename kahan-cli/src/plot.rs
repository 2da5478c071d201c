//! Points to SVG: axes with round ticks, lines and dots, labels where the curves end.
//!
//! The drawings take colours and type from the page (`currentColor` and classes), scale with the
//! window, and are read out by their label. Lengths are units of the view box; text stays legible
//! on a telephone because the box is small.

mod number_line;
#[cfg(test)]
mod tests;

use std::fmt::Write as _;

use maud::{Markup, html};

use crate::numbers::decimal;

pub(crate) use number_line::NumberLine;

/// How the points of a series are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    /// A line through them.
    Line,
    /// A dot each.
    Dots,
    /// A small dot each.
    Points,
    /// A thin line with a dot at each.
    Both,
}

/// Where the label of a series stands, seen from its last point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// Above, to the right or to the left, where there is room.
    Above,
    /// Above, to the left.
    Left,
    /// Below.
    Below,
}

/// Points that belong together.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    /// What stands where it ends; may be empty.
    pub(crate) label: String,
    /// Where its label stands.
    pub(crate) side: Side,
    /// The colour, 1 to 6.
    pub(crate) colour: usize,
    /// How it is drawn.
    pub(crate) mark: Mark,
    /// (x, y) in the units of the axes; what is not finite is left out.
    pub(crate) points: Vec<(f64, f64)>,
}

impl Series {
    /// A series with its label above its end.
    pub(crate) fn new(label: &str, colour: usize, mark: Mark, points: Vec<(f64, f64)>) -> Self {
        Series { label: label.to_owned(), side: Side::Above, colour, mark, points }
    }
}

/// A drawing in the plane.
#[derive(Clone, Debug)]
pub(crate) struct Plot {
    /// What is seen, for those who do not see it.
    pub(crate) description: String,
    /// Width and height of the view box.
    pub(crate) size: (f64, f64),
    pub(crate) x: NumberLine,
    pub(crate) y: NumberLine,
    /// Horizontal lines for comparison: height and label.
    pub(crate) levels: Vec<(f64, String)>,
    pub(crate) series: Vec<Series>,
}

/// The usual size.
pub(crate) const SIZE: (f64, f64) = (480.0, 320.0);
const LEFT: f64 = 66.0;
const RIGHT: f64 = 18.0;
const TOP: f64 = 16.0;
const BOTTOM: f64 = 50.0;

impl Plot {
    /// The place of a point in the view box.
    fn place(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let (width, height) = self.size;
        (self.x.place(x, LEFT, width - RIGHT), self.y.place(y, height - BOTTOM, TOP))
    }

    /// The drawing.
    pub(crate) fn svg(&self) -> Markup {
        let (width, height) = self.size;
        html! {
            svg viewBox=(format!("0 0 {width} {height}")) role="img" aria-label=(self.description) {
                (self.axes())
                @for (level, label) in &self.levels { (self.level(*level, label)) }
                @for series in &self.series { (self.series(series)) }
                // Labels last, so that no curve runs through them.
                @for series in &self.series { (self.label(series)) }
            }
        }
    }

    fn axes(&self) -> Markup {
        let (width, height) = self.size;
        let (bottom, right) = (height - BOTTOM, width - RIGHT);
        let (xs, x_decimals) = self.x.ticks();
        let (ys, y_decimals) = self.y.ticks();
        let middle = (TOP + bottom) / 2.0;
        html! {
            g.grid {
                @for x in &xs { (line((self.place((*x, self.y.low)).0, TOP), (self.place((*x, self.y.low)).0, bottom))) }
                @for y in &ys { (line((LEFT, self.place((self.x.low, *y)).1), (right, self.place((self.x.low, *y)).1))) }
            }
            g.axes {
                (line((LEFT, bottom), (right, bottom)))
                (line((LEFT, TOP), (LEFT, bottom)))
            }
            g.ticks {
                @for x in &xs {
                    (text((self.place((*x, self.y.low)).0, bottom + 18.0), "middle", &decimal(*x, x_decimals)))
                }
                @for y in &ys {
                    (text((LEFT - 7.0, self.place((self.x.low, *y)).1 + 4.5), "end", &decimal(*y, y_decimals)))
                }
            }
            g.names {
                (text(((LEFT + right) / 2.0, height - 8.0), "middle", &self.x.label))
                text transform=(format!("translate(16 {}) rotate(-90)", tenths(middle))) text-anchor="middle" {
                    (self.y.label)
                }
            }
        }
    }

    fn level(&self, level: f64, label: &str) -> Markup {
        if !self.y.shows(level) {
            return html! {};
        }
        let (right, y) = self.place((self.x.high, level));
        html! {
            g.level {
                (line((LEFT, y), (right, y)))
                (text((right - 4.0, y - 5.0), "end", label))
            }
        }
    }

    fn series(&self, series: &Series) -> Markup {
        let colour = format!("c{}", series.colour);
        let places: Vec<(f64, f64)> = series
            .points
            .iter()
            .filter(|(x, y)| x.is_finite() && y.is_finite())
            .map(|&point| self.place(point))
            .collect();
        html! {
            g.(colour) {
                @if matches!(series.mark, Mark::Line | Mark::Both) {
                    path.line.thin[series.mark == Mark::Both] d=(polyline(&places)) {}
                }
                @if series.mark != Mark::Line { path.dots.small[series.mark == Mark::Points] d=(dots(&places)) {} }
            }
        }
    }

    /// The label beside the last point, on the side where there is room.
    fn label(&self, series: &Series) -> Markup {
        let last = series.points.iter().rev().find(|(x, y)| self.x.shows(*x) && self.y.shows(*y));
        let (Some(&last), false) = (last, series.label.is_empty()) else { return html! {} };
        let (x, y) = self.place(last);
        let (width, _) = self.size;
        let anchor = if series.side == Side::Left || x > 0.7 * width { "end" } else { "start" };
        let y = if series.side == Side::Below || y < TOP + 10.0 { y + 24.0 } else { y - 10.0 };
        let colour = format!("c{}", series.colour);
        html! { g.(colour) { g.label { (text((x, y), anchor, &series.label)) } } }
    }
}

/// A straight line.
pub(crate) fn line(from: (f64, f64), to: (f64, f64)) -> Markup {
    html! { line x1=(tenths(from.0)) y1=(tenths(from.1)) x2=(tenths(to.0)) y2=(tenths(to.1)) {} }
}

/// Words at a place; `anchor` is `start`, `middle` or `end`.
pub(crate) fn text(at: (f64, f64), anchor: &str, words: &str) -> Markup {
    html! { text x=(tenths(at.0)) y=(tenths(at.1)) text-anchor=(anchor) { (words) } }
}

/// A line through places, in tenths of a unit; places that fall together are one.
pub(crate) fn polyline(places: &[(f64, f64)]) -> String {
    let mut path = String::new();
    let mut before = None;
    for &(x, y) in places {
        let here = (tenths(x), tenths(y));
        if before.as_ref() != Some(&here) {
            let command = if before.is_none() { 'M' } else { 'L' };
            // Writing to a string cannot fail.
            let _ = write!(path, "{command}{} {}", here.0, here.1);
            before = Some(here);
        }
    }
    path
}

/// A dot at each place: lines of no length with round ends, which is a third of the size of
/// circles.
pub(crate) fn dots(places: &[(f64, f64)]) -> String {
    places.iter().fold(String::new(), |mut path, &(x, y)| {
        let _ = write!(path, "M{} {}h0", tenths(x), tenths(y));
        path
    })
}

fn tenths(value: f64) -> String {
    let text = format!("{value:.1}");
    text.strip_suffix(".0").map_or_else(|| text.clone(), str::to_owned)
}
