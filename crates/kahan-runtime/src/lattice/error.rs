//! Why there is no chain of so many sites.

use core::fmt;

use crate::ParameterError;

/// Sites and parameters that a chain cannot have.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LatticeError {
    /// A chain has at least one site.
    NoSites,
    /// The values are not those of the parameters.
    Parameter(
        /// What is wrong with them.
        ParameterError,
    ),
    /// ε is not a finite number.
    Eps,
    /// A parameter has too few or too many numbers.
    Values {
        /// Its name.
        name: String,
        /// How many it has.
        found: usize,
        /// How many sites there are; `None` for a parameter that a chain has once.
        sites: Option<usize>,
    },
}

impl fmt::Display for LatticeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSites => write!(f, "a chain has at least one site"),
            Self::Parameter(error) => error.fmt(f),
            Self::Eps => write!(f, "eps is not a finite number"),
            Self::Values { name, found, sites: Some(sites) } => {
                write!(f, "the parameter `{name}` has {found} numbers; give one, or {sites}, one a site")
            }
            Self::Values { name, found, sites: None } => {
                write!(f, "the parameter `{name}` has {found} numbers; give one, as the chain has it once")
            }
        }
    }
}

impl core::error::Error for LatticeError {}

impl From<ParameterError> for LatticeError {
    fn from(error: ParameterError) -> Self {
        Self::Parameter(error)
    }
}
