//! Transcendental functions in two precisions: `f64`, and 256 bits as [`Float256`].
//!
//! Γ, ψ, ratios of Γ, elliptic integrals, Jacobi's elliptic functions and theta functions accept
//! every [`Real`]. The documented error bounds in `f64` were measured against [`Float256`] and are
//! tested. Undefined arguments do not panic: without a real value, the result is NaN or infinite.

mod bernoulli;
mod elliptic;
mod float;
mod float256;
mod gamma;
mod gamma_ratio;
mod jacobi;
mod quadrature;
mod real;
mod tail;
mod theta;

pub use elliptic::{Modulus, elliptic_f, elliptic_k};
pub use float256::{Float256, ParsePreciseError};
pub use gamma::{digamma, gamma};
pub use gamma_ratio::{centered_digamma_difference, centered_gamma_ratio, gamma_ratio};
pub use jacobi::{Jacobi, jacobi};
pub use quadrature::{Integral, integrate};
pub use real::Real;
pub(crate) use tail::{asymptotic_start, digamma_product_tail, gamma_product_tail};
pub use theta::{Theta, theta};
