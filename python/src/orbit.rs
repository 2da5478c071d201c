//! Steps and orbits of points in floats.

use std::num::NonZeroU64;

use kahan_core::{Composition, Increments, SingularStep, Step};
use kahan_runtime::{DimensionError, End, Follow, Followed, RuntimeFloat};
use kahan_study::{LiftedStep, RowSchedule, Study};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::exceptions::{PyMemoryError, PyValueError};
use pyo3::prelude::*;

use crate::arrays::{Eps, Floats, doubles, floats, half_step, named, out as writable};
use crate::background::{Listener, run_watched, run_watched_if_long};
use crate::errors::{of_dimension, of_study, singular_step};
use crate::field::{Field, Float};

/// The largest number of values that are computed without a check for signals.
const MOMENT: usize = 1 << 14;

#[pymethods]
impl Field {
    /// Returns the points one time step of 2 eps later.
    #[pyo3(signature = (x, eps = None, *, dt = None, out = None))]
    fn step<'py>(
        slf: &Bound<'py, Self>,
        x: &Bound<'py, PyAny>,
        eps: Option<&Bound<'py, PyAny>>,
        dt: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        slf.get().stepped(&named(x, slf, "x")?, half_step(eps, dt)?, out, false)
    }

    /// Returns the points one time step later. The error is at most 64 units in the last place of
    /// the largest component. If there is no such point, raises `SingularStep` with the reason.
    #[pyo3(signature = (x, eps = None, *, dt = None, out = None))]
    fn try_step<'py>(
        slf: &Bound<'py, Self>,
        x: &Bound<'py, PyAny>,
        eps: Option<&Bound<'py, PyAny>>,
        dt: Option<&Bound<'py, PyAny>>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        slf.get().stepped(&named(x, slf, "x")?, half_step(eps, dt)?, out, true)
    }

    /// Follows an orbit. Returns the rows, the number of steps, how the orbit ended, and why.
    #[pyo3(name = "_points", signature = (x, eps, steps, *, transient = 0, every = 1, order = 2, compensated = false, reembed = false, out = None, listener = None))]
    #[expect(clippy::too_many_arguments, reason = "Python names them")]
    fn points<'py>(
        &self,
        x: &Bound<'py, PyAny>,
        eps: f64,
        steps: u64,
        transient: u64,
        every: u64,
        order: u32,
        compensated: bool,
        reembed: bool,
        out: Option<&Bound<'py, PyAny>>,
        listener: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Rows<'py>> {
        let asked = OrbitOptions {
            eps,
            steps,
            transient,
            every,
            order,
            compensated,
            reembed,
            listener: Listener(listener),
        };
        match floats(x, "x")? {
            Floats::Double(x) => self.rows(&x, &asked, out),
            Floats::Single(x) => self.rows(&x, &asked, out),
        }
    }

    /// Computes the field or its Jacobian at points. `parameters` replace the field's own values.
    #[pyo3(name = "_field_at", signature = (x, *, parameters = Vec::new(), jacobian = false))]
    fn field_at<'py>(
        &self,
        x: &Bound<'py, PyAny>,
        parameters: Vec<Option<f64>>,
        jacobian: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = x.py();
        let (x, at) = (doubles(x, "x")?, self.valued(py, &parameters)?);
        let n = at.dimension();
        if x.shape().last() != Some(&n) {
            return Err(self.wrong_points("x", &["…"], x.shape()));
        }
        let (points, mut sizes) = (x.as_slice()?, x.shape().to_vec());
        let width = if jacobian { n * n } else { n };
        sizes.extend(jacobian.then_some(n));
        let mut values = vec![0.0; points.len() / n.max(1) * width];
        for (x, values) in points.chunks_exact(n.max(1)).zip(values.chunks_exact_mut(width.max(1))) {
            let found = if jacobian { at.field_jacobian(x, values) } else { at.field(x, values) };
            found.map_err(|error| of_dimension(&error))?;
        }
        Ok(PyArray1::from_vec(py, values).reshape(sizes)?.into_any())
    }

    /// Returns the names of the claimed integrals, and their values along the last axis.
    #[pyo3(name = "_integrals_at")]
    fn integrals_at<'py>(
        &self,
        x: &Bound<'py, PyAny>,
        eps: Eps,
    ) -> PyResult<(Vec<String>, Bound<'py, PyAny>)> {
        let py = x.py();
        let (x, at) = (doubles(x, "x")?, self.with_integrals(py, eps.0)?);
        let (n, names) = (at.dimension().max(1), at.map().field().integrals());
        let mut sizes = x.shape().to_vec();
        if sizes.pop() != Some(at.dimension()) {
            return Err(self.wrong_points("x", &["…"], x.shape()));
        }
        let points = x.as_slice()?;
        let mut values = vec![0.0; points.len() / n * names.len()];
        for (x, values) in points.chunks_exact(n).zip(values.chunks_exact_mut(names.len().max(1))) {
            at.integrals(x, values).map_err(|error| of_dimension(&error))?;
        }
        sizes.push(names.len());
        Ok((names.to_vec(), PyArray1::from_vec(py, values).reshape(sizes)?.into_any()))
    }
}

