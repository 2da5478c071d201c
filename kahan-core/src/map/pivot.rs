//! What a step that promises asks of a number: an order by magnitude, and whether it is finite.
//!
//! In: a scalar. Out: the way its promise is kept, chosen while compiling: by bounds for the floats
//! of this crate, by looking at the result for all others.

use nalgebra::SVector;

use crate::{Dd, KahanMap, Scalar, SingularStep};

use super::checked::try_step;
use super::coupled::{CoupledField, CoupledStep, in_double_double, in_wide_only};
use super::lift::Lift;
use super::stable::{beyond, higher, in_next_wider, in_own_precision, in_wide};

/// A scalar ordered by magnitude that can tell whether it is a finite number; what
/// [`try_step`](crate::KahanMap::try_step) needs to judge a result.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot judge whether a step is finite",
    label = "not a `Pivot`; for a number, write `1.0`, not `1`",
    note = "`step` and `orbit` need `Scalar` only"
)]
pub trait Pivot: Scalar {
    /// Whether |self| > |other|; false if either is not a number.
    fn magnitude_exceeds(&self, other: &Self) -> bool;

    /// Whether this is a number and not infinite; always true for exact scalars.
    fn is_finite_number(&self) -> bool;

    /// The step with the promise that this scalar can give; here, that a finite result is what the
    /// fast step or elimination computes.
    #[doc(hidden)]
    fn stable_step<M, const N: usize>(
        map: &M,
        prepared: &M::Prepared,
        x: &SVector<Self, N>,
        eps: &Self,
    ) -> Result<SVector<Self, N>, SingularStep>
    where
        M: Lift<Self, N>,
    {
        try_step(map, prepared, x, eps)
    }

    /// The same for many variables, where the promise is of the backward error.
    #[doc(hidden)]
    fn backward_stable_step<F, K, const N: usize, const P: usize, const M: usize, const S: usize>(
        map: &F,
        prepared: &CoupledStep<K, Self, P, M, S>,
        x: &SVector<Self, N>,
        eps: &Self,
    ) -> Result<SVector<Self, N>, SingularStep>
    where
        F: KahanMap<Self, N, Prepared = CoupledStep<K, Self, P, M, S>>,
        K: CoupledField<N, P, M, S>,
    {
        try_step(map, prepared, x, eps)
    }
}

/// A float, whose promise is kept by bounds: by a first rung, or where that proves too little by
/// the next.
///
/// A rung prepares the step anew, over values with bounds: a prepared float does not tell how large
/// the terms of a sum were that it is. In a loop compilers do that once, before its first round.
macro_rules! implement_for_float {
    ($float:ty: |$map:ident, $x:ident, $eps:ident| $first:expr, else $next:expr, of_many $many:expr) => {
        impl Pivot for $float {
            #[inline]
            fn magnitude_exceeds(&self, other: &Self) -> bool {
                self.abs() > other.abs()
            }

            #[inline]
            fn is_finite_number(&self) -> bool {
                self.is_finite()
            }

            #[inline(always)]
            fn stable_step<M, const N: usize>(
                $map: &M,
                _prepared: &M::Prepared,
                $x: &SVector<Self, N>,
                $eps: &Self,
            ) -> Result<SVector<Self, N>, SingularStep>
            where
                M: Lift<Self, N>,
            {
                match $first {
                    Some(next) => Ok(next),
                    None => higher($next, $map, $x, $eps),
                }
            }

            fn backward_stable_step<F, K, const N: usize, const P: usize, const M: usize, const S: usize>(
                _map: &F,
                prepared: &CoupledStep<K, Self, P, M, S>,
                x: &SVector<Self, N>,
                _eps: &Self,
            ) -> Result<SVector<Self, N>, SingularStep>
            where
                F: KahanMap<Self, N, Prepared = CoupledStep<K, Self, P, M, S>>,
                K: CoupledField<N, P, M, S>,
            {
                $many(prepared, x)
            }
        }
    };
}

/// The variables up to which `f32` works for itself. Steps in more variables multiply so many
/// factors that products of ordinary numbers leave its range, and nearly every step would be
/// computed in `f64` after all.
const MOST_OF_SINGLE: usize = 4;

implement_for_float!(f32: |map, x, eps| if const { N > MOST_OF_SINGLE } {
    in_next_wider(map, x, eps)
} else {
    in_own_precision(map, x, eps)
}, else if const { N > MOST_OF_SINGLE } { in_wide } else { beyond }, of_many in_double_double);
implement_for_float!(f64: |map, x, eps| in_own_precision(map, x, eps), else beyond, of_many in_double_double);
implement_for_float!(Dd: |map, x, eps| in_own_precision(map, x, eps), else in_wide, of_many in_wide_only);

#[cfg(feature = "exact")]
impl Pivot for num_rational::BigRational {
    fn magnitude_exceeds(&self, other: &Self) -> bool {
        num_traits::Signed::abs(self) > num_traits::Signed::abs(other)
    }

    fn is_finite_number(&self) -> bool {
        true
    }
}
