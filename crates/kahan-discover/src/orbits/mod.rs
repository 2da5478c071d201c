//! Searches along orbits: polynomial relations, numbers of integrals, growth of the degrees of
//! iterates, and Hirota–Kimura bases.

pub mod basis;
pub mod degrees;
pub mod growth;
pub mod hilbert;
pub mod integral_bound;
pub mod plane;
pub mod relations;
