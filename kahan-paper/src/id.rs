//! What a claim is called.

use std::fmt;

/// The stable name of a claim, part by part: `table3`, `e4`, `P23`, shown as `table3.e4.P23`.
///
/// The first parts say what the claim belongs to, the last is its own name there, which may have
/// dots of its own.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Id(Vec<String>);

impl Id {
    /// The name with these parts.
    pub fn of<'a>(parts: impl IntoIterator<Item = &'a str>) -> Self {
        Id(parts.into_iter().map(str::to_owned).collect())
    }

    /// Whether these are its first parts.
    #[must_use]
    pub fn begins_with(&self, parts: &[&str]) -> bool {
        self.0.len() >= parts.len() && self.0.iter().zip(parts).all(|(own, part)| own == part)
    }
}

impl fmt::Display for Id {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.join("."))
    }
}