/// The reason why a point has no image.
enum NoStep {
    Dimension(DimensionError),
    /// A singular step, with the index of the point.
    Singular(usize, SingularStep),
}

struct OrbitOptions<'py> {
    eps: f64,
    steps: u64,
    transient: u64,
    every: u64,
    order: u32,
    compensated: bool,
    reembed: bool,
    listener: Listener<'py>,
}

/// The rows of an orbit, the number of steps, how the orbit ended, and why.
type Rows<'py> = (Bound<'py, PyAny>, u64, &'static str, Option<String>);

impl Field {
    fn stepped<'py>(
        &self,
        x: &Bound<'py, PyAny>,
        eps: f64,
        out: Option<&Bound<'py, PyAny>>,
        checked: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        if self.study().lift().is_some() {
            return self.stepped_between(x, eps, out, checked);
        }
        self.stepped_whole(x, eps, out, checked)
    }

    /// Makes a step of a lifted field from each point in `x`, after adding the new variables.
    fn stepped_between<'py>(
        &self,
        x: &Bound<'py, PyAny>,
        eps: f64,
        out: Option<&Bound<'py, PyAny>>,
        checked: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = x.py();
        let single = matches!(floats(x, "x")?, Floats::Single(_));
        let all = self.embedded(x, Vec::new(), None)?;
        let all = if single { all.call_method1("astype", ("float32",))? } else { all };
        let next = self.stepped_whole(&all, eps, None, checked)?;
        let shown = next.call_method1("take", (self.places(), -1))?;
        let Some(out) = out else { return Ok(shown) };
        py.import("numpy")?.call_method1("copyto", (out, shown))?;
        Ok(out.clone())
    }

    fn stepped_whole<'py>(
        &self,
        x: &Bound<'py, PyAny>,
        eps: f64,
        out: Option<&Bound<'py, PyAny>>,
        checked: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        // The input is copied first, since the result may overwrite it.
        let copied = out.filter(|out| out.is(x)).map(|x| x.call_method0("copy")).transpose()?;
        match floats(copied.as_ref().unwrap_or(x), "x")? {
            Floats::Double(x) => self.next(&x, eps, out, checked),
            Floats::Single(x) => self.next(&x, eps, out, checked),
        }
    }

    fn next<'py, T: Float>(
        &self,
        x: &Bound<'py, PyArrayDyn<T>>,
        eps: f64,
        out: Option<&Bound<'py, PyAny>>,
        checked: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = x.py();
        let at = self.at::<T>(py, eps)?;
        let x = x.readonly();
        let (points, n) = (x.as_slice()?, at.dimension());
        if x.shape().last() != Some(&n) {
            return Err(self.wrong_points("x", &["…"], x.shape()));
        }
        let step = |next: &mut [T], is_stopped: &dyn Fn() -> bool| {
            for (place, (x, next)) in
                points.chunks_exact(n.max(1)).zip(next.chunks_exact_mut(n.max(1))).enumerate()
            {
                if place % MOMENT == 0 && is_stopped() {
                    break;
                }
                if !checked {
                    at.step(x, next).expect("a point has an entry a variable");
                    continue;
                }
                let tried = at.map().try_step(x, at.eps(), next).map_err(NoStep::Dimension)?;
                tried.map_err(|why| NoStep::Singular(place, why))?;
            }
            Ok(())
        };
        let run = |next: &mut [T]| {
            let stepped = if points.len() > MOMENT {
                run_watched(py, Some(1), &Listener(None), |caller| step(next, &|| caller.wants_no_more()))?
            } else {
                step(next, &|| false)
            };
            stepped.map_err(|why| match why {
                NoStep::Dimension(error) => of_dimension(&error),
                NoStep::Singular(_, why) if x.ndim() == 1 => singular_step(py, &why.to_string()),
                NoStep::Singular(place, why) => singular_step(py, &format!("point {place}: {why}")),
            })
        };
        if let Some(out) = out {
            let mut next = writable::<T>(out, x.shape())?;
            run(next.as_slice_mut()?)?;
            return Ok(out.clone());
        }
        let mut next = vec![T::zero(); points.len()];
        run(&mut next)?;
        let next = PyArray1::from_vec(py, next);
        Ok(if x.ndim() == 1 { next.into_any() } else { next.reshape(x.shape())?.into_any() })
    }

    fn rows<'py, T: Float>(
        &self,
        x: &Bound<'py, PyArrayDyn<T>>,
        asked: &OrbitOptions<'py>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Rows<'py>> {
        let py = x.py();
        let composition = composition(asked.order)?;
        let at = self.at::<T>(py, asked.eps)?.composed(composition);
        let n = at.dimension();
        if x.shape() != [n] {
            return Err(self.wrong_points("x", &[], x.shape()));
        }
        let mut x = x.readonly().as_slice()?.to_vec();
        let numbers =
            [("eps", at.eps().approximate())].into_iter().chain(x.iter().map(|x| ("x", x.approximate())));
        for (name, number) in numbers {
            if !number.is_finite() {
                return Err(PyValueError::new_err(format!("{name}: {number} is no number to compute with")));
            }
        }
        let study = self.study();
        if asked.reembed && (asked.compensated || T::PRECISION != f64::PRECISION) {
            return Err(PyValueError::new_err("reembed is for points in float64, without compensated"));
        }
        study.can_reembed(asked.reembed).map_err(|error| of_study(py, &error))?;
        if asked.compensated {
            let at = at.compensated();
            x.resize(2 * n, T::zero());
            return match study.lifted_step(&at) {
                Some(step) => follow_lifted(py, &step, x, study, asked, out),
                None => follow(py, &at, x, asked, out).map(of_map),
            };
        }
        match study.steps(&at, asked.reembed) {
            Some(step) => follow_lifted(py, &step, x, study, asked, out),
            None => follow(py, &at, x, asked, out).map(of_map),
        }
    }
}

