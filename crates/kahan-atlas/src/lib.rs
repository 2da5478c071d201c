//! The paper as one HTML page, written from claims established for that page.
//!
//! The claims of `kahan-paper` with their outcomes, and heights along its orbits, come in. One
//! self-contained HTML document with MathML and SVG goes out, without scripts or network access.
//! [`AtlasContent::compute`] establishes the claims and computes the orbits; [`page`] writes the document,
//! one module for each section. The crate must not know the command or files.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod contents;
mod errata;
mod figures;
mod found;
mod solutions;
mod structures;
mod systems;
mod text;
mod verification;

pub use contents::page;
pub use found::{AtlasContent, CheckedClaim, Orbits};

pub use kahan_draw::document::PageCreation;
