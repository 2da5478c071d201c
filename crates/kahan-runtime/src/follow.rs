//! One orbit of any map over floats, followed while its points are finite.
//!
//! In: a map, a point, a number of steps, and a function that may stop the run. Out: the last
//! point, how the orbit ended, and a report.

use core::num::NonZeroU64;
use core::ops::ControlFlow;

use kahan_core::observe::Observer;
use kahan_core::{FloatScalar, Scalar, Step, Workspace};

use crate::dimension::Argument;
use crate::{DimensionError, End};

/// The result of following an orbit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Followed<R> {
    /// For [`Follow::observe`] the observers' report, for [`Follow::rows`] the number of filled
    /// rows, and for [`Follow::follow`] `()`.
    pub report: R,
    /// The way in which the orbit ended, with the number of steps.
    pub end: End,
}

/// Follows an orbit from `x` while its points are finite.
///
/// All methods replace `x` by the last finite point, so that the next call continues from there.
/// Points equal those of single calls of [`Step::advance`] bit for bit. A run from a nonfinite
/// start makes no step and ends with [`End::Range`]`(0)`.
///
/// The `watch` receives the number of steps since its last call, and may stop the run by
/// [`ControlFlow::Break`]. Calls come every 4096 steps in up to eight variables, more often in more
/// variables, and after the last step.
///
/// Cost: the steps, a test of each shown point, and a copy of the point for each call of the watch.
/// ```
/// use std::ops::ControlFlow;
///
/// use kahan_core::observe::{Escape, Lyapunov};
/// use kahan_runtime::{End, Field, Follow};
///
/// let map = Field::parse("xdot = x^2 + 1;").unwrap().map().unwrap().at(0.05); // ε, half the time step
/// let mut x = [0.0];
/// let observers = (Lyapunov::new(&map), Escape::when(|x: &[f64]| x[0] > 5.0).ending());
/// let followed = map.observe(&mut x, 1000, observers, |_| ControlFlow::Continue(())).unwrap();
/// assert_eq!(followed.end, End::Stopped(followed.report.1.unwrap()));
/// assert!(x[0] > 5.0);
/// ```
pub trait Follow: Step<Scalar: FloatScalar> + Sized {
    /// Makes at most `steps` steps.
    ///
    /// # Errors
    /// [`DimensionError`] if the length of `x` is not the dimension of the map.
    fn follow(
        &self,
        x: &mut [Self::Scalar],
        steps: u64,
        watch: impl FnMut(u64) -> ControlFlow<()>,
    ) -> Result<Followed<()>, DimensionError> {
        check_state(self, x)?;
        Ok(Followed { report: (), end: run(self, x, [steps, steps], watch, |_, _| false) })
    }

    /// Makes at most `steps` steps, and shows points to observers: first `x`, as the point of step
    /// 0, then each finite point. The run ends when the observers are [done](Observer::is_done).
    ///
    /// # Errors
    /// [`DimensionError`] if the length of `x` is not the dimension of the map.
    fn observe<O: Observer<Self::Scalar>>(
        &self,
        x: &mut [Self::Scalar],
        steps: u64,
        mut observers: O,
        watch: impl FnMut(u64) -> ControlFlow<()>,
    ) -> Result<Followed<O::Report>, DimensionError> {
        check_state(self, x)?;
        observers.observe(0, x);
        let end = if observers.is_done() {
            End::Stopped(0)
        } else {
            run(self, x, [steps, 1], watch, |step, x| {
                observers.observe(step, x);
                observers.is_done()
            })
        };
        Ok(Followed { report: observers.report(), end })
    }

