//! Points given by `--at`: coordinates separated by commas, or a file with a row for each point.

use std::fs;
use std::path::Path;

use kahan_algebra::rational::Rational;
use kahan_study::Study;
use kahan_study::columns::{ExpectedColumns, OtherColumns};
use kahan_study::number_file::{FileNumber, Numbers};

use super::values::number;
use crate::printing::UsageError;

pub(crate) fn is_number_file(text: &str) -> bool {
    let ending = Path::new(text).extension().and_then(|ending| ending.to_str());
    ending.is_some_and(|ending| ending == "npy" || ending == "csv")
}

/// Reads a file of numbers. Error messages name the option `option`.
pub(super) fn read<V: FileNumber>(path: &str, option: &str) -> Result<Numbers<V>, UsageError> {
    let refused = |why: String| UsageError::new(format!("{option}: cannot read the file {path}: {why}"));
    let bytes = fs::read(path).map_err(|error| refused(error.to_string()))?;
    Numbers::of(path, &bytes).map_err(refused)
}

/// Returns the points of `--at`, or else the point in the text of the field.
pub(crate) fn points(at: Option<&str>, study: &Study) -> Result<Vec<Vec<Rational>>, UsageError> {
    let states = study.coordinates();
    let Some(at) = at else {
        let wanted =
            || UsageError::new(format!("from which point? add --at {}, with numbers", states.join(",")));
        return study.start().map(|start| vec![start]).ok_or_else(wanted);
    };
    if !is_number_file(at) {
        return Ok(vec![coordinates(at, states)?]);
    }
    let points =
        read(at, "--at")?.points(&ExpectedColumns::new(states, study.parameters(), OtherColumns::Refused));
    points.map_err(|why| UsageError::new(format!("--at: the file {at} {why}")))
}

/// Returns the only point of `--at`. Without `--at`, returns the point in the text of the field.
pub(crate) fn point(at: Option<&str>, study: &Study) -> Result<Vec<Rational>, UsageError> {
    single_point(points(at, study)?, at)
}

/// Reads the first point of `--at`, and the names of its coordinates if a file has them.
pub(super) fn first_point(at: &str) -> Option<(Vec<Rational>, Vec<String>)> {
    if is_number_file(at) {
        let rows = read::<Option<Rational>>(at, "--at").ok()?;
        let width = rows.sizes.last().copied().unwrap_or_default();
        let (first, names) = (rows.values.get(..width)?, rows.names.unwrap_or_default());
        // Columns of text, such as `ended` in tables of `kahan orbit`, are no states.
        let given =
            first.iter().enumerate().filter_map(|(k, value)| Some((value.clone()?, names.get(k).cloned())));
        let (point, names): (Vec<_>, Vec<_>) = given.unzip();
        return Some((point, names.into_iter().flatten().collect()));
    }
    let first = at.split("..").next()?;
    Some((first.split(',').map(|part| number(part, "--at").ok()).collect::<Option<_>>()?, Vec::new()))
}

pub(super) fn single_point(
    mut points: Vec<Vec<Rational>>,
    at: Option<&str>,
) -> Result<Vec<Rational>, UsageError> {
    match (points.pop(), points.len()) {
        (Some(point), 0) => Ok(point),
        (_, others) => Err(UsageError::new(format!(
            "--at: the file {} has {} rows, and here one point is asked for; write its coordinates, or a file of one row",
            at.unwrap_or_default(),
            others + 1
        ))),
    }
}

fn coordinates(text: &str, states: &[String]) -> Result<Vec<Rational>, UsageError> {
    let parts: Vec<&str> = text.split(',').collect();
    if Path::new(text).is_file() && parts.iter().any(|part| number(part, "--at").is_err()) {
        return Err(UsageError::new(format!(
            "--at: the name of a file of points ends in .csv or .npy, and {text} does not; its rows are numbers with commas between them"
        )));
    }
    if parts.len() != states.len() {
        let (expected, given, names) = (states.len(), parts.len(), states.join(","));
        let plural = if expected == 1 { "" } else { "s" };
        return Err(UsageError::new(format!(
            "--at: {expected} coordinate{plural} {names} expected, {given} given"
        )));
    }
    parts.iter().zip(states).map(|(part, state)| number(part, &format!("--at, coordinate {state}"))).collect()
}
