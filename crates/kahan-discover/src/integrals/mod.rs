//! Rational integrals: from null vectors of relations ([`search`]) over their coefficients
//! (`relation_coefficients`) and special members of a pencil (`members`) to reconstructed,
//! simplified, proved and independent ones ([`reconstructed`], `accepted`).

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
