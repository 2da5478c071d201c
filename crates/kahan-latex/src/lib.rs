//! LaTeX for the objects of `kahan-algebra`.
//!
//! Names, numbers, polynomials and expressions become displayed formulas, or lines that fit a page
//! ([`breaking`]).

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod breaking;
mod expression;
mod name;
mod notation;

pub use name::symbol;
pub use notation::Latex;
