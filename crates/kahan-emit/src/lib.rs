//! Kahan's map of a system as Rust.
//!
//! In: a block of the language of `kahan!`, read by `kahan-algebra`. Out: the map as tokens
//! (`rust`), which is what the macro expands to, or as formatted text. It must not know
//! mathematics: it decides nothing that a plan has not decided.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

#[cfg(test)]
mod golden;
#[cfg(feature = "rust")]
pub mod rust;
