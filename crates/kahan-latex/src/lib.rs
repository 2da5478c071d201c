//! LaTeX for objects of `kahan-algebra`. Takes names, numbers, polynomials and expressions. Returns
//! one display formula for each, or lines that fit a page. The crate doesn't know where formulas
//! are shown. Modules in reading order: `notation`, `name`, `expression`; [`breaking`] breaks the
//! formulas of the others.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod breaking;
mod expression;
mod name;
mod notation;

pub use name::symbol;
pub use notation::Latex;
