//! Errors in the construction of a chain.

use core::fmt;

/// An invalid number of sites, or invalid parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LatticeError {
    /// The number of sites is 0.
    NoSites,
    /// The equations divide by zero at these parameters, or a parameter or ε is not finite.
    Undefined,
    /// A site parameter has the wrong number of values.
    SiteParameter {
        /// The name of the parameter in the family.
        name: &'static str,
        /// The number of values.
        given: usize,
        /// The number of sites.
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
