//! What the Kahan map of a quadratic field preserves, found from its equations alone.

pub mod claims;
pub mod darboux;
pub mod degrees;
pub mod growth;
pub mod hilbert;
pub mod independent;
pub mod integrals;
pub mod leaf;
pub mod lift;
pub mod map;
pub mod matrix;
pub mod modulus;
pub mod monomials;
pub mod pencil;
pub mod relations;
pub mod search;
pub mod setting;
pub mod space;
pub mod thiele;
