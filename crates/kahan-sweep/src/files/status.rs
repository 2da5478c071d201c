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
    pub(crate) refused: Vec<(u64, String)>,
}

/// Looks at every part.
pub(crate) fn status(plan: &Plan, folder: &Path, mut each: impl FnMut()) -> Status {
    let hash = plan.hash();
    let mut status = Status::default();
    for index in 0..plan.parts() {
        let part = Part::of(plan, &hash, index, folder);
        if !part.exists() {
            status.missing.push(index);
        } else {
            match part.checked() {
                Ok(_) => status.done += 1,
                Err(why) => status.refused.push((index, why.reason())),
            }
        }
        each();
    }
    status
}

/// Numbers as ranges: 0-3, 7, 9-12.
pub(crate) fn ranges(numbers: &[u64]) -> String {
    let mut ranges: Vec<(u64, u64)> = Vec::new();
    for &number in numbers {
        match ranges.last_mut() {
            Some((_, last)) if *last + 1 == number => *last = number,
            _ => ranges.push((number, number)),
        }
    }
    let texts = ranges.iter().map(
        |(first, last)| {
            if first == last { first.to_string() } else { format!("{first}-{last}") }
        },
    );
    texts.collect::<Vec<_>>().join(", ")
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
