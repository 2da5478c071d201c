//! Rational integrals. The search finds them as null vectors of relations ([`search`]), among
//! coefficients of relations (`relation_coefficients`), and as special elements P + cQ of pencils
//! (`members`). The integrals are reconstructed over ℚ ([`reconstructed`]), simplified, proved, and
//! tested for independence (`accepted`).

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
