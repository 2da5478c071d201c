//! Pictures of answers, and pages about answers.
//!
//! In: answers of `kahan-study`, or points, numbers and formulas; and a description of how they
//! look. Out: drawings, as SVG or files, and HTML pages. `plot` turns a [`Plot`], [`SpacePlot`] or
//! [`Grid`] into a [`Drawing`]; [`picture`] builds these from answers; [`document`] and [`answer`]
//! write pages. Commands and file access are deliberately absent.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod plot;

pub mod picture;

pub mod document;

pub mod answer;

pub use plot::{
    Canvas, Drawing, DrawingFileError, Format, Grid, Mark, NumberLine, Plot, Series, SpacePlot, SpaceSeries,
    Theme, TickKind, decimal,
};
