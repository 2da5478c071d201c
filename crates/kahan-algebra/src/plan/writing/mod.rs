//! Turns polynomials into operations.
//!
//! - `scaling` makes products of ε with parameters and states variables of their own.
//! - `nesting` chooses the variable to factor out of terms, `factors` computes a common base of
//!   factors, `numerators` chooses the order of multiplications.
//! - `writer` writes a polynomial into a `draft`, which tracks when each value is ready, and reuses
//!   existing operations.

pub(in crate::plan) mod factors;
pub(in crate::plan) mod nesting;
pub(in crate::plan) mod numerators;
pub(in crate::plan) mod plan_draft;
pub(in crate::plan) mod scaling;
pub(in crate::plan) mod writer;
