//! What `kahan-algebra` derives, in LaTeX.
//!
//! In: names, numbers, polynomials and expressions. Out: one formula each, as it stands in a
//! display, or long ones in lines that fit a page. It must not know where a formula is shown: not
//! the command, nor the pages.
//!
//! Modules in reading order: `notation`, `name`, `expression`; [`breaking`] takes what the others
//! have written.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

pub mod breaking;
mod expression;
mod name;
mod notation;

pub use name::symbol;
pub use notation::Latex;
