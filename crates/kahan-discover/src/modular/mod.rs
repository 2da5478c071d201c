//! Arithmetic and linear algebra modulo a prime, and reconstruction over ℚ.
//!
//! The input consists of functions that can be evaluated modulo primes. The output consists of null
//! spaces, degrees, and rational functions over ℚ.

pub(crate) mod ansatz;
pub mod grading;
pub mod matrix;
pub mod modulus;
pub mod monomials;
pub mod reconstruction;
pub mod subspace;
pub mod thiele;
pub mod weights;
