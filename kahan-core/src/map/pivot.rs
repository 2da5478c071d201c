//! What a step that promises asks of a number: an order by magnitude, and whether it is finite.

use crate::{Dd, Scalar};

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
