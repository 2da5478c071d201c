//! Errata of the paper.

use std::fmt;

/// The number of an erratum, for example `A5` or `B1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Erratum {
    /// A misprinted formula; the field holds its number.
    A(u8),
    /// A false sentence; the field holds its number.
    B(u8),
}

impl Erratum {
    pub(super) fn parse(text: &str) -> Option<Self> {
        let (kind, number) = text.split_at_checked(1)?;
        let number = number.parse().ok()?;
        match kind {
            "A" => Some(Erratum::A(number)),
            "B" => Some(Erratum::B(number)),
            _ => None,
        }
    }
}

impl fmt::Display for Erratum {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Erratum::A(number) => write!(f, "A{number}"),
            Erratum::B(number) => write!(f, "B{number}"),
        }
    }
}
