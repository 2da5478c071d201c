//! Turns polynomials into operations.
//!
//! - `scaling` replaces products of ε with parameters and states by new variables.
//! - `nesting` chooses the variable to factor out.
//! - `factors` computes a common set of factors, and `numerators` orders multiplications.
//! - `writer` writes a polynomial into a `plan_draft` and reuses existing operations.

pub(in crate::plan) mod factors;
pub(in crate::plan) mod nesting;
pub(in crate::plan) mod numerators;
pub(in crate::plan) mod plan_draft;
pub(in crate::plan) mod scaling;
pub(in crate::plan) mod writer;
