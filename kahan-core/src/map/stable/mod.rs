//! The step that promises: an error of at most 64 u of the largest component, or an error value.
//!
//! In: a map, a point and ε as given. Out: x̃ with ‖x̃ − exact‖∞ ≤ 64 u ‖exact‖∞, established for
//! this very call, or why not. There is one way to establish it and one formula for the step: the
//! kernel of the fast step runs over bounded values, first in the scalar's own precision, and where
//! that is too little in wider ones. Nothing is estimated from thresholds.
//!
//! | rung | values | what it settles |
//! |---|---|---|
//! | 1 | the scalar itself; not for `f32` in more than four variables | ordinary points, at less than twice the operations of a step |
//! | 2 | `f64` for `f32`, [`Dd`](crate::Dd) for `f64`; `Dd` has none | cancellation: near poles, large ε |
//! | 3 | 17 digits of 64 bits, wherever these lie | overflow, underflow, extreme cancellation, by the increment form |
//! | 4 | the same | the form N/D, where increments cancel against the state |
//! | 5 | 256 digits, with `std` | elimination on A(x,ε), where terms of the other forms are too far apart |
//!
//! The way down: [`stable_step`] tells which scalar it is, [`climb`] takes its rungs in their order
//! (`rungs.rs`), a rung makes an [`Attempt`](attempt::Attempt), and that runs the prepared step.

mod attempt;
mod rungs;
mod scalars;
#[cfg(all(test, feature = "exact"))]
mod tests;

use core::array::from_fn;

use nalgebra::SVector;

use crate::field::linear::vector;
use crate::scalar::bounded::Bounded;
use crate::scalar::tuning::{divides_by_eps, is, may_divide_by, same};
use crate::{Dd, ExtendScalars, Pivot, SingularStep};

use super::checked::checked_step;

use rungs::{in_general_form, in_next_wider, in_own_precision, in_wide, second};
pub(crate) use scalars::Promised;
#[cfg(feature = "std")]
pub(crate) use scalars::{Eliminated, eliminated_at_any_capacity};

/// The step with the promise that T can give: of a float of this crate the one above; of another
/// scalar, that a finite result is what the fast step or elimination computes.
///
/// Floats ignore `prepared`, whose numbers are rounded and carry no bound: each rung prepares the
/// step anew over values with bounds. In a loop compilers do that once, before its first round.
#[inline(always)]
pub fn stable_step<M: ExtendScalars<T, N>, T: Pivot, const N: usize>(
    map: &M,
    prepared: &M::Prepared,
    x: &SVector<T, N>,
    eps: &T,
) -> Result<SVector<T, N>, SingularStep> {
    // Which scalar it is, is known while compiling.
    if is::<T, f64>() {
        climb::<f64, M, T, N>(map, x, eps)
    } else if is::<T, f32>() {
        climb::<f32, M, T, N>(map, x, eps)
    } else if is::<T, Dd>() {
        climb::<Dd, M, T, N>(map, x, eps)
    } else {
        checked_step(map, prepared, x, eps)
    }
}

/// Takes the rungs of F, the type that T is, in their order: the first is compiled into the caller,
/// the others are called.
///
/// A function that is called reads and writes memory. It is given a copy of the state, and x̃ is
/// copied out of what it wrote, so that the state of a loop, and x̃ of the first rung, can stay in
/// registers: ordinary steps do not wait for memory on account of a call that they do not make.
#[inline(always)]
fn climb<F: Promised, M: ExtendScalars<T, N>, T: Pivot, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
) -> Result<SVector<T, N>, SingularStep> {
    let map = map.extend_scalars(|number| *same::<T, F>(number));
    let (x, eps): (&SVector<F, N>, &F) = (same(x), same(eps));
    let first = if const { N > F::MOST_VARIABLES } {
        in_next_wider(&map, x, eps)
    } else if divides_by_eps::<F>() && !may_divide_by(&Bounded::<F>::given(*eps)) {
        // The limits are those of bounded values, which are narrower than those of floats: with two
        // different limits compilers would keep the code of both forms in every step.
        in_general_form(&map, vector(from_fn(|i| x[i])), *eps)
    } else {
        in_own_precision(&map, x, eps)
    };
    let next = if let Some(next) = first {
        next
    } else {
        let mut next: SVector<F, N> = vector(from_fn(|i| x[i]));
        higher(&map, next, *eps, &mut next)?;
        vector(from_fn(|i| next[i]))
    };
    Ok(same::<SVector<F, N>, SVector<T, N>>(&next).clone())
}

/// Takes the rungs behind the first one; x̃ goes to `next`.
#[cold]
#[inline(never)]
fn higher<M: ExtendScalars<T, N>, T: Promised, const N: usize>(
    map: &M,
    x: SVector<T, N>,
    eps: T,
    next: &mut SVector<T, N>,
) -> Result<(), SingularStep> {
    if const { !T::IS_WIDEST && N <= T::MOST_VARIABLES }
        && let Some(settled) = second(map, &x, &eps)
    {
        *next = settled;
        return Ok(());
    }
    in_wide(map, x, eps, next)
}
