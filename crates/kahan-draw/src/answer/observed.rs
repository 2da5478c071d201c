//! Tables and sentences for an observed orbit.

use kahan_core::observe::Extremes;
use kahan_study::{End, Observable, Observed, ObservedValue};

use crate::document::Table;

/// Returns a table for each group of requested observables.
#[must_use]
pub fn observed(observed: &Observed) -> Vec<Table> {
    let row = |cells: &[&str]| cells.iter().map(|cell| (*cell).to_owned()).collect::<Vec<_>>();
    let mut exponents = vec![row(&["Lyapunov exponent", "value", "still moves by"])];
    let mut indicators = vec![row(&["indicator", "value"])];
    let mut variables = vec![row(&["variable"])];
    variables.extend(observed.variables.iter().map(|name| row(&[name])));
    let mut drifts = vec![row(&["integral", "greatest drift", "final drift"])];
    let mut of_variables = |headings: &[&str], cells: Vec<Vec<String>>| {
        let cells = [row(headings)].into_iter().chain(cells);
        variables.iter_mut().zip(cells).for_each(|(row, cells)| row.extend(cells));
    };
    let mut found: Vec<_> =
        Observable::ALL.iter().filter_map(|one| Some((*one, observed.of(*one)?))).collect();
    found.sort_by_key(|(_, seen)| matches!(seen, ObservedValue::Turns(_)));
    for (observable, seen) in found {
        match seen {
            ObservedValue::Point(point) => {
                let heading = if observable == Observable::Last { "last" } else { observable.name() };
                of_variables(&[heading], point.iter().map(|value| vec![number(*value)]).collect());
            }
            ObservedValue::Drift(found) => {
                let rows = observed.integrals.iter().zip(found);
                drifts.extend(
                    rows.map(|(name, drift)| vec![name.clone(), short(drift.max), short(drift.last)]),
                );
            }
            ObservedValue::Extrema(extrema) => {
                let ends = |of: &Option<Extremes<f64>>| match of {
                    Some(of) => vec![number(of.least), number(of.greatest)],
                    None => vec![String::new(); 2],
                };
                of_variables(&["least", "greatest"], extrema.iter().map(ends).collect());
            }
            ObservedValue::Exponent(one) => {
                exponents.push(vec![
                    "largest".to_owned(),
                    known_digits(one.value, one.error),
                    short(one.error),
                ]);
            }
            ObservedValue::Spectrum(all) => {
                for (k, one) in all.iter().enumerate() {
                    let value = known_digits(one.value, one.error);
                    exponents.push(vec![(k + 1).to_string(), value, short(one.error)]);
                }
                let sum: f64 = all.iter().map(|exponent| exponent.value).sum();
                exponents.push(vec!["sum".to_owned(), number(sum), String::new()]);
            }
            ObservedValue::Number(value) if observable == Observable::LogDet => {
                exponents.push(vec!["mean log |det J|".to_owned(), number(*value), String::new()]);
            }
            ObservedValue::Number(value) => {
                indicators.push(vec![observable.name().to_uppercase(), number(*value)]);
            }
            ObservedValue::Turns(turns) => {
                let turns = turns
                    .iter()
                    .map(|turns| vec![known_digits(turns.value, turns.error), short(turns.error)]);
                of_variables(&["turns a step", "error"], turns.collect());
            }
            ObservedValue::Step(_) | ObservedValue::Passed(_) => {}
        }
    }
    let tables = [
        ("Lyapunov exponents, per unit of time", exponents),
        ("Indicators", indicators),
        ("Extremes and rotation", variables),
        ("Drift of the integrals", drifts),
    ];
    let tables = tables.into_iter().filter(|(_, rows)| rows.len() > 1 && rows[0].len() > 1);
    tables.map(|(caption, rows)| Table { caption, rows }).collect()
}

/// Describes the errors of Lyapunov exponents. Returns `None` if no exponent has a finite error.
#[must_use]
pub fn convergence(observed: &Observed) -> Option<String> {
    let largest = |observable| match observed.of(observable)? {
        ObservedValue::Exponent(one) => Some(one),
        ObservedValue::Spectrum(all) => all.first(),
        _ => None,
    };
    let largest = largest(Observable::Lyapunov).or_else(|| largest(Observable::Spectrum))?;
    let chaos = match largest.value.abs() <= largest.error {
        true => " 0 lies within that of the largest exponent, which so shows no chaos so far.",
        false => "",
    };
    largest.error.is_finite().then(|| {
        format!(
            "“Still moves by” is the distance of a value from what the first eighth to quarter of the steps gave; the value has the \
             digits that this leaves.{chaos}"
        )
    })
}

/// Explains why an orbit ended before the requested number of steps.
#[must_use]
pub fn out_of_range(observed: &Observed) -> Option<String> {
    let Observed { system, steps, end, why, .. } = observed;
    if let Some(why) = why {
        return Some(format!("the orbit of {system} {why}; what is said is of the steps up to there"));
    }
    match end {
        End::Escaped(_) => Some(format!(
            "the orbit of {system} has escaped at step {steps}; what is said is of the steps up to there"
        )),
        end if end.is_early() => Some(format!(
            "the orbit of {system} leaves the range of f64 at step {}: a pole (det A = 0) or too large numbers; what is said is of \
             the steps before",
            steps + 1
        )),
        _ => None,
    }
}

/// Writes eight significant digits, or `-` for NaN.
fn number(value: f64) -> String {
    if value.is_nan() {
        return "-".to_owned();
    }
    match value.abs() {
        0.0 => "0".to_owned(),
        size if (1e-3..1e6).contains(&size) => {
            let before = libm::log10(size).floor().max(0.0) as usize;
            format!("{value:.0$}", 8 - before.min(7))
        }
        _ => format!("{value:.7e}"),
    }
}

/// Rounds the value to the decimal place of the first nonzero digit of `error`.
fn known_digits(value: f64, error: f64) -> String {
    let places = -libm::log10(error).floor();
    if !(value.is_finite() && (..=8.0).contains(&places)) {
        return number(value);
    }
    let shown = format!("{value:.0$}", places.max(0.0) as usize);
    if shown.parse() == Ok(0.0) { shown.trim_start_matches('-').to_owned() } else { shown }
}

fn short(value: f64) -> String {
    if value.is_nan() { "-".to_owned() } else { format!("{value:.1e}") }
}
