//! Follows many trajectories, by default on all processors.

use std::mem::discriminant;
use std::num::NonZeroU64;
use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use kahan_runtime::{DimensionError, End, Followed, MapAt, Sensitivity, threads};
use kahan_study::{Observable, Observe, RowSchedule, Study, Watch};
use numpy::{PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{Floats, doubles, floats, out as writable};
use crate::background::{Caller, Listener, run_watched};
use crate::errors::{of_dimension, of_study};
use crate::field::{Field, Float};
use crate::orbit::composition;

/// The number of trajectories that a thread computes together, so that they fit into its cache.
const TOGETHER: usize = 1024;
/// The number of steps, summed over all trajectories, between two checks for signals.
const AT_ONCE: u64 = 1 << 22;
/// The number of steps, summed over all trajectories, between two reports.
const TOLD: u64 = 1 << 18;

#[pymethods]
impl Field {
    /// Advances many trajectories by `steps` steps. Returns the last points, how the trajectories
    /// ended, and their numbers of steps.
    #[pyo3(name = "_advance", signature = (points, eps, steps, *, parameters = Vec::new(), order = 2, threads = None, out = None, listener = None))]
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
    ) -> PyResult<(Bound<'py, PyAny>, Ends<'py>)> {
        let asked = EnsembleOptions { eps, steps, parameters, order, threads, listener: Listener(listener) };
        match floats(points, "points")? {
            Floats::Double(points) => self.advanced(&points, &asked, out),
            Floats::Single(points) => self.advanced(&points, &asked, out),
        }
    }

    /// Computes observables. Returns their names, a row for each trajectory, and the orbits' ends.
    #[pyo3(name = "_observed", signature = (points, eps, steps, of, *, parameters = Vec::new(), order = 2, transient = 0, renormalize = 10, spectrum = None, escape = None, reembed = false, threads = None, listener = None))]
    #[expect(clippy::too_many_arguments, reason = "Python names them")]
    fn observed<'py>(
        &self,
        points: &Bound<'py, PyAny>,
        eps: &Bound<'py, PyAny>,
        steps: u64,
        of: Vec<String>,
        parameters: Vec<Option<Bound<'py, PyAny>>>,
        order: u32,
        transient: u64,
        renormalize: u64,
        spectrum: Option<usize>,
        escape: Option<f64>,
        reembed: bool,
        threads: Option<usize>,
        listener: Option<Bound<'py, PyAny>>,
    ) -> PyResult<(Vec<String>, Bound<'py, PyArray2<f64>>, Ends<'py>)> {
        let py = points.py();
        let of = of.iter().map(|name| {
            let unknown = || PyValueError::new_err(format!("observe: there is no `{name}`"));
            Observable::named(name).ok_or_else(unknown)
        });
        let of = of.collect::<PyResult<Vec<_>>>()?;
        if renormalize == 0 || spectrum == Some(0) {
            let name = if renormalize == 0 { "renormalize" } else { "spectrum" };
            return Err(PyValueError::new_err(format!("{name} must be 1 or more")));
        }
        let asked = EnsembleOptions { eps, steps, parameters, order, threads, listener: Listener(listener) };
        let points = doubles(points, "points")?;
        let many = self.many::<f64>(py, points.shape(), &asked)?;
        let observe = Observe { transient, renormalize, spectrum, escape, reembed, ..Observe::of(of, steps) };
        observe.composition(self.study()).map_err(|error| of_study(py, &error))?;
        let names: Vec<String> =
            observe.columns(self.study()).into_iter().map(|column| column.name).collect();
        let (count, from) = (points.shape()[0], points.as_slice()?);
        let seen = run_watched(py, asked.threads, &asked.listener, |caller| {
            many.observed(from, self.study(), &observe, caller)
        })?;
        let seen = seen.map_err(|error| of_dimension(&error))?;
        let in_all = transient.saturating_add(steps);
        let ends = ends(py, in_all, count, seen.iter().map(|followed| followed.end));
        let numbers: Vec<f64> = seen.into_iter().flat_map(|followed| followed.report).collect();
        let numbers = PyArray1::from_vec(py, numbers).reshape([count, names.len()])?;
        Ok((names, numbers, ends))
    }
}

