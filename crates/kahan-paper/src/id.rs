//! What a claim is called.

use std::fmt;

/// The stable name of a claim: `table3.e4.P23`, that is the entry P23 of the system E4 in Table 3.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Id(String);

impl Id {
    /// The name with these parts.
    pub fn of<const N: usize>(parts: [&str; N]) -> Self {
        Id(parts.join("."))
    }

    /// Whether these are its first parts.
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
