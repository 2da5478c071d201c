//! The maps that a search looks at: Kahan's map of a field modulo a prime, with parameters and ε
//! that are fixed or generic, on an invariant affine subspace, or on the level sets of an integral.

pub mod affine_subspace;
pub mod chart;
pub mod constrained;
pub mod map;
pub mod parametric_field;
pub mod search_field;
pub mod stepping;
