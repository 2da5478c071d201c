//! Draws the errors of a lift's relations along an orbit.

use kahan_study::{LiftFound, WatchedOrbit};

use super::{COLOURS, Picture, PictureOptions};
use crate::plot::{Mark, NumberLine, Plot, Series, TickKind};

/// Draws the errors of each relation along an orbit on a logarithmic axis. Relations whose errors
/// are all 0 are omitted. Returns `None` if no errors were measured.
#[must_use]
pub fn relations(found: &LiftFound, look: &PictureOptions) -> Option<Picture> {
    let WatchedOrbit { eps, errors: seen, .. } = found.watched.as_ref()?;
    let end = 2.0 * eps * seen.steps as f64;
    let series = found.relations.iter().zip(&seen.errors).enumerate().map(|(index, (relation, errors))| {
        let time = |part: usize| (part as f64 + 0.5) / errors.len() as f64 * end;
        let points = errors.iter().enumerate().map(|(part, error)| (time(part), libm::log10(*error)));
        // An error of 0 has no logarithm.
        let points = points.filter(|point| point.1.is_finite()).collect();
        let mark = if index < COLOURS { Mark::Line } else { Mark::Thin };
        Series::new(&found.equation(relation), index % COLOURS + 1, mark, points)
    });
    let series: Vec<Series> = series.filter(|series| !series.points.is_empty()).collect();
    let description =
        format!("Errors of the relations of {} along an orbit at eps = {eps}, against time", found.system);
    let plot = Plot::around(&description, ["t", "error of the relation"], series);
    let y = NumberLine { marks: TickKind::Powers, ..plot.y };
    Some(Picture::of(&Plot { sheet: look.sheet, y, ..plot }))
}
