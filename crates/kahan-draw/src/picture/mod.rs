//! Pictures of answers.
//!
//! The input is an answer or the rows of orbits, and options for the picture.

mod chart;
mod heights;
mod over;
mod portrait;
mod relations;
mod trade;

pub use chart::{Chart, chart};
pub use heights::heights;
pub use over::{branch, diagram};
pub use portrait::{Coordinate, OrbitExtent, Trace, portrait};
pub use relations::relations;
pub use trade::{trade, trade_canvas};

use crate::plot::{Canvas, Drawing, NumberLine, Plot};

/// Series are drawn in this many colours in turn. A sixth colour, grey, marks reference curves.
const COLOURS: usize = 5;

/// The appearance of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureOptions {
    /// The canvas to draw on.
    pub sheet: Canvas,
    /// Names of axes, each with the least and greatest value shown. The ranges of other axes are
    /// chosen from the values.
    pub windows: Vec<(String, [f64; 2])>,
    /// Whether lines join the points of an orbit.
    pub lines: bool,
}

/// A drawing with counts of its points.
#[derive(Clone, Debug)]
pub struct Picture {
    /// The drawing.
    pub drawing: Drawing,
    /// The number of points.
    pub points: usize,
    /// The number of points outside the axes.
    pub outside: usize,
    /// The number of points and of distinct positions of each orbit of a portrait or section.
    pub visits: Vec<OrbitExtent>,
}

impl PictureOptions {
    /// Returns the default options on a canvas.
    #[must_use]
    pub fn on(sheet: Canvas) -> Self {
        PictureOptions { sheet, windows: Vec::new(), lines: false }
    }

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
