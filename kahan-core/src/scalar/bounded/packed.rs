//! A float and its magnitude in one vector register. One instruction adds or multiplies both.

use core::arch::x86_64::{
    __m128, __m128d, _mm_add_pd, _mm_add_ps, _mm_cvtsd_f64, _mm_cvtss_f32, _mm_move_ss, _mm_mul_pd,
    _mm_mul_ps, _mm_set_pd, _mm_set_ps, _mm_set_ss, _mm_set1_ps, _mm_shuffle_ps, _mm_unpackhi_pd, _mm_xor_pd,
    _mm_xor_ps,
};
#[cfg(all(feature = "std", target_feature = "fma"))]
use core::arch::x86_64::{_mm_fmadd_pd, _mm_fmadd_ps};

use super::pair::BoundedPair;

macro_rules! machine {
    ($expression:expr) => {
        // SAFETY: SSE2 registers of two doubles or four floats exist on every x86-64 processor.
        // Fused operations are compiled only if the whole program is compiled for them. No memory
        // is accessed.
        #[allow(unsafe_code, reason = "compilers do not pair values and magnitudes by themselves")]
        unsafe {
            $expression
        }
    };
}

/// Defines a pair in a register. The lowest lane holds the value, the next lane its magnitude.
macro_rules! packed {
    (
        $(#[$docs:meta])*
        $name:ident($register:ty) of $float:ty:
        new: |$value:ident, $magnitude:ident| $new:expr,
        value: $low:ident,
        magnitude: |$whole:ident| $next:expr,
        sign: $sign:expr,
        operations: $plus:ident, $times:ident, $xor:ident, $fused:ident
    ) => {
        $(#[$docs])*
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct $name($register);

        impl BoundedPair<$float> for $name {
            #[inline(always)]
            fn new($value: $float, $magnitude: $float) -> Self {
                Self(machine!($new))
            }

            #[inline(always)]
            fn value(self) -> $float {
                machine!($low(self.0))
            }

            #[inline(always)]
            fn magnitude(self) -> $float {
                let $whole = self.0;
                machine!($low($next))
            }

            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                Self(machine!($plus(self.0, other.0)))
            }

            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                self.plus(other.negated())
            }

            #[inline(always)]
            fn times(self, other: Self) -> Self {
                Self(machine!($times(self.0, other.0)))
            }

            #[inline(always)]
            fn negated(self) -> Self {
                Self(machine!($xor(self.0, $sign)))
            }

            #[cfg(all(feature = "std", target_feature = "fma"))]
            #[inline(always)]
            fn multiply_add(self, factor: Self, addend: Self) -> Self {
                Self(machine!($fused(self.0, factor.0, addend.0)))
            }

            #[cfg(not(all(feature = "std", target_feature = "fma")))]
            #[inline(always)]
            fn multiply_add(self, factor: Self, addend: Self) -> Self {
                self.times(factor).plus(addend)
            }
        }
    };
}

packed! {
    PackedDouble(__m128d) of f64:
    new: |value, magnitude| _mm_set_pd(magnitude, value),
    value: _mm_cvtsd_f64,
    magnitude: |pair| _mm_unpackhi_pd(pair, pair),
    sign: _mm_set_pd(0.0, -0.0),
    operations: _mm_add_pd, _mm_mul_pd, _mm_xor_pd, _mm_fmadd_pd
}

packed! {
    /// A float and its magnitude. Unused lanes repeat the magnitude; other contents could be
    /// subnormal numbers, which are slow.
    PackedSingle(__m128) of f32:
    new: |value, magnitude| _mm_move_ss(_mm_set1_ps(magnitude), _mm_set_ss(value)),
    value: _mm_cvtss_f32,
    magnitude: |pair| _mm_shuffle_ps::<0b01_01_01_01>(pair, pair),
    sign: _mm_set_ps(0.0, 0.0, 0.0, -0.0),
    operations: _mm_add_ps, _mm_mul_ps, _mm_xor_ps, _mm_fmadd_ps
}
