//! LaTeX for the objects of `kahan-algebra`.
//!
//! The input consists of names, numbers, polynomials and expressions. The output is a displayed
//! formula for each, or lines that fit a page. Modules in reading order: `notation`, `name`,
//! `expression`, and [`breaking`], which breaks long formulas. The crate must not know where
//! formulas are shown.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod breaking;
mod expression;
mod name;
mod notation;

pub use name::symbol;
pub use notation::Latex;
