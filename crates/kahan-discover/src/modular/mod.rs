//! Arithmetic and linear algebra modulo a prime, and reconstruction over ℚ.
//!
//! Functions that can be evaluated modulo primes come in; null spaces, degrees, and rational
//! functions over ℚ go out.

pub(crate) mod ansatz;
pub mod grading;
pub mod matrix;
pub mod modulus;
pub mod monomials;
pub mod reconstruction;
pub mod subspace;
pub mod thiele;
pub mod weights;
