//! The border between Python and the project's libraries: Python's objects in, arrays and answers
//! out.
//!
//! It must not know mathematics. A question comes as JSON and goes back as JSON
//! ([`kahan_study::Question`]); what is called in a loop (a step, an orbit, an ensemble) takes and
//! gives NumPy arrays without a detour. What Python can say better than Rust, such as results with
//! names, formulas of SymPy, plots, is in the Python files of `kahan/`.

mod arrays;
mod arrow;
mod basis;
mod beside;
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

/// The border; its names are those of the package `kahan`.
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

/// Runs the command `kahan` with these arguments, the program's name first, and gives its exit
/// status.
#[pyfunction]
fn command(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    // What an exit code holds is not to be had from Rust but through its text.
    py.detach(|| kahan_cli::status(arguments))
}

/// The names that arguments of one kind may have, by that kind.
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

/// The name that `name` is a slip of, found as it is in the text of a field.
#[pyfunction]
fn nearest(name: &str, known: Vec<String>) -> Option<String> {
    kahan_algebra::check::nearest(name, &known).cloned()
}

/// How pictures show the numbers of a column: whether as logarithms to base 10, and the numbers.
#[pyfunction]
fn picture_scale(column: &str, values: Vec<f64>) -> (bool, Vec<f64>) {
    (Chart::is_logarithmic(column), values.into_iter().map(Chart::scale(column)).collect())
}
