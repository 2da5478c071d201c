//! Numbers from the unit interval that an index gives directly: nothing is drawn before it.

mod sobol;
mod uniform;

pub(crate) use sobol::Sobol;
pub(crate) use uniform::Uniform;
