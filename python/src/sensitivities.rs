//! Derivatives of orbits and ensembles with respect to parameters, first points and ε.

use std::num::NonZeroU64;

use kahan_core::num_traits::Zero;
use kahan_core::{Increments, Step, Workspace};
use kahan_runtime::Sensitivity;
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;

use crate::arrays::{Floats, floats};
use crate::background::{Listener, run_watched, run_watched_if_long};
use crate::ensemble;
use crate::errors::of_dimension;
use crate::field::{Field, Float};
use crate::orbit::composition;

const MOMENT: u64 = 4096;

#[pymethods]
impl Field {
    /// Differentiates the rows of an orbit with respect to the names in `by`. Returns the names in
    /// order, and an array of shape (names, rows, variables).
    #[pyo3(name = "_derivatives", signature = (rows, eps, by, *, every, order = 2, compensated = false, listener = None))]
    #[expect(clippy::too_many_arguments, reason = "Python names them")]
    fn derivatives<'py>(
        &self,
        rows: &Bound<'py, PyAny>,
        eps: f64,
        by: Vec<String>,
        every: NonZeroU64,
        order: u32,
        compensated: bool,
        listener: Option<Bound<'py, PyAny>>,
    ) -> PyResult<(Vec<String>, Bound<'py, PyAny>)> {
        let vectors = self.vectors(&by);
        let asked = SensitivityOptions { eps, every, order, compensated, listener: Listener(listener) };
        let derivatives = match floats(rows, "rows")? {
            Floats::Double(rows) => self.along(&rows, &vectors, &asked),
            Floats::Single(rows) => self.along(&rows, &vectors, &asked),
        };
        Ok((vectors.names, derivatives?))
    }

    /// Differentiates the last points of an ensemble with respect to the names in `by`. Returns the
    /// names in order, and an array of shape (names, trajectories, variables).
    #[pyo3(name = "_last_derivatives", signature = (points, eps, steps, by, *, parameters = Vec::new(), order = 2, threads = None, listener = None))]
    #[expect(clippy::too_many_arguments, reason = "Python names them")]
    fn last_derivatives<'py>(
        &self,
        points: &Bound<'py, PyAny>,
        eps: &Bound<'py, PyAny>,
        steps: u64,
        by: Vec<String>,
        parameters: Vec<Option<Bound<'py, PyAny>>>,
        order: u32,
        threads: Option<usize>,
        listener: Option<Bound<'py, PyAny>>,
    ) -> PyResult<(Vec<String>, Bound<'py, PyAny>)> {
        let vectors = self.vectors(&by);
        let asked = ensemble::EnsembleOptions {
            eps,
            steps,
            parameters,
            order,
            threads,
            listener: Listener(listener),
        };
        let derivatives = match floats(points, "points")? {
            Floats::Double(points) => self.at_the_end(&points, &vectors, &asked),
            Floats::Single(points) => self.at_the_end(&points, &vectors, &asked),
        };
        Ok((vectors.names, derivatives?))
    }
}

struct SensitivityOptions<'py> {
    eps: f64,
    every: NonZeroU64,
    order: u32,
    compensated: bool,
    listener: Listener<'py>,
}

/// The derivative vectors that are propagated with a point.
struct Vectors {
    names: Vec<String>,
    by: Vec<Sensitivity>,
    /// For each vector, k if it is the derivative by the initial value of variable k, else `None`.
    starts: Vec<Option<usize>>,
    variables: usize,
}

impl Vectors {
    /// Iterates over the entries of all vectors at the start, one vector after another.
    fn first<T: Float>(&self) -> impl Iterator<Item = T> {
        let vector = |start: &Option<usize>| {
            let start = *start;
            (0..self.variables).map(move |k| if start == Some(k) { T::one() } else { T::zero() })
        };
        self.starts.iter().flat_map(vector)
    }

    /// Copies each vector of a point to row `row` of its own array. Every array has `rows` rows.
    fn put<T: Float>(&self, vectors: &[T], derivatives: &mut [T], row: usize, rows: usize) {
        let n = self.variables.max(1);
        for (k, vector) in vectors.chunks_exact(n).enumerate() {
            derivatives[(k * rows + row) * n..][..n].copy_from_slice(vector);
        }
    }
}

impl Field {
    /// Returns the vectors for these names, in the order of the field.
    fn vectors(&self, asked: &[String]) -> Vectors {
        let study = self.study();
        let parameters = study.parameters().iter().enumerate();
        let variables = study.variables().iter().enumerate();
        let known = parameters
            .map(|(k, name)| (name.clone(), Sensitivity::Parameter(k), None))
            .chain([("eps".to_owned(), Sensitivity::Epsilon, None)])
            .chain(variables.map(|(k, name)| (name.clone(), Sensitivity::Start, Some(k))));
        let mut vectors =
            Vectors { names: Vec::new(), by: Vec::new(), starts: Vec::new(), variables: self.dimension() };
        for (name, by, start) in known.filter(|(name, ..)| asked.contains(name)) {
            vectors.names.push(name);
            vectors.by.push(by);
            vectors.starts.push(start);
        }
        vectors
    }

