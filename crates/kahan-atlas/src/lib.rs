//! The paper as one page, drawn and written from what was established while it was made.
//!
//! In: the claims of `kahan-paper` with their outcomes, and the heights of its orbits. Out: HTML.
//! It must not know the command, nor any file.
//!
//! [`Found::compute`] establishes every claim and follows every orbit; [`page`] writes one
//! self-contained HTML document from that. No number is stored here: figures come from the measured
//! orbits, tables from the text that the claims check, outcomes from the claims. The page needs no
//! network and no script; formulas are MathML, drawings are SVG.
//!
//! `figures` and the other modules are one section of the page each.

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
