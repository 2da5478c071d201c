//! Returns points along many trajectories, bit for bit as if each orbit were computed alone.

use std::sync::{Mutex, PoisonError};

use kahan_runtime::{DimensionError, End, threads};
use kahan_study::{RowSchedule, Study, Watch};
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::arrays::{Floats, floats};
use crate::background::{Caller, Listener, run_watched};
use crate::ensemble::{Ends, EnsembleOptions, ThreadColumns, Trajectories, ends};
use crate::errors::{of_dimension, of_study};
use crate::field::{Field, Float};
use crate::orbit::{room, stride, zeros};

/// The number of trajectories that a thread computes together, so that the rows fit into its cache.
const TOGETHER: usize = 128;

#[pymethods]
impl Field {
    /// Follows many trajectories. Returns the points of shape (trajectories, rows, variables), how
    /// the trajectories ended, and their numbers of steps.
    #[pyo3(name = "_series", signature = (points, eps, steps, *, every, transient = 0, parameters = Vec::new(), order = 2, reembed = false, threads = None, listener = None))]
    #[expect(clippy::too_many_arguments, reason = "Python names them")]
    fn series<'py>(
        &self,
        points: &Bound<'py, PyAny>,
        eps: &Bound<'py, PyAny>,
        steps: u64,
        every: u64,
        transient: u64,
        parameters: Vec<Option<Bound<'py, PyAny>>>,
        order: u32,
        reembed: bool,
        threads: Option<usize>,
        listener: Option<Bound<'py, PyAny>>,
    ) -> PyResult<(Bound<'py, PyAny>, Ends<'py>)> {
        let in_all = transient.saturating_add(steps);
        let asked =
            EnsembleOptions { eps, steps: in_all, parameters, order, threads, listener: Listener(listener) };
        let paces = RowSchedule { transient, steps, every: stride(every)? };
        match floats(points, "points")? {
            Floats::Double(points) => self.shown(&points, &asked, &paces, reembed),
            Floats::Single(points) => self.shown(&points, &asked, &paces, reembed),
        }
    }
}

impl Field {
    fn shown<'py, T: Float>(
        &self,
        points: &Bound<'py, PyArrayDyn<T>>,
        asked: &EnsembleOptions<'_, 'py>,
        paces: &RowSchedule,
        reembed: bool,
    ) -> PyResult<(Bound<'py, PyAny>, Ends<'py>)> {
        let py = points.py();
        let points = points.readonly();
        let (many, shape) = (self.many::<T>(py, points.shape(), asked)?, points.shape());
        let study = self.study();
        study.can_reembed(reembed).map_err(|error| of_study(py, &error))?;
        let rows = room(paces)?;
        let mut to = zeros(rows.checked_mul(points.len()), paces)?;
        let from = points.as_slice()?;
        let found = run_watched(py, asked.threads, &asked.listener, |caller| {
            many.series(from, &mut to, study, (paces, reembed), caller)
        })?
        .map_err(|error| of_dimension(&error))?;
        let series = PyArray1::from_vec(py, to).reshape([shape[0], rows, shape[1]])?;
        Ok((series.into_any(), ends(py, asked.steps, shape[0], found.into_iter())))
    }
}

impl<T: Float> Trajectories<T> {
    /// Writes the rows of the schedule `paces` for all trajectories, and NaN after an early end.
    fn series(
        &self,
        from: &[T],
        to: &mut [T],
        study: &Study,
        (paces, reembed): (&RowSchedule, bool),
        caller: &Caller,
    ) -> Result<Vec<End>, DimensionError> {
        let width = study.variables().len().max(1);
        let rows = paces.rows() as usize;
        let room = rows * width;
        let pieces: Vec<_> = from.chunks(TOGETHER * width).zip(to.chunks_mut(TOGETHER * room)).collect();
        let pieces: Vec<Mutex<_>> = pieces.into_iter().map(Mutex::new).collect();
        let found = threads::map(pieces.len(), Some(caller.threads()), |index| {
            let mut piece = pieces[index].lock().unwrap_or_else(PoisonError::into_inner);
            let (from, to) = &mut *piece;
            let first = index * TOGETHER;
            let single = |k: usize, from: &[T], to: &mut [T]| {
                self.trajectory(first + k, from, to, study, (paces, reembed), caller)
            };
            if reembed {
                let one_by_one = from.chunks_exact(width).zip(to.chunks_exact_mut(room)).enumerate();
                return one_by_one.map(|(k, (from, to))| single(k, from, to)).collect();
            }
            let mut piece = ThreadColumns::of(self, from, width, first, caller);
            piece.advance(paces.transient)?;
            for row in 0..rows {
                piece.advance(if row == 0 { 0 } else { paces.every.get() })?;
                piece.put(to.chunks_exact_mut(room).map(|rows| &mut rows[row * width..][..width]));
            }
            piece.advance(self.steps - piece.made)?;
            let beyond = piece.beyond(study);
            let mut ends = piece.ends()?;
            for k in beyond {
                ends[k] = single(k, &from[k * width..][..width], &mut to[k * room..][..room])?;
            }
            Ok(ends)
        });
        Ok(found.into_iter().collect::<Result<Vec<Vec<End>>, _>>()?.concat())
    }

    /// Follows one trajectory of a lifted field up to its end, and writes its points.
    pub(crate) fn trajectory(
        &self,
        k: usize,
        from: &[T],
        to: &mut [T],
        study: &Study,
        (paces, reembed): (&RowSchedule, bool),
        caller: &Caller,
    ) -> Result<End, DimensionError> {
        let own = |values: &[T]| if values.len() > 1 { k..k + 1 } else { 0..values.len() };
        let parameters: Vec<&[T]> = self.constants.iter().map(|values| &values[own(values)]).collect();
        let maps = self.at.each(&self.eps[own(&self.eps)], &parameters)?;
        let step = study.steps(&maps[0], reembed).expect("a field that was lifted");
        let mut x = from.to_vec();
        to.fill(T::near(f64::NAN));
        let followed = paces.follow(&step, &mut x, to, |steps| self.made(steps, 1, caller))?;
        Ok(step.end(followed.end, &x))
    }
}
