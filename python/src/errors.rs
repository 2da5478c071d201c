//! Python exceptions for the errors of the libraries.

use kahan_runtime::{Diagnostics, DimensionError};
use kahan_study::StudyError;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyType;

fn class<'py>(
    py: Python<'py>,
    cell: &'static PyOnceLock<Py<PyType>>,
    name: &str,
) -> PyResult<&'py Bound<'py, PyType>> {
    cell.import(py, "kahan._errors", name)
}

/// Builds `kahan.FieldError`, which holds the position of each mistake in the text.
fn field_error(py: Python<'_>, mistakes: &Diagnostics) -> PyResult<PyErr> {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let places = mistakes.mistakes().iter().zip(mistakes.places());
    let places = places.map(|(mistake, [line, column])| (&mistake.message, line, column, &mistake.help));
    let places: Vec<_> = places.collect();
    let error = class(py, &CLASS, "FieldError")?.call1((mistakes.to_string().trim_end(), places))?;
    Ok(PyErr::from_value(error))
}

/// Builds `kahan.SingularStep` for a point at which the map is undefined.
pub(crate) fn singular_step(py: Python<'_>, message: &str) -> PyErr {
    static CLASS: PyOnceLock<Py<PyType>> = PyOnceLock::new();
    let error = class(py, &CLASS, "SingularStep").and_then(|class| class.call1((message,)));
    error.map_or_else(|failed| failed, PyErr::from_value)
}

pub(crate) fn of_study(py: Python<'_>, error: &StudyError) -> PyErr {
    match error {
        StudyError::Field(mistakes) => field_error(py, mistakes).unwrap_or_else(|failed| failed),
        StudyError::UnknownParameter { .. } => PyTypeError::new_err(error.to_string()),
        StudyError::MissingParameters { names, .. } => {
            let values: Vec<String> = names.iter().map(|name| format!("{name}=1")).collect();
            PyValueError::new_err(format!("{error}; give it by name, as in s({})", values.join(", ")))
        }
        StudyError::NoIntegral { .. } => PyValueError::new_err(
            "color: this field claims no integral that could drift; `s.discover().claimed` has those found",
        ),
        other => PyValueError::new_err(other.to_string()),
    }
}

pub(crate) fn of_dimension(error: &DimensionError) -> PyErr {
    PyValueError::new_err(error.to_string())
}
