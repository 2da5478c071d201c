//! What a step that promises asks of a number: an order by magnitude, and whether it is finite.
//!
//! In: a scalar. Out: the way its promise is kept, chosen while compiling: by bounds for the floats of this crate, by looking at the
//! result for all others.

use nalgebra::SVector;

use crate::{Dd, Scalar, SingularStep};

use super::checked::try_step;
use super::lift::Lift;
use super::stable::{stable_double, stable_double_double, stable_single};

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

    /// The step with the promise that this scalar can give; here, that a finite result is what the fast step or elimination
    /// computes.
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
}

/// A float: finite numbers and |·| are its own, the promise is kept by bounds.
macro_rules! implement_for_float {
    ($float:ty, $stable:ident) => {
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
                map: &M,
                _prepared: &M::Prepared,
                x: &SVector<Self, N>,
                eps: &Self,
            ) -> Result<SVector<Self, N>, SingularStep>
            where
                M: Lift<Self, N>,
            {
                $stable(map, x, eps)
            }
        }
    };
}

implement_for_float!(f32, stable_single);
implement_for_float!(f64, stable_double);
implement_for_float!(Dd, stable_double_double);

#[cfg(feature = "exact")]
impl Pivot for num_rational::BigRational {
    fn magnitude_exceeds(&self, other: &Self) -> bool {
        num_traits::Signed::abs(self) > num_traits::Signed::abs(other)
    }

    fn is_finite_number(&self) -> bool {
        true
    }
}
