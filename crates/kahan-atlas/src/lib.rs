//! The paper as one HTML page, written from established claims.
//!
//! In: the claims of `kahan-paper` with their outcomes, and heights along the paper's orbits
//! ([`AtlasContent::compute`]). Out: one HTML document with MathML and SVG, without scripts or
//! network access ([`page`]). The crate must not know the command or files.

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
