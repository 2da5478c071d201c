//! Points behind `--at`: their coordinates with commas, or a file that has a row for each of them.
//!
//! In: the text, and the names of the variables. Out: exact points. What begins there, this module
//! must not know.

use kahan_algebra::rational::Rational;

use super::number_file::{is_number_file, read};
use super::values::number;
use crate::printing::Refusal;

/// The points that `--at` gives, at least one.
pub(crate) fn points(at: &str, states: &[String]) -> Result<Vec<Vec<Rational>>, Refusal> {
    if !is_number_file(at) {
        return Ok(vec![coordinates(at, states)?]);
    }
    let points = read(at, "--at")?.points(states);
    points.map_err(|why| Refusal::new(format!("--at: the file {at} {why}")))
}

/// The one point that `--at` gives.
pub(crate) fn point(at: &str, states: &[String]) -> Result<Vec<Rational>, Refusal> {
    only(points(at, states)?, at)
}

/// The one among the points that `--at` gives.
pub(super) fn only(mut points: Vec<Vec<Rational>>, at: &str) -> Result<Vec<Rational>, Refusal> {
    match (points.pop(), points.len()) {
        (Some(point), 0) => Ok(point),
        (_, others) => Err(Refusal::new(format!(
            "--at: the file {at} has {} rows, and here one point is asked for; write its coordinates, or a file of one row",
            others + 1
        ))),
    }
}

/// One coordinate a state.
fn coordinates(text: &str, states: &[String]) -> Result<Vec<Rational>, Refusal> {
    let parts: Vec<&str> = text.split(',').collect();
    if parts.len() != states.len() {
        let (expected, plural) = (states.len(), if states.len() == 1 { "" } else { "s" });
        let names = states.join(",");
        return Err(Refusal::new(format!(
            "--at: {expected} coordinate{plural} {names} expected, {} given",
            parts.len()
        )));
    }
    parts.iter().zip(states).map(|(part, state)| number(part, &format!("--at, coordinate {state}"))).collect()
}
