//! One orbit of any map over floats, followed as far as it goes.
//!
//! In: a map, a point, how many steps, and a watch that may stop the run. Out: the last point, how
//! the orbit ended after how many steps, and what was asked on the way: nothing, observers, or rows
//! of points. It must not know what a map is made of: chains, maps of
//! texts and compiled ones are followed by the same loop.

use core::num::NonZeroU64;
use core::ops::ControlFlow;

use kahan_core::observe::Observer;
use kahan_core::{FloatScalar, Scalar, Step, Workspace};

use crate::dimension::Argument;
use crate::{DimensionError, End};

/// How far an orbit was followed, and what came of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Followed<R> {
    /// What was asked on the way.
    pub report: R,
    /// How it ended, and after how many steps.
    pub end: End,
}

/// Follows an orbit from `x`, step after step, while its points are finite.
///
/// All calls replace `x` by the last point that is finite, so that a call can go on where another
/// ended. Points have the bits that [`Step::advance`] gives them one by one. A start that is not
/// finite is the last point, after no step: [`End::Range`]`(0)`.
///
/// `watch` is told of the steps made since it was asked last, and stops the run by
/// [`ControlFlow::Break`]. It is asked every 4096 steps in up to eight variables, and after fewer
/// steps in more, whose steps take longer; and after the last step. There it can show progress,
/// read a clock or a flag: nothing else interrupts a run.
///
/// Cost: that of the steps, a look at each point that is shown, and a copy of the point each time
/// that the watch is asked. Where an orbit leaves the range, the steps since then are made up to
/// three times.
///
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
    /// At most so many steps, of which nothing is asked.
    ///
    /// # Errors
    /// [`DimensionError`] if `x` has not as many entries as a state of the map.
    fn follow(
        &self,
        x: &mut [Self::Scalar],
        steps: u64,
        watch: impl FnMut(u64) -> ControlFlow<()>,
    ) -> Result<Followed<()>, DimensionError> {
        check_state(self, x)?;
        Ok(Followed { report: (), end: run(self, x, [steps, steps], watch, |_, _| false) })
    }

    /// At most so many steps, shown to observers: `x` as it is, as the point of step 0, and the
    /// points after it as far as they are finite. Observers that are
    /// [done](Observer::is_done) end the run at that point.
    ///
    /// # Errors
    /// [`DimensionError`] if `x` has not as many entries as a state of the map.
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

    /// Writes every `every`-th point that follows `x` into `rows`, one after the other: the first
    /// row is the point after so many steps. The report is how many rows were filled, all of them
    /// where the orbit is complete; the others stay as they are. The next call goes on behind the
    /// last row.
    ///
    /// # Errors
    /// [`DimensionError`] if `x` has not as many entries as a state of the map, or `rows` is not a
    /// whole number of states.
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

/// The steps between two looks of the watch: they take some milliseconds at most.
pub(crate) fn pause(variables: usize) -> u64 {
    const MOST: u64 = 4096;
    const FEW: u64 = 8;
    (MOST * FEW.pow(2) / (variables as u64).saturating_pow(2).max(1)).clamp(1, MOST)
}

/// Makes at most so many steps, and shows every `every`-th point until `is_done` says so: how it
/// ended.
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
    // Floats go on at poles.
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

/// Whether no number of a point is larger than this, nor is one not a number.
#[inline]
pub(crate) fn is_within<T: Scalar>(x: &[T], size: f64) -> bool {
    // Without a way out in the middle, so that registers hold several numbers.
    x.iter().fold(true, |all, x| all & (x.approximate().abs() <= size))
}

/// Whether all numbers of a point are finite.
#[inline]
pub(crate) fn is_finite<T: Scalar>(x: &[T]) -> bool {
    is_within(x, f64::MAX)
}

/// Replaces `x`, of which it is known that so many steps lead out of the range, by the last point
/// that is finite: how many steps lead there.
pub(crate) fn advance_while_finite<T: Scalar + Copy>(
    x: &mut [T],
    steps: u64,
    mut advance: impl FnMut(&mut [T], u64),
) -> u64 {
    let mut before = x.to_vec();
    let powers = (0..=steps.checked_ilog2().unwrap_or(0)).rev();
    // What is not finite stays so: the steps that are left to take are a sum of powers of 2.
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
