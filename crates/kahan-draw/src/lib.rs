//! Pictures of answers, and pages about answers.
//!
//! The input consists of answers of `kahan-study`, or of points, numbers and formulas. The output
//! consists of drawings and HTML pages. `plot` turns a [`Plot`], [`SpacePlot`] or [`Grid`] into a
//! [`Drawing`]. [`picture`] draws answers, and [`document`] and [`answer`] write pages. The crate
//! neither parses arguments nor writes files.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod plot;

pub mod picture;

pub mod document;

pub mod answer;

pub use plot::{
    Canvas, Drawing, DrawingFileError, Format, Grid, Mark, NumberLine, Plot, Series, SpacePlot, SpaceSeries,
    Theme, TickKind, decimal,
};
