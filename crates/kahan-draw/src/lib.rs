//! Pictures of answers, and pages about answers.
//!
//! The input is an answer of `kahan-study`, or points, numbers and formulas. The output is drawings
//! and HTML pages. `plot` turns a [`Plot`], [`SpacePlot`] or [`Grid`] into a [`Drawing`].
//! [`picture`] draws answers, and [`document`] and [`answer`] write pages. The crate neither parses
//! arguments nor writes files.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod plot;

pub mod picture;

pub mod document;

pub mod answer;

pub use plot::{
    Canvas, Drawing, DrawingFileError, Format, Grid, Mark, NumberLine, Plot, Series, SpacePlot, SpaceSeries,
    Theme, TickKind, decimal,
};
