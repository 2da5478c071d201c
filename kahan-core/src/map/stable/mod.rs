//! The stable step, which proves a bound of its error.
//!
//! Over `f32`, `f64` and `Dd` the result is an x̃ with ‖x̃ − exact‖∞ ≤ 64 u ‖exact‖∞, or the reason
//! for failure. Here u is the rounding unit. Error bounds are computed at increasing precision
//! levels.
//!
//! # Precision levels
//! | level | numbers | suffices for |
//! |---|---|---|
//! | 1 | the scalar itself (`f32` only with at most four variables) | ordinary points |
//! | 2 | `f64` for `f32`, [`Dd`](crate::Dd) for `f64` | cancellation: near poles, large ε |
//! | 3 | floating point with 17 × 64 bits | overflow, underflow, extreme cancellation |
//! | 4 | the numbers of level 3, in the form N/D | increments that cancel against the state |
//! | 5 | up to 256 × 64 bits, with `std`, by elimination | terms that differ in size too much |
//!
//! [`try_precisions`] tries the levels in order.

mod bounded_step;
mod precisions;
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

use precisions::{in_general_form, in_next_wider, in_own_precision, second_precision, wide_precisions};
pub(crate) use scalars::PromiseScalar;
#[cfg(feature = "std")]
pub(crate) use scalars::{LongElimination, eliminated_at_any_capacity};

/// Takes a step with the error bound 64u over floats of this crate, where u is the rounding unit.
/// Other scalars get a finite result without a bound.
///
/// Floats ignore `prepared`, whose rounding errors are unknown. They prepare the step again with
/// error bounds; compilers move this preparation out of a loop over steps.
#[inline(always)]
pub fn stable_step<M: ExtendScalars<T, N>, T: Pivot, const N: usize>(
    map: &M,
    prepared: &M::Prepared,
    x: &SVector<T, N>,
    eps: &T,
) -> Result<SVector<T, N>, SingularStep> {
    if is::<T, f64>() {
        try_precisions::<f64, M, T, N>(map, x, eps)
    } else if is::<T, f32>() {
        try_precisions::<f32, M, T, N>(map, x, eps)
    } else if is::<T, Dd>() {
        try_precisions::<Dd, M, T, N>(map, x, eps)
    } else {
        checked_step(map, prepared, x, eps)
    }
}

/// Tries the precision levels. F and T are the same type, but only F has the bound `PromiseScalar`.
///
/// Only the first level is inlined. The other levels get copies of the state, so that a loop can
/// keep the state in registers.
#[inline(always)]
fn try_precisions<F: PromiseScalar, M: ExtendScalars<T, N>, T: Pivot, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
) -> Result<SVector<T, N>, SingularStep> {
    let map = map.extend_scalars(|number| *same::<T, F>(number));
    let (x, eps): (&SVector<F, N>, &F) = (same(x), same(eps));
    let first = if const { N > F::MOST_VARIABLES } {
        in_next_wider(&map, x, eps)
    } else if divides_by_eps::<F>() && !may_divide_by(&Bounded::<F>::from_input(*eps)) {
        // Outside the range for divisions by ε, the general formula is used. If a step made this
        // test, its code would contain both formulas.
        in_general_form(&map, vector(from_fn(|i| x[i])), *eps)
    } else {
        in_own_precision(&map, x, eps)
    };
    let next = if let Some(next) = first {
        next
    } else {
        let mut next: SVector<F, N> = vector(from_fn(|i| x[i]));
        try_wider_precisions(&map, next, *eps, &mut next)?;
        vector(from_fn(|i| next[i]))
    };
    Ok(same::<SVector<F, N>, SVector<T, N>>(&next).clone())
}

/// Tries the precision levels after the first, and writes x̃ to `next`.
#[cold]
#[inline(never)]
fn try_wider_precisions<M: ExtendScalars<T, N>, T: PromiseScalar, const N: usize>(
    map: &M,
    x: SVector<T, N>,
    eps: T,
    next: &mut SVector<T, N>,
) -> Result<(), SingularStep> {
    if const { !T::IS_WIDEST && N <= T::MOST_VARIABLES }
        && let Some(settled) = second_precision(map, &x, &eps)
    {
        *next = settled;
        return Ok(());
    }
    wide_precisions(map, x, eps, next)
}
