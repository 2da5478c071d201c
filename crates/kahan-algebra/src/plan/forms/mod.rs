//! Forms of a step, which are different ways to write its operations.
//!
//! - `structure` finds blocks of the field.
//! - `factored_map` writes the reduced map as products over one set of factors.
//! - `minors`, `blocks` and `products` solve A·(x̃ − x) = 2εf; `products` keeps the products in f.
//! - `inverse` divides by the time step, and `tangent` maps tangent vectors.
//! - `candidate` prices a form, and `candidates` compares forms.

pub(in crate::plan) mod blocks;
pub(in crate::plan) mod candidate;
pub(in crate::plan) mod candidates;
pub(in crate::plan) mod factored_map;
pub(in crate::plan) mod inverse;
pub(in crate::plan) mod minors;
pub(in crate::plan) mod products;
pub(in crate::plan) mod structure;
pub(in crate::plan) mod tangent;
