//! Invariant densities from Darboux polynomials, from products of them, from det(I − ε f′), and
//! from Pfaffians of brackets.

pub mod darboux;
pub(crate) mod density;
pub mod determinant;
pub(crate) mod products;
