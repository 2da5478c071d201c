//! The language of `kahan!`, as far as it is text.
//!
//! In: text, or the tokens of a macro. Out: the syntax tree of a block or of a formula, each part
//! with its place and each number exact, and the mistakes that can be seen without knowing what a
//! name means. The crate must not know polynomials: what is a vector field, and whether a claim
//! holds, is decided by `kahan-algebra`.
//!
//! `kahan-algebra` shares the exact numbers ([`rational`]) and the short sorted lists ([`table`]).

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

// Each needs those before it only, which a test guards.
pub mod rational;

pub mod table;

pub mod token;

pub mod spelling;

pub mod lexer;

pub mod syntax;

pub mod diagnostics;

pub mod parse;

pub mod lenient;