pub(crate) struct EnsembleOptions<'a, 'py> {
    pub(crate) eps: &'a Bound<'py, PyAny>,
    pub(crate) steps: u64,
    pub(crate) parameters: Vec<Option<Bound<'py, PyAny>>>,
    pub(crate) order: u32,
    pub(crate) threads: Option<usize>,
    pub(crate) listener: Listener<'py>,
}

impl Field {
    /// Prepares the map, ε and the parameters of many trajectories. Their points have this shape.
    pub(crate) fn many<T: Float>(
        &self,
        py: Python<'_>,
        shape: &[usize],
        asked: &EnsembleOptions<'_, '_>,
    ) -> PyResult<Trajectories<T>> {
        if shape.len() != 2 || shape[1] != self.dimension() {
            return Err(self.wrong_points("points", &["trajectories"], shape));
        }
        let eps = constants::<T>(asked.eps, shape[0], "eps")?;
        let values = asked.parameters.iter().enumerate().map(|(k, given)| match given {
            Some(given) => constants::<T>(given, shape[0], self.parameter(k)),
            None => Ok(Vec::new()),
        });
        let mut values = values.collect::<PyResult<Vec<Vec<T>>>>()?;
        // The map needs one value for each parameter, even for varying parameters.
        let at: MapAt<T> = self.map_with(py, &values)?.at(eps.first().copied().unwrap_or_else(T::zero));
        let at = at.composed(composition(asked.order)?);
        for (own, values) in at.map().parameters().iter().zip(&mut values) {
            if values.is_empty() {
                values.push(T::near(own.to_f64()));
            }
        }
        Ok(Trajectories { at, eps, constants: values, steps: asked.steps, trajectories: shape[0] })
    }

    fn advanced<'py, T: Float>(
        &self,
        points: &Bound<'py, PyArrayDyn<T>>,
        asked: &EnsembleOptions<'_, 'py>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<(Bound<'py, PyAny>, Ends<'py>)> {
        let py = points.py();
        let points = points.readonly();
        let (many, shape) = (self.many::<T>(py, points.shape(), asked)?, points.shape());
        let from = points.as_slice()?;
        let run = |to: &mut [T]| {
            to.copy_from_slice(from);
            run_watched(py, asked.threads, &asked.listener, |caller| {
                let mut ends = many.advance(to, self.dimension(), caller)?.concat();
                many.end_lifted(from, to, &mut ends, self.study(), caller)?;
                Ok(ends)
            })?
            .map_err(|error: DimensionError| of_dimension(&error))
        };
        let (to, found) = match out {
            Some(out) => {
                let found = run(writable::<T>(out, shape)?.as_slice_mut()?)?;
                (out.clone(), found)
            }
            None => {
                let mut to = vec![T::zero(); from.len()];
                let found = run(&mut to)?;
                (PyArray1::from_vec(py, to).reshape(shape)?.into_any(), found)
            }
        };
        Ok((to, ends(py, asked.steps, shape[0], found.into_iter())))
    }
}

/// Many trajectories of one field.
pub(crate) struct Trajectories<T: Float> {
    pub(crate) at: MapAt<T>,
    pub(crate) eps: Vec<T>,
    /// For each parameter one value, or one per trajectory; empty if the map's values are used.
    pub(crate) constants: Vec<Vec<T>>,
    pub(crate) steps: u64,
    trajectories: usize,
}

impl<T: Float> Trajectories<T> {
    /// Returns the trajectories with derivative vectors added to each point.
    pub(crate) fn sensitivities(&self, by: &[Sensitivity]) -> Self {
        let (at, mut constants) = (self.at.sensitivities(by), self.constants.clone());
        if by.contains(&Sensitivity::Epsilon) {
            let missing = constants.len()..self.at.map().parameters().len();
            let own = |k: usize| vec![T::near(self.at.map().parameters()[k].to_f64())];
            constants.extend(missing.map(own));
            // The equations of derivatives with respect to ε have 1/ε as their last parameter.
            constants.push(self.eps.iter().map(|eps| T::one() / *eps).collect());
        }
        Trajectories { at, eps: self.eps.clone(), constants, ..*self }
    }

    /// Reports that each of `trajectories` trajectories made `steps` more steps.
    pub(crate) fn made(&self, steps: u64, trajectories: usize, caller: &Caller) -> ControlFlow<()> {
        let all = self.steps.saturating_mul(self.trajectories as u64);
        caller.made(steps.saturating_mul(trajectories as u64), all)
    }

