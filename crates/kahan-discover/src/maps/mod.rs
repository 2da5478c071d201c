//! The maps of a search: Kahan's map modulo a prime, and its restrictions to affine subspaces and
//! level sets of integrals.

pub mod affine_subspace;
pub mod chart;
pub mod constrained;
pub mod map;
pub mod modular_step;
pub mod parametric_field;
pub mod search_field;
