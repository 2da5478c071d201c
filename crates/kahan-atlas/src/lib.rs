//! The paper as one page, written from claims that were established for that page.
//!
//! In: the claims of `kahan-paper` with their outcomes, and heights along its orbits. Out: one
//! self-contained HTML document with MathML and SVG, without network access and scripts. The crate
//! must not know the command or files. No result is stored here: [`Found::compute`] establishes the
//! claims and computes the orbits, and [`page`] writes the document, one module a section.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod contents;
mod errata;
mod figures;
mod found;
mod solutions;
mod structures;
mod systems;
mod verification;
mod words;

pub use contents::page;
pub use found::{Checked, Found, Orbits};

pub use kahan_draw::document::Making;
