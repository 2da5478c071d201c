//! What is there of a sweep, and what is missing.

use std::path::Path;

use crate::plan::Plan;

use super::Part;

/// What is there.
#[derive(Clone, Debug, Default)]
pub(crate) struct Status {
    /// Parts that are whole.
    pub(crate) done: u64,
    /// Parts that are not there.
    pub(crate) missing: Vec<u64>,
    /// Why each part that is there cannot be used.
    pub(crate) refused: Vec<String>,
}

/// Looks at every part.
pub(crate) fn status(plan: &Plan, folder: &Path, mut each: impl FnMut()) -> Status {
    let mut status = Status::default();
    for index in 0..plan.parts() {
        let part = Part::of(plan, index, folder);
        match part.exists().then(|| part.checked()) {
            None => status.missing.push(index),
            Some(Ok(_)) => status.done += 1,
            Some(Err(why)) => status.refused.push(why.to_string()),
        }
        each();
    }
    status
}

/// Numbers as ranges: 0-3, 7, 9-12.
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