    /// Advances points that are stored row by row. Returns how each trajectory ended.
    pub(crate) fn advance(
        &self,
        rows: &mut [T],
        variables: usize,
        caller: &Caller,
    ) -> Result<Vec<Vec<End>>, DimensionError> {
        let width = variables.max(1);
        let pieces: Vec<Mutex<&mut [T]>> = rows.chunks_mut(TOGETHER * width).map(Mutex::new).collect();
        let found = threads::map(pieces.len(), Some(caller.threads()), |piece| {
            let mut rows = pieces[piece].lock().unwrap_or_else(PoisonError::into_inner);
            self.piece(&mut rows, width, piece * TOGETHER, caller)
        });
        found.into_iter().collect()
    }

    /// Repeats the trajectories that left the lift's domain, to find the step at which each left.
    fn end_lifted(
        &self,
        from: &[T],
        to: &mut [T],
        ends: &mut [End],
        study: &Study,
        caller: &Caller,
    ) -> Result<(), DimensionError> {
        let Some(step) = study.lifted_step(&self.at) else { return Ok(()) };
        let last = RowSchedule { transient: self.steps, steps: 0, every: NonZeroU64::MIN };
        let width = study.variables().len();
        let rows = from.chunks_exact(width).zip(to.chunks_exact_mut(width)).zip(ends);
        for (k, ((from, to), end)) in rows.enumerate().filter(|(_, ((_, to), _))| step.is_beyond(to)) {
            *end = self.trajectory(k, from, to, study, (&last, false), caller)?;
        }
        Ok(())
    }

    /// Advances the trajectories of one thread, whose numbers begin with `first`.
    fn piece(
        &self,
        rows: &mut [T],
        width: usize,
        first: usize,
        caller: &Caller,
    ) -> Result<Vec<End>, DimensionError> {
        let mut piece = ThreadColumns::of(self, rows, width, first, caller);
        piece.advance(self.steps)?;
        piece.put(rows.chunks_exact_mut(width));
        piece.ends()
    }
}

pub(crate) struct ThreadColumns<'a, T: Float> {
    many: &'a Trajectories<T>,
    columns: Vec<Vec<T>>,
    eps: &'a [T],
    parameters: Vec<&'a [T]>,
    caller: &'a Caller,
    /// The end of each trajectory, or `Complete` if it goes on; empty before the first step.
    ends: Vec<End>,
    /// The number of steps made so far. The last `untold` of them are not yet reported as progress.
    pub(crate) made: u64,
    untold: u64,
}

impl<'a, T: Float> ThreadColumns<'a, T> {
    /// Loads the trajectories that begin at these rows; the first of them has the number `first`.
    pub(crate) fn of(
        many: &'a Trajectories<T>,
        rows: &[T],
        width: usize,
        first: usize,
        caller: &'a Caller,
    ) -> Self {
        let count = rows.len() / width;
        let mut columns = vec![vec![T::zero(); count]; width];
        for (k, row) in rows.chunks_exact(width).enumerate() {
            columns.iter_mut().zip(row).for_each(|(column, x)| column[k] = *x);
        }
        let own = |values: &'_ [T]| -> std::ops::Range<usize> {
            if values.len() > 1 { first..first + count } else { 0..values.len() }
        };
        let eps = &many.eps[own(&many.eps)];
        let parameters = many.constants.iter().map(|values| &values[own(values)]).collect();
        ThreadColumns { many, columns, eps, parameters, caller, ends: Vec::new(), made: 0, untold: 0 }
    }

    pub(crate) fn advance(&mut self, steps: u64) -> Result<(), DimensionError> {
        let count = self.columns.first().map_or(0, Vec::len);
        let at_once = (AT_ONCE / count as u64).max(1);
        let mut left = steps;
        while left > 0 && !self.caller.wants_no_more() {
            let steps = left.min(at_once);
            self.follow(steps)?;
            left -= steps;
            self.untold += steps;
            if self.untold.saturating_mul(count as u64) >= TOLD {
                let _ = self.many.made(std::mem::take(&mut self.untold), count, self.caller);
            }
        }
        Ok(())
    }

    fn follow(&mut self, steps: u64) -> Result<(), DimensionError> {
        let mut slices: Vec<&mut [T]> = self.columns.iter_mut().map(Vec::as_mut_slice).collect();
        let found = self.many.at.follow_columns(&mut slices, self.eps, &self.parameters, steps)?;
        self.ends = together(&self.ends, found, self.made);
        self.made += steps;
        Ok(())
    }

    /// Writes the current points, one trajectory to each row.
    pub(crate) fn put<'r>(&self, rows: impl Iterator<Item = &'r mut [T]>)
    where
        T: 'r,
    {
        for (k, row) in rows.enumerate() {
            row.iter_mut().zip(&self.columns).for_each(|(x, column)| *x = column[k]);
        }
    }

    /// Returns the indices of the trajectories of a lifted field that have left the lift's domain.
    pub(crate) fn beyond(&self, study: &Study) -> Vec<usize> {
        let Some(step) = study.lifted_step(&self.many.at) else { return Vec::new() };
        let count = self.columns.first().map_or(0, Vec::len);
        let point = |k: usize| self.columns.iter().map(|column| column[k]).collect::<Vec<T>>();
        (0..count).filter(|k| step.is_beyond(&point(*k))).collect()
    }

    /// Returns how each trajectory ended. Before the first step, a trajectory has ended only if its
    /// initial point is not finite.
    pub(crate) fn ends(mut self) -> Result<Vec<End>, DimensionError> {
        if self.made == 0 {
            self.follow(0)?;
        }
        let count = self.columns.first().map_or(0, Vec::len);
        let _ = self.many.made(self.untold, count, self.caller);
        Ok(self.ends)
    }
}

