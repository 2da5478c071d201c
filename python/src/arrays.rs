//! Reads NumPy arrays as slices, and writes the error messages for arrays that cannot be read.
//!
//! Arrays of `float64` in C order are used without a copy. Functions of single precision also use
//! `float32` without a copy.

use kahan_study::columns::{ExpectedColumns, OtherColumns};
use kahan_study::numbers::number;
use numpy::{
    Element, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyReadwriteArrayDyn, PyUntypedArrayMethods,
};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;

pub(crate) struct Eps(pub(crate) f64);

impl FromPyObject<'_, '_> for Eps {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        nearest(&given, "eps").map(Eps)
    }
}

fn nearest(given: &Bound<'_, PyAny>, name: &str) -> PyResult<f64> {
    if let Ok(number) = given.extract() {
        return Ok(number);
    }
    let Ok(text) = given.extract::<&str>() else {
        let message = format!("{name}: a number is needed, and not {}", given.get_type().name()?);
        return Err(PyTypeError::new_err(message));
    };
    let number = number(text).map_err(|why| PyValueError::new_err(format!("{name}: {why}")))?;
    Ok(number.to_f64())
}

/// Returns ε, half the time step. The caller gives either ε or the time step.
pub(crate) fn half_step(eps: Option<&Bound<'_, PyAny>>, dt: Option<&Bound<'_, PyAny>>) -> PyResult<f64> {
    match (eps, dt) {
        (Some(eps), None) => nearest(eps, "eps"),
        (None, Some(dt)) => Ok(0.5 * nearest(dt, "dt")?),
        (None, None) => Err(PyTypeError::new_err("give eps, half the time step, or dt, the time step")),
        (Some(_), Some(_)) => {
            Err(PyTypeError::new_err("eps and dt are both given; dt = 2 eps, and one of them says it"))
        }
    }
}

pub(crate) enum Floats<'py> {
    Double(PyReadonlyArrayDyn<'py, f64>),
    Single(PyReadonlyArrayDyn<'py, f32>),
}

/// Reads numbers that a caller gave; `name` is the name of the argument.
pub(crate) fn floats<'py>(given: &Bound<'py, PyAny>, name: &str) -> PyResult<Floats<'py>> {
    let is_usable = |array: &Bound<'py, PyArrayDyn<f64>>| array.is_c_contiguous();
    if let Ok(array) = given.cast::<PyArrayDyn<f64>>()
        && is_usable(array)
    {
        return Ok(Floats::Double(readonly(array, name)?));
    }
    let converted = converted(given, name)?;
    if let Ok(array) = converted.cast::<PyArrayDyn<f32>>() {
        return Ok(Floats::Single(readonly(array, name)?));
    }
    let array = converted.cast::<PyArrayDyn<f64>>()?;
    Ok(Floats::Double(readonly(array, name)?))
}

/// Reads numbers as [`floats`] does, and converts `f32` to `f64`.
pub(crate) fn doubles<'py>(given: &Bound<'py, PyAny>, name: &str) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    match floats(given, name)? {
        Floats::Double(array) => Ok(array),
        Floats::Single(array) => {
            let wide = array.call_method1("astype", ("float64",))?;
            readonly(wide.cast::<PyArrayDyn<f64>>()?, name)
        }
    }
}

/// Converts numbers to an array of floats in C order, by the Python module `kahan._arrays`.
fn converted<'py>(given: &Bound<'py, PyAny>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    static FLOATS: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    FLOATS.import(given.py(), "kahan._arrays", "floats")?.call1((given, name))
}

/// Reads numbers by `kahan._arrays`, which sorts named numbers into the order of the variables.
pub(crate) fn named<'py>(
    given: &Bound<'py, PyAny>,
    of: &Bound<'py, PyAny>,
    name: &str,
) -> PyResult<Bound<'py, PyAny>> {
    static NAMED: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    // An array of floats has no names, so it is read directly.
    if given.cast::<PyArrayDyn<f64>>().is_ok() || given.cast::<PyArrayDyn<f32>>().is_ok() {
        return Ok(given.clone());
    }
    NAMED.import(given.py(), "kahan._arrays", "named")?.call1((given, of, name))
}

/// The columns with the states, and the names and columns of parameters and `eps` in a table.
pub(crate) type Places = (Vec<usize>, Vec<(String, usize)>);

/// Finds the columns of a table by their names. Each of the first `least` states must have a
/// column. Parameters and `eps` may have columns if `varies` is true.
pub(crate) fn places(
    names: &[String],
    (states, least): (&[String], usize),
    parameters: &[String],
    varies: bool,
    name: &str,
) -> PyResult<Places> {
    let others = if varies { OtherColumns::Used } else { OtherColumns::Refused };
    let found = ExpectedColumns { states, least, parameters, others }.places(names);
    let found = found.map_err(|why| PyValueError::new_err(format!("{name}: the table {why}")))?;
    Ok((found.states, found.others))
}

/// Finds columns for `kahan._formula`. Every name in `states` must have a column.
#[pyfunction]
pub(crate) fn columns(
    names: Vec<String>,
    states: Vec<String>,
    parameters: Vec<String>,
    varies: bool,
    name: &str,
) -> PyResult<Places> {
    places(&names, (&states, states.len()), &parameters, varies, name)
}

fn readonly<'py, T: Element>(
    array: &Bound<'py, PyArrayDyn<T>>,
    name: &str,
) -> PyResult<PyReadonlyArrayDyn<'py, T>> {
    let borrowed = array.try_readonly();
    borrowed.map_err(|error| PyValueError::new_err(format!("{name}: {error}; give a copy of it")))
}

/// Checks the memory order, the shape and the type of an array for results.
pub(crate) fn out<'py, T: Element>(
    given: &Bound<'py, PyAny>,
    sizes: &[usize],
) -> PyResult<PyReadwriteArrayDyn<'py, T>> {
    let dtype = T::get_dtype(given.py());
    let array = given.cast::<PyArrayDyn<T>>().map_err(|_| {
        PyTypeError::new_err(format!("out: an array of {dtype} is needed, as the points are of that type"))
    })?;
    if array.shape() != sizes {
        return Err(PyValueError::new_err(format!(
            "out has the shape {:?}, and the result {sizes:?}",
            array.shape()
        )));
    }
    if !array.is_c_contiguous() {
        return Err(PyValueError::new_err("out: an array in C order is needed; see numpy.ascontiguousarray"));
    }
    array.try_readwrite().map_err(|error| {
        PyValueError::new_err(format!("out: {error}; give an array that can be written, and is no argument"))
    })
}
