//! How a polynomial becomes operations.
//!
//! - `scaling` says which products of ε, parameters and states become variables of their own.
//! - `nesting` decides which variable is taken out of which terms of a polynomial, `factors` finds
//!   a base of factors of several, `numerators` the order in which factors are multiplied.
//! - `writer` writes a polynomial into a `draft`, which knows when each value is ready, and reuses
//!   what is there.

pub(in crate::plan) mod draft;
pub(in crate::plan) mod factors;
pub(in crate::plan) mod nesting;
pub(in crate::plan) mod numerators;
pub(in crate::plan) mod scaling;
pub(in crate::plan) mod writer;
