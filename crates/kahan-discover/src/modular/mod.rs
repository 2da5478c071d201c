//! Arithmetic and linear algebra modulo a prime, and reconstruction over ℚ.

pub(crate) mod ansatz;
pub mod grading;
pub mod matrix;
pub mod modulus;
pub mod monomials;
pub mod reconstruction;
pub mod subspace;
pub mod thiele;
pub mod weights;
