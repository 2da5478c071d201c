//! What a field does not claim.

use core::fmt;

use crate::DimensionError;

/// Why a claim of a field has no value.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ClaimError {
    /// The field claims no density.
    NoDensity,
    /// The field claims no bracket of this name.
    NoBracket {
        /// The name that was asked for.
        name: String,
        /// Those that there are.
        brackets: Vec<String>,
    },
    /// An argument does not fit.
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
