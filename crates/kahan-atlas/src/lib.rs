//! The paper as one HTML page. The page is written from claims that are established for it.
//!
//! The input consists of the claims of `kahan-paper` with their outcomes, and of heights along the
//! paper's orbits. The output is one self-contained HTML document with MathML and SVG, without
//! scripts or network access. [`AtlasContent::compute`] establishes the claims and computes the
//! orbits. [`page`] writes the document; each section of the page has a module. The crate must not
//! know the command or files.

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
