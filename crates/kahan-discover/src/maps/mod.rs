//! The maps of a search: Kahan's map of a field modulo a prime, with fixed or generic parameters
//! and ε, on an invariant affine subspace, or on the level sets of an integral.

pub mod affine_subspace;
pub mod chart;
pub mod constrained;
pub mod map;
pub mod parametric_field;
pub mod search_field;
pub mod stepping;
