//! Which forms a step has, and which of them is cheapest.
//!
//! - `structure` finds blocks of the field, and states in them that do not act on each other.
//! - `factored_map` writes the reduced map as products over one base of factors.
//! - `minors` writes determinants of A, `blocks` solves A block by block, `products` solves it with
//!   f as it was written, `inverse` divides by the time step, `tangent` carries tangent vectors.
//! - `candidate` gives a finished form its price, `candidates` compares them.

pub(in crate::plan) mod blocks;
pub(in crate::plan) mod candidate;
pub(in crate::plan) mod candidates;
pub(in crate::plan) mod factored_map;
pub(in crate::plan) mod inverse;
pub(in crate::plan) mod minors;
pub(in crate::plan) mod products;
pub(in crate::plan) mod structure;
pub(in crate::plan) mod tangent;
