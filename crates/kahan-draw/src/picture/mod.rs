//! Answers as pictures.
//!
//! In: answers, or the rows of orbits as they come, and how the picture is to look. Out: a
//! [`Picture`]. What was asked, and how long that may take, this module must not know.

mod chart;
mod heights;
mod over;
mod portrait;
mod relations;
mod trade;

pub use chart::{Chart, chart};
pub use heights::heights;
pub use over::{branch, diagram};
pub use portrait::{Coordinate, Trace, Visits, portrait};
pub use relations::relations;
pub use trade::{trade, trade_sheet};

use crate::plot::{Drawing, NumberLine, Plot, Sheet};

/// Colours that series have in turn; the sixth is grey, for what they are compared with.
const COLOURS: usize = 5;

/// How a picture is to look.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// What it is drawn on.
    pub sheet: Sheet,
    /// Where axes begin and end, by their names; the others show nearly all there is.
    pub windows: Vec<(String, [f64; 2])>,
    /// Whether lines join the points of an orbit.
    pub lines: bool,
}

/// A picture, and what there is to say of it.
#[derive(Clone, Debug)]
pub struct Picture {
    /// The picture.
    pub drawing: Drawing,
    /// How many points there are.
    pub points: usize,
    /// How many of these its axes do not show.
    pub outside: usize,
    /// What is seen of each orbit of a portrait or a section.
    pub visits: Vec<Visits>,
}

impl Look {
    /// As it is without wishes, on this.
    #[must_use]
    pub fn on(sheet: Sheet) -> Self {
        Look { sheet, windows: Vec::new(), lines: false }
    }

    /// The axis of this name, with the ends that its window has.
    fn windowed(&self, name: &str, line: NumberLine) -> NumberLine {
        match self.windows.iter().find(|(known, _)| known == name) {
            Some((_, [low, high])) => NumberLine { low: *low, high: *high, ..line },
            None => line,
        }
    }
}

impl Picture {
    fn of(plot: &Plot) -> Self {
        let points = plot.series.iter().map(|series| series.points.len()).sum();
        Picture { drawing: plot.drawing(), points, outside: plot.outside(), visits: Vec::new() }
    }
}
