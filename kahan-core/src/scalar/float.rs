//! `f32` and `f64` as scalars.
//!
//! Every number has a reciprocal (±∞ at ±0), so nothing branches or panics; results at poles are
//! infinite or NaN. A multiply-add is two operations, with equal bits on every processor, except in
//! programs compiled for x86-64 with the target feature `fma`, which fuse it.

use super::{Constant, Scalar};

/// a·b + c, rounded once; `mul_add` needs the standard library.
#[cfg(all(feature = "std", target_feature = "fma"))]
macro_rules! fused_or_not {
    ($a:expr, $b:expr, $c:expr) => {
        ($a).mul_add($b, $c)
    };
}

/// a·b + c, rounded twice.
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

            /// Prefers the larger magnitude, for stability; NaN is never better.
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
