//! A double and its magnitude in one register of two lanes: then a bound costs no operation more than the value alone.

use core::arch::x86_64::{
    __m128d, _mm_add_pd, _mm_cvtsd_f64, _mm_mul_pd, _mm_set_pd, _mm_unpackhi_pd, _mm_xor_pd,
};

use super::pair::Pair;

/// Runs intrinsics of two lanes.
macro_rules! machine {
    ($expression:expr) => {
        // SAFETY: registers of two doubles (SSE2) are part of every x86-64 processor; the fused operation is compiled only where
        // the whole program is compiled for FMA. Nothing here touches memory.
        #[allow(unsafe_code, reason = "compilers do not pair values and magnitudes by themselves")]
        unsafe {
            $expression
        }
    };
}

/// The value in the low lane, the magnitude in the high one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Packed(__m128d);

impl Pair<f64> for Packed {
    #[inline(always)]
    fn new(value: f64, magnitude: f64) -> Self {
        Self(machine!(_mm_set_pd(magnitude, value)))
    }

    #[inline(always)]
    fn value(self) -> f64 {
        machine!(_mm_cvtsd_f64(self.0))
    }

    #[inline(always)]
    fn magnitude(self) -> f64 {
        machine!(_mm_cvtsd_f64(_mm_unpackhi_pd(self.0, self.0)))
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self(machine!(_mm_add_pd(self.0, other.0)))
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        self.plus(other.negated())
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        Self(machine!(_mm_mul_pd(self.0, other.0)))
    }

    #[inline(always)]
    fn negated(self) -> Self {
        Self(machine!(_mm_xor_pd(self.0, _mm_set_pd(0.0, -0.0))))
    }

    #[cfg(all(feature = "std", target_feature = "fma"))]
    #[inline(always)]
    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        Self(machine!(core::arch::x86_64::_mm_fmadd_pd(self.0, factor.0, addend.0)))
    }

    #[cfg(not(all(feature = "std", target_feature = "fma")))]
    #[inline(always)]
    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        self.times(factor).plus(addend)
    }
}
