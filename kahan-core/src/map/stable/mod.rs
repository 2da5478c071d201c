//! The stable step, with an error of at most 64 u of the largest component, or an error value.
//!
//! In: a map, a point and ε. Out: x̃ with ‖x̃ − exact‖∞ ≤ 64 u ‖exact‖∞, proved for this call, or
//! the reason for failure. The step is computed with error bounds on each value, in these rungs:
//!
//! | rung | values | what it settles |
//! |---|---|---|
//! | 1 | the scalar; not for `f32` in more than four variables | ordinary points |
//! | 2 | `f64` for `f32`, [`Dd`](crate::Dd) for `f64` | cancellation: near poles, large ε |
//! | 3 | 17 digits of 64 bits at arbitrary positions | over- and underflow, extreme cancellation |
//! | 4 | as 3, in the form N/D | increments that cancel against the state |
//! | 5 | up to 256 digits, with `std`, by elimination | terms too far apart for the other forms |
//!
//! Calls: [`stable_step`] selects the scalar, [`climb`] takes the rungs in order (`rungs.rs`), and
//! each rung makes an [`Attempt`](attempt::Attempt), which runs the prepared step.

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

/// Steps with the bound that T permits: 64 u for floats of this crate; for other scalars, a finite
/// result of the fast step or of elimination.
///
/// Floats ignore `prepared`, whose numbers are rounded without a bound: each rung prepares the step
/// over bounded values. In a loop compilers hoist the preparation.
#[inline(always)]
pub fn stable_step<M: ExtendScalars<T, N>, T: Pivot, const N: usize>(
    map: &M,
    prepared: &M::Prepared,
    x: &SVector<T, N>,
    eps: &T,
) -> Result<SVector<T, N>, SingularStep> {
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

/// Takes the rungs of F, a type identical to T: the first is inlined, the others are called.
///
/// A called function works in memory. The state is copied for it and x̃ copied out, so a loop's
/// state and the x̃ of the first rung can stay in registers.
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
        // The limits are those of bounded values, which are narrower than those of floats. With two
        // limits compilers would keep the code of both forms in every step.
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

/// Takes the rungs after the first; writes x̃ to `next`.
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
