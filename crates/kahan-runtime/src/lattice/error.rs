//! Errors in the sites, ε and parameters of a chain.

use core::fmt;

use crate::ParameterError;

/// An error in the sites, ε or parameters of a chain.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LatticeError {
    /// The requested number of sites is 0.
    NoSites,
    /// A parameter is unknown, missing, given twice or not finite, or causes a division by zero.
    Parameter(
        /// The error in the parameters.
        ParameterError,
    ),
    /// ε is not a finite number.
    Eps,
    /// A parameter has a wrong number of values.
    Values {
        /// The name of the parameter.
        name: String,
        /// The number of values found.
        found: usize,
        /// The number of values expected: one for each site; `None` if a single value is expected.
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
