//! Kahan's map of a system in other languages.
//!
//! In: a block of the language of `kahan!`, read by `kahan-algebra`. Out: the same map as Rust
//! ([`rust`]), which is what the macro expands to. It must not know mathematics: it decides nothing
//! that a plan has not decided.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

#[cfg(test)]
mod golden;
#[cfg(feature = "rust")]
pub mod rust;
