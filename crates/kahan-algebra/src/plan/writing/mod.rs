//! How a polynomial becomes operations.
//!
//! - `scaling` says which products of ε, parameters and states become variables of their own.
//! - `nesting` decides which variable is taken out of which terms of a polynomial, `numerators` in
//!   which order factors are multiplied.
//! - `writer` writes a polynomial into a `draft`, which knows when each value is ready, and reuses
//!   what is there.

pub(in crate::plan) mod draft;
pub(in crate::plan) mod nesting;
pub(in crate::plan) mod numerators;
pub(in crate::plan) mod scaling;
pub(in crate::plan) mod writer;