fn of_map<'py, T>((rows, _, end, steps): Orbit<'py, T>) -> Rows<'py> {
    (rows, end.steps(steps), end.name(), None)
}

fn follow_lifted<'py, S>(
    py: Python<'py>,
    step: &LiftedStep<'_, S>,
    x: Vec<S::Scalar>,
    study: &Study,
    asked: &OrbitOptions<'py>,
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<Rows<'py>>
where
    S: Step<Scalar: Float> + Sync,
{
    let (rows, last, end, steps) = follow(py, step, x, asked, out)?;
    let end = step.end(end, &last);
    let why = end.is_early().then(|| step.ends(&last)).flatten();
    let why = why.map(|why| why.in_words(study, end.steps(steps)));
    Ok((rows, end.steps(steps), end.name(), why))
}

/// The rows of an orbit, its last point, how it ended, and the requested number of steps.
type Orbit<'py, T> = (Bound<'py, PyAny>, Vec<T>, End, u64);

fn follow<'py, S>(
    py: Python<'py>,
    at: &S,
    mut x: Vec<S::Scalar>,
    asked: &OrbitOptions<'py>,
    out: Option<&Bound<'py, PyAny>>,
) -> PyResult<Orbit<'py, S::Scalar>>
where
    S: Follow<Scalar: Float> + Sync,
{
    let paces = RowSchedule { transient: asked.transient, steps: asked.steps, every: stride(asked.every)? };
    let (rows, width, in_all) = (room(&paces)?, x.len(), paces.in_all());
    let mut run = |all: &mut [S::Scalar]| -> PyResult<Followed<usize>> {
        let numbers = in_all.saturating_mul(width as u64);
        run_watched_if_long(py, numbers, &asked.listener, |caller| {
            paces.follow(at, &mut x, all, |made| caller.made(made, in_all))
        })?
        .map_err(|error| of_dimension(&error))
    };
    let (array, followed) = match out {
        Some(out) => {
            let mut array = writable::<S::Scalar>(out, &[rows, width])?;
            let followed = run(array.as_slice_mut()?)?;
            (out.clone(), followed)
        }
        None => {
            let mut all = zeros(rows.checked_mul(width), &paces)?;
            let followed = run(&mut all)?;
            let array: Bound<'py, PyArray2<S::Scalar>> = all.into_pyarray(py).reshape([rows, width])?;
            (array.into_any(), followed)
        }
    };
    let made = followed.report;
    let array = if made == rows {
        array
    } else {
        array.get_item(pyo3::types::PySlice::new(py, 0, made as isize, 1))?
    };
    Ok((array, x, followed.end, in_all))
}

