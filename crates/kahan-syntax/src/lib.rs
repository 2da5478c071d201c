//! Reads the language of `kahan!`.
//!
//! The input is a text, or the tokens of a macro. The output is the syntax tree of a block or
//! formula, with positions, exact numbers and mistakes. Names are not resolved here, except
//! functions and auxiliary quantities in the notation of other programs. The crate `kahan-algebra`
//! decides which blocks are fields and which claims hold.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

// A module uses only modules above it. A test checks the order.
pub mod rational;

pub mod table;

pub mod token;

pub mod spelling;

pub mod lexer;

pub mod syntax;

pub mod diagnostics;

pub mod parse;

pub mod lenient;
