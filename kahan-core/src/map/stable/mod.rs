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

mod attempt;
mod rungs;
mod scalars;
#[cfg(all(test, feature = "exact"))]
mod tests;

use nalgebra::SVector;

use crate::scalar::tuning::{is, same};
use crate::{Dd, ExtendScalars, Pivot, SingularStep};

use super::checked::try_step;

pub(crate) use scalars::Promised;
pub(super) use scalars::Widened;

/// The step with the promise that T can give: of a float of this crate the one above; of another
/// scalar, that a finite result is what the fast step or elimination computes.
///
/// A rung prepares the step anew, over values with bounds: prepared floats are rounded, and carry
/// no bound. In a loop compilers do that once, before its first round.
#[inline(always)]
pub fn stable_step<M, T, const N: usize>(
    map: &M,
    prepared: &M::Prepared,
    x: &SVector<T, N>,
    eps: &T,
) -> Result<SVector<T, N>, SingularStep>
where
    M: ExtendScalars<T, N>,
    T: Pivot,
{
    // Which scalar it is, is known while compiling.
    if is::<T, f64>() {
        in_own_type::<f64, M, T, N>(map, x, eps)
    } else if is::<T, f32>() {
        in_own_type::<f32, M, T, N>(map, x, eps)
    } else if is::<T, Dd>() {
        in_own_type::<Dd, M, T, N>(map, x, eps)
    } else {
        try_step(map, prepared, x, eps)
    }
}

/// Calls the step of F, the type that T is.
#[inline(always)]
fn in_own_type<F, M, T, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
) -> Result<SVector<T, N>, SingularStep>
where
    F: Promised,
    M: ExtendScalars<T, N>,
    T: Pivot,
{
    let own = map.extend_scalars(|number| *same::<T, F>(number));
    let next = F::promised(&own, same(x), same(eps))?;
    Ok(same::<SVector<F, N>, SVector<T, N>>(&next).clone())
}
