//! Invariant densities: Darboux polynomials with the cofactor of the Jacobian, their products, and
//! det A.

pub mod darboux;
pub(crate) mod density;
pub mod determinant;
pub(crate) mod products;
