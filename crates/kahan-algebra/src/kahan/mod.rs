//! Kahan's objects as exact polynomials, derived from a checked field; one object in each file.
//!
//! Row i of A x̃ = b is multiplied by its denominator qᵢ, so all objects are polynomials: Â =
//! diag(q)·A, b̂ = diag(q)·b, D̂ = det Â = ∏q · det A.

mod bilinear;
mod matrix;
mod minors;
mod rational_map;

pub use bilinear::{bilinear_form, polarization};
pub(crate) use matrix::{SparseRows, dense, matrix_of, pattern};
pub use matrix::{field_jacobian, scaled_matrix, scaled_rhs};
pub use minors::maximal_minors;
pub use rational_map::{RationalMap, Reduced, TERM_BUDGET};
