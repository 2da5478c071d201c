//! Orbit diagrams and branches of cycles, over a parameter or ε.

use kahan_algebra::rational::Rational;
use kahan_dynamics::periodic::Stability;
use kahan_latex::symbol;
use kahan_study::{CycleFound, DiagramFound, Range};

use super::{COLOURS, Picture, PictureOptions};
use crate::plot::{Mark, NumberLine, Plot, Series};

/// Draws several orbit diagrams of one field over one range. The first `transient` steps of each
/// orbit are omitted. Panics if `diagrams` is empty.
#[must_use]
pub fn diagram(diagrams: &[DiagramFound], range: &Range, transient: u64, look: &PictureOptions) -> Picture {
    let DiagramFound { system, axis, variable, .. } = &diagrams[0];
    let points = |found: &DiagramFound| -> Vec<(f64, f64)> {
        let values = found.values.iter().map(Rational::to_f64).zip(&found.points);
        values.flat_map(|(value, points)| points.iter().map(move |point| (value, *point))).collect()
    };
    let ends = range.ends();
    let [from, to] = &ends;
    let shown = diagrams.iter().flat_map(|found| &found.points).flatten();
    let x = look.windowed(axis, NumberLine::around(&symbol(axis), ends.iter().map(Rational::to_f64)));
    let y = look.windowed(variable, NumberLine::around_most(&symbol(variable), shown.clone().copied()));
    let mark = if shown.count() > 2000 { Mark::Fine } else { Mark::Points };
    let series = diagrams.iter().enumerate();
    let series = series.map(|(index, found)| Series::new("", index % COLOURS + 1, mark, points(found)));
    let description =
        format!("{variable} of {system} over {axis} from {from} to {to}, after {transient} steps");
    let series = series.collect();
    Picture::of(&Plot { description, sheet: look.sheet, x, y, series, note: String::new() })
}

/// Draws the first variable of a cycle against the parameter. The colour shows whether the cycle is
/// stable. For cycles of the flow, only the greatest and the least value are drawn.
#[must_use]
pub fn branch(found: &CycleFound, look: &PictureOptions) -> Picture {
    let (name, branch) = found.branch.as_ref().map_or(("", None), |(name, branch)| (name, Some(branch)));
    let points = |is_wanted: &dyn Fn(Stability) -> bool| -> Vec<(f64, f64)> {
        let points = branch.into_iter().flat_map(|branch| &branch.points);
        let shown = points.filter(|point| is_wanted(point.cycle.stability()));
        shown
            .flat_map(|point| {
                let values = point.cycle.points.iter().map(|x| x[0]);
                let values: Vec<f64> = match found.flow {
                    Some(_) => vec![values.clone().fold(f64::MIN, f64::max), values.fold(f64::MAX, f64::min)],
                    None => values.collect(),
                };
                values.into_iter().map(|value| (point.parameter, value))
            })
            .collect()
    };
    let is_stable = |stability| matches!(stability, Stability::Attracting | Stability::Neutral);
    let series = vec![
        Series::new("attracting or neutral", 1, Mark::Dots, points(&is_stable)),
        Series::new("repelling or saddle", 2, Mark::Dots, points(&|stability| !is_stable(stability))),
    ];
    let description = format!("Cycles of {} over {name}", found.system);
    let plot = Plot::around(&description, [&*symbol(name), &*symbol(&found.variables[0])], series);
    Picture::of(&Plot { sheet: look.sheet, ..plot })
}
