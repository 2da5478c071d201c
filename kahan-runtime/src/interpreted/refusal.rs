//! Why a system cannot be interpreted.

/// Why a system cannot be interpreted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CannotInterpret {
    /// It has another number of variables.
    Dimension {
        /// The system's.
        found: usize,
        /// The type's.
        expected: usize,
    },
    /// It has another number of parameters than there are values.
    Parameters {
        /// The system's.
        found: usize,
        /// The values.
        given: usize,
    },
    /// At these parameter values the field divides by zero.
    Undefined,
}

impl core::fmt::Display for CannotInterpret {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Dimension { found, expected } => {
                write!(f, "the system has {found} variables where {expected} were expected")
            }
            Self::Parameters { found, given } => {
                write!(f, "the system has {found} parameters, but {given} values were given")
            }
            Self::Undefined => write!(f, "the field divides by zero at these parameter values"),
        }
    }
}

impl core::error::Error for CannotInterpret {}