    fn along<'py, T: Float>(
        &self,
        rows: &PyReadonlyArrayDyn<'py, T>,
        vectors: &Vectors,
        asked: &SensitivityOptions<'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = rows.py();
        let at = self.at::<T>(py, asked.eps)?.composed(composition(asked.order)?).sensitivities(&vectors.by);
        if asked.compensated {
            carried(&at.compensated(), rows, vectors, asked)
        } else {
            carried(&at, rows, vectors, asked)
        }
    }

    /// Returns the derivatives of the last points; NaN if a number leaves the range of floats.
    fn at_the_end<'py, T: Float>(
        &self,
        points: &PyReadonlyArrayDyn<'py, T>,
        vectors: &Vectors,
        asked: &ensemble::EnsembleOptions<'_, 'py>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (py, shape) = (points.py(), points.shape());
        let many = self.many::<T>(py, shape, asked)?.sensitivities(&vectors.by);
        let (count, n) = (shape[0], self.dimension().max(1));
        let width = n * (1 + vectors.by.len());
        let first: Vec<T> = vectors.first().collect();
        let starts = points.as_slice()?.chunks_exact(n);
        let mut states: Vec<T> = starts.flat_map(|point| point.iter().chain(&first).copied()).collect();
        let run = |caller: &_| many.advance(&mut states, width, caller);
        run_watched(py, asked.threads, &asked.listener, run)?.map_err(|error| of_dimension(&error))?;
        let mut derivatives = vec![T::zero(); count * (width - n)];
        for (row, state) in states.chunks_exact(width).enumerate() {
            vectors.put(&state[n..], &mut derivatives, row, count);
        }
        Ok(PyArray1::from_vec(py, derivatives).reshape([vectors.by.len(), count, n])?.into_any())
    }
}

/// Propagates the vectors from row to row by the map `with`. At each row, the point is taken from
/// `rows`, because the computed point may differ by rounding.
fn carried<'py, S>(
    with: &S,
    rows: &PyReadonlyArrayDyn<'py, S::Scalar>,
    vectors: &Vectors,
    asked: &SensitivityOptions<'py>,
) -> PyResult<Bound<'py, PyAny>>
where
    S: Step<Scalar: Float> + Sync,
{
    let (py, n, count) = (rows.py(), vectors.variables.max(1), vectors.by.len());
    let given = rows.as_slice()?;
    let width = rows.shape().last().copied().unwrap_or(n).max(1);
    let rows = given.len() / width;
    let size = rows.checked_mul(n * count);
    let too_large = || {
        PyMemoryError::new_err(format!(
            "{rows} rows of {count} derivatives do not fit into memory; choose every, or fewer steps"
        ))
    };
    let mut derivatives: Vec<S::Scalar> = Vec::new();
    let size = size.filter(|size| derivatives.try_reserve_exact(*size).is_ok()).ok_or_else(too_large)?;
    derivatives.resize(size, S::Scalar::zero());
    // A state holds a point, its vectors, and, if compensated, the rounding error of each number.
    let mut state = vec![S::Scalar::zero(); with.dimension()];
    state.iter_mut().skip(n).zip(vectors.first()).for_each(|(own, first)| *own = first);
    let (every, behind) = (asked.every.get(), n * (1 + count));
    let steps = every.saturating_mul(rows as u64);
    let numbers = steps.saturating_mul(state.len() as u64);
    run_watched_if_long(py, numbers, &asked.listener, |caller| {
        let mut room = Workspace::new();
        for (row, point) in given.chunks_exact(width).enumerate() {
            vectors.put(&state[n..behind], &mut derivatives, row, rows);
            if row + 1 == rows {
                break;
            }
            state[..n].copy_from_slice(&point[..n]);
            state[behind..].iter_mut().zip(&point[n..]).for_each(|(own, carry)| *own = *carry);
            let mut left = every;
            while left > 0 {
                let now = left.min(MOMENT);
                // At a pole the vectors become infinite or NaN. The error is ignored, so that all
                // rows are written.
                let _ = with.advance(&mut state, now, &mut room);
                left -= now;
                if (now == MOMENT || row % MOMENT as usize == 0) && caller.made(now, steps).is_break() {
                    return;
                }
            }
        }
    })?;
    Ok(PyArray1::from_vec(py, derivatives).reshape([count, rows, n])?.into_any())
}
