//! Rational integrals. The search finds integrals as relations of orbits ([`search`]), coefficients
//! of relations (`relation_coefficients`), and special elements of pencils (`members`). The
//! integrals are reconstructed over ℚ ([`reconstructed`]), simplified and proved (`accepted`).

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