impl Trajectories<f64> {
    fn observed(
        &self,
        rows: &[f64],
        study: &Study,
        asked: &Observe,
        caller: &Caller,
    ) -> Result<Vec<Followed<Vec<f64>>>, DimensionError> {
        let width = study.variables().len().max(1);
        let together = (AT_ONCE / asked.steps_in_all().max(1)).clamp(16, 256) as usize;
        let pieces: Vec<&[f64]> = rows.chunks(together * width).collect();
        let seen = threads::map(pieces.len(), Some(caller.threads()), |piece| {
            if caller.wants_no_more() {
                return Ok(Vec::new());
            }
            let (rows, first) = (pieces[piece], piece * together);
            let count = rows.len() / width;
            let starts: Vec<Vec<f64>> =
                (0..width).map(|k| rows.iter().skip(k).step_by(width).copied().collect()).collect();
            let own = |values: &[f64]| if values.len() > 1 { first..first + count } else { 0..values.len() };
            let parameters: Vec<&[f64]> = self.constants.iter().map(|values| &values[own(values)]).collect();
            let maps = self.at.each(&self.eps[own(&self.eps)], &parameters)?;
            let maps: Vec<&MapAt<f64>> = (0..count).map(|orbit| &maps[orbit.min(maps.len() - 1)]).collect();
            let of = asked.steps_in_all().saturating_mul(self.trajectories as u64);
            Ok(asked.of_orbits(study, &maps, &starts, &|steps| caller.made(steps, of)))
        });
        Ok(seen.into_iter().collect::<Result<Vec<_>, _>>()?.concat())
    }
}

/// The names of the ends that occur, the index of the name for each trajectory, and its steps.
pub(crate) type Ends<'py> = (Vec<&'static str>, Bound<'py, PyArray1<u8>>, Bound<'py, PyArray1<i64>>);

pub(crate) fn ends(py: Python<'_>, steps: u64, count: usize, ends: impl Iterator<Item = End>) -> Ends<'_> {
    let mut kinds: Vec<End> = Vec::new();
    let (mut places, mut made) = (Vec::with_capacity(count), Vec::with_capacity(count));
    for end in ends {
        made.push(end.steps(steps) as i64);
        let known = kinds.iter().position(|kind| discriminant(kind) == discriminant(&end));
        places.push(known.unwrap_or(kinds.len()) as u8);
        if known.is_none() {
            kinds.push(end);
        }
    }
    let words = kinds.into_iter().map(End::name).collect();
    (words, PyArray1::from_vec(py, places), PyArray1::from_vec(py, made))
}

/// Combines `before`, the ends in the first `steps` steps, with `more`, the ends in later steps.
fn together(before: &[End], more: Vec<End>, steps: u64) -> Vec<End> {
    if before.is_empty() {
        return more;
    }
    let own = |(k, end): (usize, End)| match before.get(k) {
        Some(ended) if *ended != End::Complete => *ended,
        _ => end.after(steps),
    };
    more.into_iter().enumerate().map(own).collect()
}

/// Reads one number, or one number for each trajectory.
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
