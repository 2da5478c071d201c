//! Formulas of a field as functions of points.

use kahan_algebra::arithmetic::{Exact, Float32, Float64};
use kahan_algebra::rational::Rational;
use kahan_study::formula::Formulas;
use num_bigint::BigInt;
use num_rational::BigRational;
use numpy::IntoPyArray;
use pyo3::exceptions::{PyValueError, PyZeroDivisionError};
use pyo3::prelude::*;

use crate::arrays::{Floats, floats};

/// Formulas that use one list of names and are computed together.
#[pyclass(frozen, module = "kahan._kahan")]
pub(crate) struct Program(Formulas);

#[pymethods]
impl Program {
    /// Reads formulas, which may use `names` and the named formulas `definitions`.
    #[new]
    fn new(names: Vec<String>, definitions: Vec<(String, String)>, texts: Vec<String>) -> PyResult<Self> {
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let definitions: Vec<(&str, &str)> =
            definitions.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        let read = Formulas::read(&names, &definitions, &texts);
        read.map(Program).map_err(|why| PyValueError::new_err(why.to_string()))
    }

    /// The indices of the names that the formulas use. Inputs have a row for each of these names.
    #[getter]
    fn needed(&self) -> Vec<usize> {
        self.0.needed()
    }

    /// Returns the values of the formulas, point after point, in the precision of the inputs.
    fn floats<'py>(
        &self,
        py: Python<'py>,
        inputs: &Bound<'py, PyAny>,
        points: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let count = points * self.0.count();
        match floats(inputs, "x")? {
            Floats::Double(inputs) => {
                let (inputs, mut values) = (inputs.as_slice()?, vec![0.0; count]);
                py.detach(|| self.0.compute(&Float64, inputs, &mut values)).expect("floats have quotients");
                Ok(values.into_pyarray(py).into_any())
            }
            Floats::Single(inputs) => {
                let (inputs, mut values) = (inputs.as_slice()?, vec![0.0; count]);
                py.detach(|| self.0.compute(&Float32, inputs, &mut values)).expect("floats have quotients");
                Ok(values.into_pyarray(py).into_any())
            }
        }
    }

    /// Returns the values of the formulas at points, as fractions.
    fn fractions(
        &self,
        py: Python<'_>,
        inputs: Vec<(BigInt, BigInt)>,
        points: usize,
    ) -> PyResult<Vec<(BigInt, BigInt)>> {
        let inputs = inputs.into_iter().map(|(above, below)| Rational::from(BigRational::new(above, below)));
        let (inputs, mut values) =
            (inputs.collect::<Vec<_>>(), vec![Rational::ZERO; points * self.0.count()]);
        let computed = py.detach(|| self.0.compute(&Exact, &inputs, &mut values));
        computed.ok_or_else(|| PyZeroDivisionError::new_err("the formula divides by zero at this point"))?;
        Ok(values.iter().map(|value| (value.numerator(), value.denominator())).collect())
    }
}