/// Checks that the number of steps between rows is not 0.
pub(crate) fn stride(every: u64) -> PyResult<NonZeroU64> {
    NonZeroU64::new(every).ok_or_else(|| PyValueError::new_err("every must be 1 or more"))
}

/// Returns the number of rows of an orbit; fails if it exceeds the range of an index.
pub(crate) fn room(paces: &RowSchedule) -> PyResult<usize> {
    let rows = usize::try_from(paces.rows()).ok().filter(|rows| *rows < usize::MAX);
    rows.ok_or_else(|| too_long(paces))
}

/// Allocates zeros for rows; fails if memory does not suffice.
pub(crate) fn zeros<T: Float>(length: Option<usize>, paces: &RowSchedule) -> PyResult<Vec<T>> {
    let (length, mut all) = (length.ok_or_else(|| too_long(paces))?, Vec::new());
    all.try_reserve_exact(length).map_err(|_| too_long(paces))?;
    all.resize(length, T::zero());
    Ok(all)
}

fn too_long(paces: &RowSchedule) -> PyErr {
    let points = paces.steps / paces.every;
    PyMemoryError::new_err(format!("{points} points do not fit into memory; choose every, or fewer steps"))
}

pub(crate) fn composition(order: u32) -> PyResult<Composition> {
    Composition::of_order(order)
        .ok_or_else(|| PyValueError::new_err(format!("order {order} is not there; choose 2, 4, 6 or 8")))
}

pub(crate) fn wrong_shape(name: &str, wanted: &str, found: &[usize]) -> PyErr {
    let found = shown(found);
    PyValueError::new_err(format!(
        "{name}: the shape {wanted} is needed, with a coordinate for each variable, and this is {found}"
    ))
}

/// Writes the shape of an array as Python does.
fn shown(shape: &[usize]) -> String {
    match shape {
        [one] => format!("({one},)"),
        _ => format!("({})", shape.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")),
    }
}
