//! Constant Poisson structures, which give modified Hamiltonians, and invariant brackets of the
//! map.

pub(crate) mod brackets;
pub mod hamiltonian;
pub(crate) mod modified;
pub mod structure;

pub use brackets::Bracket;
