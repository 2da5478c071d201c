//! Scalars that can be compared by magnitude and tested for finiteness.

use crate::{Dd, Scalar};

/// A scalar with comparison by magnitude, which [`try_step`](crate::KahanMap::try_step) requires.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot judge whether a step is finite",
    label = "not a `Pivot`; for a number, write `1.0`, not `1`",
    note = "`step` and `orbit` need `Scalar` only"
)]
pub trait Pivot: Scalar {
    /// Returns whether |self| > |other|, which is false for NaN.
    fn magnitude_exceeds(&self, other: &Self) -> bool;

    /// Returns whether the number is neither NaN nor infinite.
    fn is_finite_number(&self) -> bool;
}

macro_rules! implement_for_float {
    ($($float:ty),*) => {$(
        impl Pivot for $float {
            #[inline]
            fn magnitude_exceeds(&self, other: &Self) -> bool {
                self.abs() > other.abs()
            }

            #[inline]
            fn is_finite_number(&self) -> bool {
                self.is_finite()
            }
        }
    )*};
}

implement_for_float!(f32, f64, Dd);

#[cfg(feature = "exact")]
impl Pivot for num_rational::BigRational {
    fn magnitude_exceeds(&self, other: &Self) -> bool {
        num_traits::Signed::abs(self) > num_traits::Signed::abs(other)
    }

    fn is_finite_number(&self) -> bool {
        true
    }
}
