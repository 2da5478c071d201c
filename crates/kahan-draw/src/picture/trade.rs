//! The work–precision picture: price against error, a line for each order in doubles, small dots
//! for other scalars and for compensation, the front above all.

use kahan_core::Precision;
use kahan_study::trade::{Measured, Traded};

use super::{Look, Picture};
use crate::plot::{Mark, NumberLine, Plot, Series, Sheet, Side, Theme};

/// What the picture is usually drawn on.
#[must_use]
pub fn trade_sheet() -> Sheet {
    Sheet::page(720, 480)
}

/// Every setting that was measured.
#[must_use]
pub fn trade(traded: &Traded, look: &Look) -> Picture {
    let what = traded.error_name();
    let shown: Vec<&Measured> = traded.settings.iter().filter(is_shown).collect();
    let points = |chosen: &dyn Fn(&Measured) -> bool| -> Vec<(f64, f64)> {
        shown.iter().filter(|setting| chosen(setting)).map(|measured| place(measured)).collect()
    };
    let mut series = Vec::new();
    let mut schemes: Vec<_> = shown.iter().map(|measured| measured.setting.scheme()).collect();
    schemes.sort_by_key(|scheme| (scheme.order(), scheme.precision.name(), scheme.compensated));
    schemes.dedup();
    for scheme in schemes {
        // One label an order, at the line of plain doubles; other scalars of the order share
        // its colour.
        let (label, mark) = match (scheme.precision, scheme.compensated) {
            (Precision::Double, false) => (format!("order {}", scheme.order()), Mark::Both),
            (Precision::DoubleDouble, false) => (format!("order {}, dd", scheme.order()), Mark::Both),
            _ => (String::new(), Mark::Points),
        };
        let colour = ORDER_COLOURS[scheme.order() as usize / 2 % ORDER_COLOURS.len()];
        let mut points = points(&|measured| measured.setting.scheme() == scheme);
        points.sort_by(|one, other| one.0.total_cmp(&other.0));
        series.push(Series::new(&label, colour, mark, points));
    }
    series.push(Series::new("", 6, Mark::Line, points(&|measured| measured.on_front)));
    if let Some(choice) = traded.choice() {
        let points = points(&|measured| measured == choice);
        series.push(Series { side: Side::Left, ..Series::new("choice", 4, Mark::Dots, points) });
    }
    let level = (traded.scene.tolerance().log10(), "tolerance".to_owned());
    // A column in print has no room for more.
    let across = match look.sheet.theme {
        Theme::Paper => "log10 of nanoseconds per unit of time",
        _ => "log10 of nanoseconds per unit of time; small dots: other scalars than f64",
    };
    let places = || shown.iter().map(|measured| place(measured));
    let plot = Plot {
        description: format!(
            "{}: {what} against nanoseconds per unit of simulated time, both as decimal logarithms",
            traded.title()
        ),
        sheet: look.sheet,
        x: NumberLine::around(across, places().map(|(x, _)| x)),
        y: NumberLine::around(&format!("log10 of {what}"), places().map(|(_, y)| y).chain([level.0])),
        levels: vec![level],
        series,
    };
    Picture::of(&plot)
}

/// The colour of each order: 2, 4, 6, 8.
const ORDER_COLOURS: [usize; 5] = [6, 1, 2, 5, 3];

fn place(measured: &Measured) -> (f64, f64) {
    (measured.nanoseconds_per_unit_time.log10(), measured.error().log10())
}

/// An error of 0 has no place on a logarithmic axis, nor has one that is infinite.
fn is_shown(measured: &&Measured) -> bool {
    let (x, y) = place(measured);
    x.is_finite() && y.is_finite()
}
