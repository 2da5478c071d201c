//! Gradients of a scalar function of the points of an orbit.

use kahan_runtime::End;
use numpy::PyUntypedArrayMethods;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::doubles;
use crate::background::{Listener, run_watched};
use crate::errors::of_dimension;
use crate::field::Field;
use crate::orbit::{composition, stride};

#[pymethods]
impl Field {
    /// Returns the derivatives of a scalar with respect to the initial point, the parameters and
    /// eps. `weights` are the derivatives of the scalar with respect to the rows of the orbit.
    #[pyo3(name = "_gradient", signature = (x, eps, weights, *, every = 1, order = 2, listener = None))]
    #[expect(clippy::too_many_arguments, reason = "Python names them")]
    fn gradient(
        &self,
        py: Python<'_>,
        x: &Bound<'_, PyAny>,
        eps: f64,
        weights: &Bound<'_, PyAny>,
        every: u64,
        order: u32,
        listener: Option<Bound<'_, PyAny>>,
    ) -> PyResult<Vec<(String, f64)>> {
        let (x, weights) = (doubles(x, "x")?, doubles(weights, "weights")?);
        let at = self.at::<f64>(py, eps)?.composed(composition(order)?);
        let every = stride(every)?;
        let steps = every.get().saturating_mul((weights.shape()[0] as u64).saturating_sub(1));
        let (start, weights) = (x.as_slice()?, weights.as_slice()?);
        let found = run_watched(py, Some(1), &Listener(listener), |caller| {
            at.gradient(start, every, weights, |made| caller.made(made, steps.saturating_mul(2)))
        })?
        .map_err(|error| of_dimension(&error))?;
        let Some(gradient) = found.report else {
            return Err(ended(found.end, steps));
        };
        let field = at.map().field();
        let names = field.variables().iter().chain(field.parameters()).cloned().chain(["eps".to_owned()]);
        let slopes = gradient.start.into_iter().chain(gradient.parameters).chain([gradient.eps]);
        Ok(names.zip(slopes).collect())
    }
}

/// Builds the error for an orbit that ends before the requested number of steps.
fn ended(end: End, steps: u64) -> PyErr {
    PyValueError::new_err(format!(
        "in float64 and without compensation the orbit ends after step {} of {steps}; choose fewer steps",
        end.steps(steps)
    ))
}
