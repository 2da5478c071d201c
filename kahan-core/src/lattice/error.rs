//! Errors that occur when a chain is created.

use core::fmt;

/// An error in the number of sites or in the parameters of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LatticeError {
    /// The number of sites is 0.
    NoSites,
    /// The equations divide by zero at these parameters, or a parameter or ε is not finite.
    Undefined,
    /// A site parameter has the wrong number of values.
    SiteParameter {
        /// The name of the parameter.
        name: &'static str,
        /// The number of values of the parameter.
        given: usize,
        /// The number of sites, which is the expected number of values.
        sites: usize,
    },
}

impl fmt::Display for LatticeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSites => write!(f, "a chain has at least one site"),
            Self::Undefined => {
                write!(
                    f,
                    "the equations have no value at these parameters and this eps: they divide by zero, or a number is not finite"
                )
            }
            Self::SiteParameter { name, given, sites } => {
                write!(f, "the parameter `{name}` of each site has {given} values for {sites} sites")
            }
        }
    }
}

impl core::error::Error for LatticeError {}
