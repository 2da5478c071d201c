//! Growth of the heights of an exact orbit.

use kahan_algebra::rational::Rational;
use kahan_latex::symbol;
use kahan_runtime::heights::Growth;
use kahan_study::HeightsFound;

use super::{COLOURS, Picture, PictureOptions};
use crate::plot::{Mark, NumberLine, Plot, Series, TickKind};

/// Draws the logarithms of the heights of each variable. For exponential growth, the abscissa is n.
/// Otherwise it is ln n, so powers of n become straight lines.
#[must_use]
pub fn heights(found: &HeightsFound, eps: &Rational, look: &PictureOptions) -> Picture {
    let survey = &found.survey;
    let is_exponential = survey.growth == Growth::Exponential;
    let mark = if survey.heights.len() < 30 { Mark::Both } else { Mark::Line };
    let series = |(index, name): (usize, &String)| {
        let heights = survey.component(index).into_iter().enumerate().skip(1);
        let across = |n: usize| if is_exponential { n as f64 } else { libm::log(n as f64) };
        let points = heights.map(|(n, h)| (across(n), libm::log(h)));
        // A height of 0 has no logarithm.
        let points = points.filter(|point| point.1.is_finite()).collect();
        Series::new(&symbol(name), index % COLOURS + 1, mark, points)
    };
    let series = found.variables.iter().enumerate().map(series).collect();
    let description = format!(
        "Natural logarithms of the heights of {} at eps = {eps}: growth is {}",
        found.system, survey.growth
    );
    let (across, marks) = if is_exponential { ("n", TickKind::Whole) } else { ("ln n", TickKind::Round) };
    let plot = Plot::around(&description, [across, "ln of the logarithmic height"], series);
    let x = NumberLine { marks, ..plot.x };
    Picture { outside: 0, ..Picture::of(&Plot { sheet: look.sheet, x, ..plot }) }
}