    /// Writes every `every`-th point after `x` into `rows`, one row after the other.
    ///
    /// The report is the number of filled rows; if the orbit is complete, all rows are filled. The
    /// remaining rows stay unchanged. The next call continues from the point of the last row.
    ///
    /// # Errors
    /// [`DimensionError`] for an `x` of a wrong length, or `rows` that are not whole rows.
    ///
    /// ```
    /// use std::num::NonZeroU64;
    /// use std::ops::ControlFlow;
    ///
    /// use kahan_runtime::{Field, Follow};
    ///
    /// let map = Field::parse("xdot = y; ydot = -x;").unwrap().map().unwrap().at(0.05);
    /// let (mut x, mut rows) = ([1.0, 0.0], [[0.0; 2]; 3]);
    /// let every = NonZeroU64::new(10).unwrap();
    /// map.rows(&mut x, every, rows.as_flattened_mut(), |_| ControlFlow::Continue(())).unwrap();
    /// assert!(rows[2] == x && (rows[0][0] - 1.0_f64.cos()).abs() < 1e-3);
    /// ```
    fn rows(
        &self,
        x: &mut [Self::Scalar],
        every: NonZeroU64,
        rows: &mut [Self::Scalar],
        watch: impl FnMut(u64) -> ControlFlow<()>,
    ) -> Result<Followed<usize>, DimensionError> {
        check_state(self, x)?;
        let entries = x.len().max(1);
        if !rows.len().is_multiple_of(entries) {
            return Err(DimensionError::new(Argument::Rows, rows.len(), entries));
        }
        let mut report = 0;
        let steps = every.get().saturating_mul((rows.len() / entries) as u64);
        let mut rows = rows.chunks_exact_mut(entries);
        let end = run(self, x, [steps, every.get()], watch, |_, x| {
            rows.next().into_iter().for_each(|row| row.copy_from_slice(x));
            report += 1;
            false
        });
        Ok(Followed { report, end })
    }
}

impl<S: Step<Scalar: FloatScalar> + Sized> Follow for S {}

fn check_state<S: Step>(map: &S, x: &[S::Scalar]) -> Result<(), DimensionError> {
    DimensionError::check(Argument::State, x.len(), map.dimension())
}

/// Returns the number of steps between two calls of the function that may stop the run.
pub(crate) fn pause(variables: usize) -> u64 {
    const MOST: u64 = 4096;
    const FEW: u64 = 8;
    (MOST * FEW.pow(2) / (variables as u64).saturating_pow(2).max(1)).clamp(1, MOST)
}

fn run<S: Step<Scalar: FloatScalar>>(
    map: &S,
    x: &mut [S::Scalar],
    [steps, every]: [u64; 2],
    mut watch: impl FnMut(u64) -> ControlFlow<()>,
    mut is_done: impl FnMut(u64, &[S::Scalar]) -> bool,
) -> End {
    if !is_finite(x) {
        return End::Range(0);
    }
    let (pause, mut workspace) = (pause(x.len()), Workspace::new());
    // Float steps continue past poles, so only a nonfinite point ends the run.
    let mut advance = |x: &mut [S::Scalar], steps| {
        let _ = map.advance(x, steps, &mut workspace);
    };
    let (mut made, mut left, mut before) = (0, every, x.to_vec());
    while made < steps {
        let first = made;
        let end = steps.min(first + pause);
        before.copy_from_slice(x);
        while made < end {
            let now = left.min(end - made);
            advance(x, now);
            if !is_finite(x) {
                x.copy_from_slice(&before);
                return End::Range(first + advance_while_finite(x, made + now - first, advance));
            }
            made += now;
            left -= now;
            if left == 0 {
                left = every;
                if is_done(made, x) {
                    return End::Stopped(made);
                }
            }
        }
        if watch(made - first).is_break() && made < steps {
            return End::Stopped(made);
        }
    }
    End::Complete
}

/// Returns whether |xᵢ| ≤ `size` for all i; `false` if an xᵢ is NaN.
#[inline]
pub(crate) fn is_within<T: Scalar>(x: &[T], size: f64) -> bool {
    // The loop has no early exit, so that the compiler vectorizes it.
    x.iter().fold(true, |all, x| all & (x.approximate().abs() <= size))
}

#[inline]
pub(crate) fn is_finite<T: Scalar>(x: &[T]) -> bool {
    is_within(x, f64::MAX)
}

/// Replaces `x` by the last finite point of its orbit, and returns the number of steps to this
/// point. The orbit must leave the range of floats within `steps` steps.
pub(crate) fn advance_while_finite<T: Scalar + Copy>(
    x: &mut [T],
    steps: u64,
    mut advance: impl FnMut(&mut [T], u64),
) -> u64 {
    let mut before = x.to_vec();
    let powers = (0..=steps.checked_ilog2().unwrap_or(0)).rev();
    // A binary search suffices, because nonfinite points stay nonfinite.
    powers.fold(0, |taken, power| {
        before.copy_from_slice(x);
        advance(x, 1 << power);
        if is_finite(x) {
            return taken + (1 << power);
        }
        x.copy_from_slice(&before);
        taken
    })
}
