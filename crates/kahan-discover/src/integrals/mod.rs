//! Rational integrals. They are found as quotients of relations of orbits ([`search`]), as
//! coefficients of relations (`relation_coefficients`), and as quotients of special elements of
//! pencils (`members`). The integrals are reconstructed over ℚ ([`reconstructed`]), simplified and
//! proved (`accepted`).

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
