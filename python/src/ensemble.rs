//! Many trajectories at once, over all processors.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use kahan_runtime::{MapAt, threads};
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{Floats, doubles, floats, out as writable};
use crate::beside::{Caller, Listener, beside};
use crate::errors::of_dimension;
use crate::field::{Field, Float};
use crate::orbit::{composition, points_of};

/// Trajectories that a thread takes at once: their columns stay in its cache.
const TOGETHER: usize = 1024;
/// Steps of all of them between two looks at signals.
const AT_ONCE: u64 = 1 << 22;

#[pymethods]
impl Field {
    /// The points of many trajectories after so many steps. `eps` and the values of parameters are
    /// one number, or one a trajectory.
    #[pyo3(signature = (points, eps, steps, *, parameters = Vec::new(), order = 2, threads = None, out = None, listener = None))]
    #[expect(clippy::too_many_arguments, reason = "Python names them")]
    fn advance<'py>(
        &self,
        points: &Bound<'py, PyAny>,
        eps: &Bound<'py, PyAny>,
        steps: u64,
        parameters: Vec<Option<Bound<'py, PyAny>>>,
        order: u32,
        threads: Option<usize>,
        out: Option<&Bound<'py, PyAny>>,
        listener: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let asked = Asked { eps, steps, parameters, order, threads, listener: Listener(listener) };
        match floats(points, "points")? {
            Floats::Double(points) => self.advanced(&points, &asked, out),
            Floats::Single(points) => self.advanced(&points, &asked, out),
        }
    }
}

/// What is asked of an ensemble.
struct Asked<'a, 'py> {
    eps: &'a Bound<'py, PyAny>,
    steps: u64,
    parameters: Vec<Option<Bound<'py, PyAny>>>,
    order: u32,
    threads: Option<usize>,
    listener: Listener<'py>,
}

impl Field {
    fn advanced<'py, T: Float>(
        &self,
        points: &Bound<'py, PyArrayDyn<T>>,
        asked: &Asked<'_, 'py>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = points.py();
        let points = points.readonly();
        let (variables, shape) = (self.dimension(), points.shape());
        if shape.len() != 2 || shape[1] != variables {
            return Err(points_of(variables, shape));
        }
        let eps = constants::<T>(asked.eps, shape[0], "eps")?;
        let constants = asked.parameters.iter().enumerate().map(|(k, given)| match given {
            Some(given) => constants::<T>(given, shape[0], self.parameter(k)),
            None => Ok(Vec::new()),
        });
        let mut constants = constants.collect::<PyResult<Vec<Vec<T>>>>()?;
        // Those that are given here may have no value in the field.
        let at: MapAt<T> = self.map_with(py, &constants)?.at(eps.first().copied().unwrap_or_else(T::zero));
        let at = at.composed(composition(asked.order)?);
        for (own, values) in at.map().parameters().iter().zip(&mut constants) {
            if values.is_empty() {
                values.push(T::near(own.to_f64()));
            }
        }
        let many = Many {
            at,
            eps,
            constants: if asked.parameters.is_empty() { Vec::new() } else { constants },
            steps: asked.steps,
        };
        let from = points.as_slice()?;
        let run = |to: &mut [T]| {
            to.copy_from_slice(from);
            beside(py, asked.threads, &asked.listener, |caller| many.advance(to, variables, caller))?
                .map_err(|error| of_dimension(&error))
        };
        match out {
            Some(out) => {
                run(writable::<T>(out, shape)?.as_slice_mut()?)?;
                Ok(out.clone())
            }
            None => {
                let mut to = vec![T::zero(); from.len()];
                run(&mut to)?;
                Ok(PyArray1::from_vec(py, to).reshape(shape)?.into_any())
            }
        }
    }
}

/// Many trajectories of one field.
struct Many<T> {
    at: MapAt<T>,
    /// One, or one a trajectory.
    eps: Vec<T>,
    /// The same of each parameter; nothing where all are those of the map.
    constants: Vec<Vec<T>>,
    steps: u64,
}

impl<T: Float> Many<T> {
    /// Advances points that stand row by row.
    fn advance(
        &self,
        rows: &mut [T],
        variables: usize,
        caller: &Caller,
    ) -> Result<(), kahan_runtime::DimensionError> {
        let width = variables.max(1);
        let pieces: Vec<Mutex<&mut [T]>> = rows.chunks_mut(TOGETHER * width).map(Mutex::new).collect();
        let failed = Mutex::new(Ok(()));
        threads::for_each(pieces.len(), Some(kahan_study::Watch::threads(caller)), &|piece| {
            let mut rows = pieces[piece].lock().unwrap_or_else(PoisonError::into_inner);
            if let Err(error) = self.piece(&mut rows, width, piece * TOGETHER, caller) {
                *failed.lock().unwrap_or_else(PoisonError::into_inner) = Err(error);
            }
        });
        failed.into_inner().unwrap_or_else(PoisonError::into_inner)
    }

    /// Those of one thread, the first of which has this number.
    fn piece(
        &self,
        rows: &mut [T],
        width: usize,
        first: usize,
        caller: &Caller,
    ) -> Result<(), kahan_runtime::DimensionError> {
        let count = rows.len() / width;
        let mut columns = vec![vec![T::zero(); count]; width];
        for (k, row) in rows.chunks_exact(width).enumerate() {
            columns.iter_mut().zip(row).for_each(|(column, x)| column[k] = *x);
        }
        let own = |values: &'_ [T]| -> std::ops::Range<usize> {
            if values.len() > 1 { first..first + count } else { 0..values.len() }
        };
        let eps = &self.eps[own(&self.eps)];
        let parameters: Vec<&[T]> = self.constants.iter().map(|values| &values[own(values)]).collect();
        let at_once = (AT_ONCE / count as u64).max(1);
        let mut left = self.steps;
        while left > 0 && caller.goes_on() == ControlFlow::Continue(()) {
            let steps = left.min(at_once);
            let mut slices: Vec<&mut [T]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
            self.at.advance_columns(&mut slices, eps, &parameters, steps)?;
            left -= steps;
        }
        for (k, row) in rows.chunks_exact_mut(width).enumerate() {
            row.iter_mut().zip(&columns).for_each(|(x, column)| *x = column[k]);
        }
        Ok(())
    }
}

/// Numbers of which there is one, or one a trajectory.
fn constants<T: Float>(given: &Bound<'_, PyAny>, trajectories: usize, name: &str) -> PyResult<Vec<T>> {
    let values: PyReadonlyArrayDyn<'_, f64> = doubles(given, name)?;
    match values.shape() {
        [] => {}
        [count] if *count == trajectories => {}
        shape => {
            return Err(PyValueError::new_err(format!(
                "{name} has the shape {shape:?}; one number is needed, or one for each of the {trajectories} points"
            )));
        }
    }
    Ok(values.as_slice()?.iter().map(|value| T::near(*value)).collect())
}
