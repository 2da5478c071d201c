//! The diagram of the errors of integrator settings against computing time. Lines join settings of
//! equal order and precision, `f64` or `Dd`. Compensated and `f32` settings are small dots.

use kahan_dynamics::{Need, Precision};
use kahan_study::trade::{Measured, Traded};

use super::{Picture, PictureOptions};
use crate::plot::{Canvas, Mark, NumberLine, Plot, Series, TickKind};

/// Returns the default canvas of a picture by `trade`.
#[must_use]
pub fn trade_canvas() -> Canvas {
    Canvas::page(720, 480)
}

/// Draws all settings whose error is at most 10.
#[must_use]
pub fn trade(traded: &Traded, look: &PictureOptions) -> Picture {
    const LARGEST_ERROR: f64 = 10.0;

    let what = traded.error_name();
    // An error of 0 has no logarithm.
    let shown = traded.settings.iter().filter(|measured| place(measured).1.is_finite());
    let (shown, beyond): (Vec<&Measured>, Vec<_>) =
        shown.partition(|measured| measured.error() <= LARGEST_ERROR);
    let points = |chosen: &dyn Fn(&Measured) -> bool| -> Vec<(f64, f64)> {
        let mut points: Vec<_> =
            shown.iter().filter(|setting| chosen(setting)).map(|measured| place(measured)).collect();
        points.sort_by(|one, other| one.0.total_cmp(&other.0));
        points
    };
    let mut schemes: Vec<_> = shown.iter().map(|measured| measured.setting.scheme()).collect();
    schemes.sort_by_key(|scheme| {
        (scheme.precision != Precision::Double, scheme.order(), scheme.precision.name(), scheme.compensated)
    });
    schemes.dedup();
    let mut series = vec![Series::new("front", 6, Mark::Band, points(&|measured| measured.on_front))];
    let is_line = |measured: &Measured| {
        let scheme = measured.setting.scheme();
        !scheme.compensated && matches!(scheme.precision, Precision::Double | Precision::DoubleDouble)
    };
    series.push(Series::new("f32 or compensated", 6, Mark::Points, points(&|measured| !is_line(measured))));
    for scheme in schemes {
        let (label, mark) = match (scheme.precision, scheme.compensated) {
            (Precision::Double, false) => (format!("order {}", scheme.order()), Mark::Both),
            (Precision::DoubleDouble, false) => (format!("order {}, dd", scheme.order()), Mark::Rings),
            _ => continue,
        };
        let colour = (scheme.order() as usize / 2).clamp(1, 5);
        series.push(Series::new(
            &label,
            colour,
            mark,
            points(&|measured| measured.setting.scheme() == scheme),
        ));
    }
    let tolerance = libm::log10(traded.scene.tolerance());
    let x = NumberLine::around("time per unit of t, ns", shown.iter().map(|measured| place(measured).0));
    let errors = shown.iter().map(|measured| place(measured).1);
    let relative = match traded.scene.need() {
        Need::Trajectory => "relative error",
        Need::Integrals => "relative drift",
    };
    let y = NumberLine::around(relative, errors.chain([tolerance]));
    series.push(Series::new("tolerance", 6, Mark::Level, vec![(x.low, tolerance), (x.high, tolerance)]));
    if let Some(choice) = traded.choice() {
        series.push(Series::new("choice", 3, Mark::Ring, points(&|measured| measured == choice)));
    }
    series.retain(|series| !series.points.is_empty());
    let note = match beyond.len() {
        0 => String::new(),
        count => format!("not shown: {count} with errors above {LARGEST_ERROR}"),
    };
    let [x, y] = [x, y].map(|line| NumberLine { marks: TickKind::Powers, ..line });
    Picture::of(&Plot {
        description: format!("{}: {what} against nanoseconds per unit of simulated time", traded.title()),
        sheet: look.sheet,
        x,
        y,
        series,
        note,
    })
}

fn place(measured: &Measured) -> (f64, f64) {
    (libm::log10(measured.nanoseconds_per_unit_time), libm::log10(measured.error()))
}
