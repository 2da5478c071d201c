//! Derives the objects of Kahan's method as exact polynomials.
//!
//! Row i of A x̃ = b is multiplied by the denominator qᵢ of component i. All objects are then
//! polynomials: Â = diag(q)·A, b̂ = diag(q)·b, and D̂ = det Â = ∏q · det A.

mod bilinear;
mod matrix;
mod minors;
mod rational_map;

pub use bilinear::{bilinear_form, polarization};
pub(crate) use matrix::{SparseRows, dense, matrix_of, pattern};
pub use matrix::{field_jacobian, scaled_matrix, scaled_rhs};
pub use minors::maximal_minors;
pub use rational_map::{RationalMap, Reduced, TERM_BUDGET};
