//! The error for claims that a field does not make.

use core::fmt;

use crate::DimensionError;

/// The reason why a claim of a field cannot be evaluated.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ClaimError {
    /// The field claims no density.
    NoDensity,
    /// The field claims no bracket of this name.
    NoBracket {
        /// The requested name.
        name: String,
        /// The names of the field's brackets.
        brackets: Vec<String>,
    },
    /// An argument has a wrong number of entries.
    Dimension(DimensionError),
}

impl From<DimensionError> for ClaimError {
    fn from(error: DimensionError) -> Self {
        Self::Dimension(error)
    }
}

impl fmt::Display for ClaimError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoDensity => f.write_str(
                "the field claims no density without `when`; write `density NAME = …;` in its text",
            ),
            Self::NoBracket { name, brackets } if brackets.is_empty() => {
                write!(f, "the field claims no bracket `{name}`; write `bracket {name} {{ … }}` in its text")
            }
            Self::NoBracket { name, brackets } => {
                write!(f, "the field claims no bracket `{name}`; it has {}", brackets.join(", "))
            }
            Self::Dimension(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for ClaimError {}
