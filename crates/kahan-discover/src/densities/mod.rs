//! Invariant densities from Darboux polynomials, their products, and det A.

pub mod darboux;
pub(crate) mod density;
pub mod determinant;
pub(crate) mod products;
