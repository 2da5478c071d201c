//! Rational integrals. They are found as quotients of polynomials that vanish on orbits
//! ([`search`]), as coefficients of these polynomials (`relation_coefficients`), and as quotients
//! of special elements P + cQ for an integral P/Q (`members`). Integrals from theorems and modified
//! Hamiltonians are candidates, too. The integrals are reconstructed over ℚ ([`reconstructed`]),
//! simplified and proved (`accepted`).

pub(crate) mod accepted;
pub mod composition;
pub mod independence;
pub(crate) mod limit;
pub(crate) mod members;
pub mod parity;
pub mod pencil;
pub mod reconstructed;
pub(crate) mod reduction;
pub(crate) mod relation_coefficients;
pub mod search;
