//! Sequences of numbers in the unit interval with direct access by index.

mod sobol;
mod uniform;

pub(crate) use sobol::Sobol;
pub(crate) use uniform::Uniform;
