//! LaTeX for the objects of `kahan-algebra`.
//!
//! In: names, numbers, polynomials and expressions. Out: a displayed formula for each, or lines
//! that fit a page ([`breaking`]). The crate must not know where formulas are shown.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod breaking;
mod expression;
mod name;
mod notation;

pub use name::symbol;
pub use notation::Latex;
