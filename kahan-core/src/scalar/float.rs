//! The machine's floats as scalars.
//!
//! A reciprocal is always given (±∞ at ±0), so nothing branches on a value and nothing panics; poles show as
//! results that are not finite.

use super::{Constant, Pivot, Scalar};

macro_rules! implement_for_float {
    ($float:ty, $from_constant:ident) => {
        impl Scalar for $float {
            #[inline]
            fn constant(c: &Constant) -> Self {
                c.$from_constant()
            }

            #[inline]
            fn reciprocal(&self) -> Option<Self> {
                Some(1.0 / *self)
            }

            /// The larger magnitude, for stability; what is not a number is never better.
            #[inline]
            fn is_better_pivot(&self, than: &Self) -> bool {
                self.magnitude_exceeds(than)
            }

            #[inline]
            fn approximate(&self) -> f64 {
                (*self).into()
            }
        }

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
    };
}

implement_for_float!(f32, to_f32);
implement_for_float!(f64, to_f64);
