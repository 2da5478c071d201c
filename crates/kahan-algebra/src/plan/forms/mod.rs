//! Forms of a step: different ways to write its operations.
//!
//! - `structure` finds blocks of the field and independent states in them.
//! - `factored_map` writes the reduced map as products over one base of factors.
//! - `minors` writes determinants of A, `blocks` solves A block by block, `products` solves with f
//!   as written, `inverse` divides by the time step, `tangent` maps tangent vectors.
//! - `candidate` prices a finished form, `candidates` compares forms.

pub(in crate::plan) mod blocks;
pub(in crate::plan) mod candidate;
pub(in crate::plan) mod candidates;
pub(in crate::plan) mod factored_map;
pub(in crate::plan) mod inverse;
pub(in crate::plan) mod minors;
pub(in crate::plan) mod products;
pub(in crate::plan) mod structure;
pub(in crate::plan) mod tangent;
