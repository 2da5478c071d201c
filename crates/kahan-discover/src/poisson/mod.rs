//! Poisson structures: the constant one of the field with its modified Hamiltonians, and brackets
//! that the map preserves.

pub(crate) mod brackets;
pub mod hamiltonian;
pub(crate) mod modified;
pub mod structure;

pub use brackets::Bracket;
