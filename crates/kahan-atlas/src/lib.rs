//! The paper as one HTML page, written from established claims.
//!
//! The input consists of the claims of `kahan-paper` with their outcomes, and of the heights along
//! the paper's orbits ([`AtlasContent::compute`]). The output is one HTML document with MathML and
//! SVG, without scripts or network access ([`page`]).

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
