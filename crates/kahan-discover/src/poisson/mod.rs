//! Poisson structures: constant ones with modified Hamiltonians, and invariant brackets.

pub(crate) mod brackets;
pub mod hamiltonian;
pub(crate) mod modified;
pub mod structure;

pub use brackets::Bracket;
