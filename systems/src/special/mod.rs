//! Real numbers with transcendental functions, in the machine's precision and in 256 bits.
//!
//! In: [`Real`], what an explicit solution asks of a number; [`Precise`], such a number of 77
//! decimal digits. Out: Γ, ψ, ratios of Γ, elliptic integrals, Jacobi's elliptic functions and
//! theta functions, each once, for both. For `f64` a well-kept library computes what it computes
//! well; the bounds in units of the last place stated there were measured against [`Precise`] and
//! are tested. Nothing here panics on a value: what has no real value is "not a number" in either
//! type.

mod bernoulli;
mod elliptic;
mod float;
mod gamma;
mod gamma_ratio;
mod jacobi;
mod precise;
mod quadrature;
mod real;
mod tail;
mod theta;

pub use elliptic::{Modulus, elliptic_f, elliptic_k};
pub use gamma::{digamma, gamma};
pub use gamma_ratio::{centered_digamma_difference, centered_gamma_ratio, gamma_ratio};
pub use jacobi::{Jacobi, jacobi};
pub use precise::{ParsePreciseError, Precise};
pub use quadrature::{Integral, integrate};
pub use real::Real;
pub(crate) use tail::{asymptotic_start, digamma_product_tail, gamma_product_tail};
pub use theta::{Theta, theta};
