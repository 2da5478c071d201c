//! The border between Python and the project's libraries: Python's objects in, arrays and answers
//! out.
//!
//! It must not know mathematics. A question comes as JSON and goes back as JSON
//! ([`kahan_study::Question`]); what is called in a loop (a step, an orbit, an ensemble) takes and
//! gives NumPy arrays without a detour. What Python can say better than Rust, such as results with
//! names, formulas of SymPy, plots, is in the Python files of `kahan/`.

mod arrays;
mod beside;
mod ensemble;
mod errors;
mod field;
mod lattice;
mod orbit;
mod table;

use std::ffi::OsString;

use kahan_study::{Catalog, Systems};
use pyo3::prelude::*;

/// The border; its names are those of the package `kahan`.
#[pymodule]
mod _kahan {
    #[pymodule_export]
    use super::{catalog, command, field::Field, lattice::Chain};
}

/// Runs the command `kahan` with these arguments, the program's name first, and gives its exit
/// status.
#[pyfunction]
fn command(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    // What an exit code holds is not to be had from Rust but through its text.
    py.detach(|| kahan_cli::status(arguments))
}

/// The names of the catalog's systems and families.
#[pyfunction]
fn catalog() -> Vec<&'static str> {
    Systems.names().iter().map(|[name, _]| *name).collect()
}
