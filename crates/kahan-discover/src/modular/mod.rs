//! Arithmetic modulo a prime, linear algebra there, and the way back to ℚ.
//!
//! In: functions that can be evaluated modulo primes. Out: null spaces, degrees, and rational
//! functions with rational coefficients.

pub(crate) mod ansatz;
pub mod grading;
pub mod matrix;
pub mod modulus;
pub mod monomials;
pub mod reconstruction;
pub mod subspace;
pub mod thiele;
pub mod weights;
