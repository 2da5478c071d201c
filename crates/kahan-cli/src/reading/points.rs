//! Points behind `--at`: their coordinates with commas, or a file that has a row for each of them.
//!
//! In: the text, and the names of the variables. Out: exact points. What begins there, this module
//! must not know.

use kahan_algebra::rational::Rational;

use super::number_file::{Entry, Numbers, is_number_file, read};
use super::values::number;
use crate::printing::Refusal;

/// An exact number of a file, `None` where there is none: an empty cell, or a float that is not
/// finite.
impl Entry for Option<Rational> {
    fn of_text(cell: &str) -> Option<Self> {
        if cell.is_empty() { Some(None) } else { Rational::typed(cell).map(Some) }
    }

    fn of_float(float: f64) -> Self {
        Rational::from_f64(float)
    }
}

/// The points that `--at` gives, at least one.
pub(crate) fn points(at: &str, states: &[String]) -> Result<Vec<Vec<Rational>>, Refusal> {
    if is_number_file(at) { of_file(at, states) } else { Ok(vec![coordinates(at, states)?]) }
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

/// A row a point: of named columns those of the variables, else a column a variable.
fn of_file(path: &str, states: &[String]) -> Result<Vec<Vec<Rational>>, Refusal> {
    let Numbers { names, sizes, values } = read::<Option<Rational>>(path, "--at")?;
    let refused = |why: String| Refusal::new(format!("--at: the file {path} {why}"));
    let named = |names: &[String], state: &String| {
        let mut places = (0..names.len()).filter(|place| names[*place] == *state);
        match (places.next(), places.next()) {
            (Some(place), None) => Ok(place),
            (Some(_), Some(_)) => Err(refused(format!("has two columns `{state}`; leave one of them out"))),
            (None, _) => Err(refused(format!("has no column `{state}`; it has {}", names.join(", ")))),
        }
    };
    let columns: Vec<usize> = match &names {
        Some(names) => states.iter().map(|state| named(names, state)).collect::<Result<_, _>>()?,
        None => (0..states.len()).collect(),
    };
    let width = match sizes[..] {
        [] | [0, _] => return Err(refused("has no rows; a row is a first point".to_owned())),
        [_, width] if names.is_some() || width == states.len() => width,
        _ => {
            let sizes: Vec<String> = sizes.iter().map(usize::to_string).collect();
            return Err(refused(format!(
                "has {} numbers, and first points are rows of {}: {}",
                sizes.join(" x "),
                states.len(),
                states.join(",")
            )));
        }
    };
    let point = |(row, values): (usize, &[Option<Rational>])| {
        let coordinate = |(column, state): (&usize, &String)| {
            values[*column].clone().ok_or_else(|| {
                refused(format!("has no number for {state} in row {}, and a first point needs each", row + 1))
            })
        };
        columns.iter().zip(states).map(coordinate).collect()
    };
    values.chunks_exact(width).enumerate().map(point).collect()
}
