//! Invariant densities from Darboux polynomials, from products of them, and from det(I − ε f′).

pub mod darboux;
pub(crate) mod density;
pub mod determinant;
pub(crate) mod products;
