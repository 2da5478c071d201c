//! Lists the finished, missing and unusable parts of a sweep.

use std::path::Path;

use crate::plan::Plan;

use super::Part;

#[derive(Clone, Debug, Default)]
pub(crate) struct Status {
    pub(crate) done: u64,
    pub(crate) missing: Vec<u64>,
    /// The reasons why existing parts are unusable.
    pub(crate) refused: Vec<String>,
}

/// Checks every part, and calls `each` after each of them.
pub(crate) fn status(plan: &Plan, folder: &Path, mut each: impl FnMut()) -> Status {
    let mut status = Status::default();
    for index in 0..plan.parts() {
        let part = Part::of(plan, index, folder);
        match part.exists().then(|| part.open_checked()) {
            None => status.missing.push(index),
            Some(Ok(_)) => status.done += 1,
            Some(Err(why)) => status.refused.push(why.to_string()),
        }
        each();
    }
    status
}

/// Writes numbers in increasing order as ranges: 0-3, 7, 9-12.
pub(crate) fn ranges(numbers: &[u64]) -> String {
    let text = |run: &[u64]| match run {
        [first, .., last] => format!("{first}-{last}"),
        alone => alone[0].to_string(),
    };
    let runs = numbers.chunk_by(|one, next| one + 1 == *next).map(text);
    runs.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::ranges;

    #[test]
    fn neighbours_are_one_range() {
        assert_eq!(ranges(&[0, 1, 2, 3, 7, 9, 10]), "0-3, 7, 9-10");
        assert_eq!(ranges(&[]), "");
    }
}
