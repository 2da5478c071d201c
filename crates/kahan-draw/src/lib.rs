//! Answers as pictures and pages.
//!
//! In: answers of `kahan-study`, or points, numbers and formulas, and how they are to look. Out:
//! drawings, as SVG within a page or as files of their own, and pages of HTML. It must not know the
//! command, nor any file.
//!
//! `plot` draws: a [`Plot`], a [`Space`] or a [`Grid`] becomes a [`Drawing`]. [`picture`] makes such
//! of answers. [`document`] sets formulas, tables and whole pages, which show drawings; [`answer`]
//! is what an answer says there.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod plot;

pub mod picture;

pub mod document;

pub mod answer;

pub use plot::{
    Cloud, Drawing, Format, Grid, Mark, Marks, NoFile, NumberLine, Plot, Series, Sheet, Space, Theme, decimal,
};
