//! Why there is no chain of so many sites.

use core::fmt;

/// Sites and parameters that do not fit each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LatticeError {
    /// A chain has at least one site.
    NoSites,
    /// The equations divide by zero at these parameters, or a parameter or ε is not finite.
    Undefined,
    /// A parameter that each site has is given for another number of sites.
    SiteParameter {
        /// Its name in the family.
        name: &'static str,
        /// For how many sites it is given.
        given: usize,
        /// How many there are.
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
