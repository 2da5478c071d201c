//! LaTeX for objects of `kahan-algebra`.
//!
//! Names, numbers, polynomials and expressions come in; a display formula for each, or lines that
//! fit a page, go out. Modules in reading order: `notation`, `name`, `expression`; [`breaking`]
//! breaks long formulas. The crate must not know where formulas are shown.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod breaking;
mod expression;
mod name;
mod notation;

pub use name::symbol;
pub use notation::Latex;
