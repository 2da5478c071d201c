//! The atlas: the paper as one page, drawn and written from what was established while it was made.
//!
//! [`Found::compute`] establishes every claim and follows every orbit; [`page`] writes one
//! self-contained HTML document from that. No number is stored here: figures come from the measured
//! orbits, tables from the text that the claims check, outcomes from the claims. The page needs no
//! network and no script; formulas are MathML, drawings are SVG.
//!
//! `figures` and the other modules are one section of the page each.

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
