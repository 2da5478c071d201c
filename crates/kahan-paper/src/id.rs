//! Identifiers of claims.

use std::fmt;

/// A stable identifier. For example, `table3.e4.P23` is the entry P23 of the system E4 in Table 3.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Id(String);

impl Id {
    /// Makes an identifier from its parts.
    pub fn of<const N: usize>(parts: [&str; N]) -> Self {
        Id(parts.join("."))
    }

    /// Returns whether the identifier begins with these parts.
    #[must_use]
    pub fn begins_with(&self, parts: &[&str]) -> bool {
        let rest = self.0.strip_prefix(&parts.join("."));
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
    }
}

impl fmt::Display for Id {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}
