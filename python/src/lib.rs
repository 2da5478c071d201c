//! The interface between Python and the libraries.
//!
//! Questions are JSON ([`kahan_study::Question`]); answers are JSON, or arrays for tables. Steps,
//! orbits and ensembles take and return NumPy arrays. Python files in `kahan/` add named results,
//! SymPy formulas and plots.

mod arrays;
mod arrow;
mod background;
mod basis;
mod ensemble;
mod errors;
mod field;
mod gradient;
mod lattice;
mod orbit;
mod program;
mod section;
mod sensitivities;
mod series;
mod table;

use std::ffi::OsString;

use kahan_draw::picture::Chart;
use kahan_study::numbers::ScalarKind;
use kahan_study::{Catalog, Direction, Method, Observable, Systems};
use pyo3::prelude::*;

/// The compiled module of the package `kahan`.
#[pymodule]
mod _kahan {
    #[pymodule_export]
    use super::{
        arrays::columns, arrow::arrow, basis::Relation, command, field::Field, lattice::Chain,
        lattice::is_family, names, nearest, picture_scale, program::Program,
    };

    /// The version of the package.
    #[pymodule_export]
    #[allow(non_upper_case_globals, reason = "Python's name of it")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}

/// Runs the command `kahan`, and returns its exit status.
#[pyfunction]
fn command(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| kahan_cli::status(arguments))
}

/// Returns the known names of directions, methods, observables, scalar types, systems and families.
#[pyfunction]
fn names() -> [(&'static str, Vec<&'static str>); 6] {
    let known = Systems.names().into_iter().map(|[name, _]| name);
    let (system, family) =
        known.partition(|name| Systems.find(name).is_some_and(|known| known.type_name.is_some()));
    [
        ("direction", Direction::ALL.map(Direction::name).to_vec()),
        ("method", Method::ALL.map(Method::name).to_vec()),
        ("observable", Observable::NAMES.to_vec()),
        ("scalar", ScalarKind::ALL.map(ScalarKind::name).to_vec()),
        ("system", system),
        ("family", family),
    ]
}

/// Returns the known name that `name` probably misspells.
#[pyfunction]
fn nearest(name: &str, known: Vec<String>) -> Option<String> {
    kahan_algebra::check::nearest(name, &known).cloned()
}

/// Returns whether pictures show the logarithms (to base 10) of this column, and the shown values.
#[pyfunction]
fn picture_scale(column: &str, values: Vec<f64>) -> (bool, Vec<f64>) {
    (Chart::is_logarithmic(column), values.into_iter().map(Chart::scale(column)).collect())
}
