//! Pictures and pages of answers. Takes answers of `kahan-study`, or points, numbers and formulas,
//! and a description of their looks. Returns drawings, as SVG within a page or as files, and pages
//! of HTML. The crate knows neither the command nor any file. `plot` turns a [`Plot`], [`Space`] or
//! [`Grid`] into a [`Drawing`]; [`picture`] builds these from answers. [`document`] sets formulas,
//! tables and pages; [`answer`] sets answers within them.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

mod plot;

pub mod picture;

pub mod document;

pub mod answer;

pub use plot::{
    Cloud, Drawing, Format, Grid, Mark, Marks, NoFile, NumberLine, Plot, Series, Sheet, Space, Theme, decimal,
};
