//! The maps of a search: Kahan's map modulo a prime, with fixed or generic parameters and ε. Some
//! maps are restricted to an affine subspace or to a level set of an integral.

pub mod affine_subspace;
pub mod chart;
pub mod constrained;
pub mod map;
pub mod modular_step;
pub mod parametric_field;
pub mod search_field;
