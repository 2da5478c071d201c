//! The numbers of the paper's errata.

use std::fmt;

/// The number of an erratum: `A5` or `B1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Erratum {
    /// A formula is misprinted.
    A(u8),
    /// A sentence does not hold.
    B(u8),
}

impl fmt::Display for Erratum {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Erratum::A(number) => write!(f, "A{number}"),
            Erratum::B(number) => write!(f, "B{number}"),
        }
    }
}
