//! `f32` and `f64` as scalars.
//!
//! Every number has a reciprocal, which is ±∞ at ±0. Results at poles are therefore infinite or
//! NaN. Multiply-adds are fused only with the feature `std`, in programs compiled for x86 with the
//! target feature `fma`.

use super::{Constant, Scalar};

/// Computes a·b + c, rounded once, by `mul_add`, which requires the standard library.
#[cfg(all(feature = "std", target_feature = "fma"))]
macro_rules! fused_or_not {
    ($a:expr, $b:expr, $c:expr) => {
        ($a).mul_add($b, $c)
    };
}

/// Computes a·b + c, rounded twice.
#[cfg(not(all(feature = "std", target_feature = "fma")))]
macro_rules! fused_or_not {
    ($a:expr, $b:expr, $c:expr) => {
        $a * $b + $c
    };
}

macro_rules! implement_for_float {
    ($float:ty, $from_constant:ident) => {
        impl Scalar for $float {
            #[inline]
            fn constant(c: &Constant<'_>) -> Self {
                c.$from_constant()
            }

            #[inline]
            fn reciprocal(&self) -> Option<Self> {
                Some(1.0 / *self)
            }

            /// Prefers larger magnitudes, which keep elimination stable. A NaN is never better.
            #[inline]
            fn is_better_pivot(&self, than: &Self) -> bool {
                self.abs() > than.abs()
            }

            #[inline(always)]
            fn multiply_add(self, factor: Self, addend: Self) -> Self {
                fused_or_not!(self, factor, addend)
            }

            #[inline(always)]
            fn multiply_subtract(self, factor: Self, subtrahend: Self) -> Self {
                fused_or_not!(self, factor, -subtrahend)
            }

            #[inline(always)]
            fn subtract_product(self, a: Self, b: Self) -> Self {
                fused_or_not!(-a, b, self)
            }

            #[inline]
            fn approximate(&self) -> f64 {
                (*self).into()
            }
        }
    };
}

implement_for_float!(f32, to_f32);
implement_for_float!(f64, to_f64);
