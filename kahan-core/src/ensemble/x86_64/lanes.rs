//! Scalars over x86-64 vector registers. Most operations are one instruction on all lanes.
//!
//! AVX2 and AVX-512 fuse multiply-adds. SSE2 fuses them only in programs compiled for fused
//! multiply-adds. The operator `==` returns whether all lanes are equal.
#![allow(
    unused_unsafe,
    reason = "where the whole program is compiled for the instructions, calling them is safe"
)]

use core::arch::x86_64::*;
use core::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::{One, Zero};

use crate::ensemble::lanes::{Lanes, Square};
use crate::ensemble::registers::{SelectLanes, lanes};
use crate::scalar::assignments;
use crate::{Constant, Scalar};

mod choosing;
mod transposing;

macro_rules! machine {
    ($expression:expr) => {
        // SAFETY: the processor has the instructions. AVX lane types are used only inside `avx2`,
        // `avx512`, `work_on_avx2` and `work_on_avx512`, which run after a check of the processor
        // in `x86_64/mod.rs`. SSE2 is part of x86-64. Fused operations on SSE2 registers are
        // compiled only if the whole program is compiled for FMA.
        unsafe { $expression }
    };
}

/// Defines a lane type over an AVX-512 register, whose division is an instruction or an estimate.
macro_rules! lanes_of_avx512 {
    ($name:ident(__m512d), quotient $quotient:path) => {
        lanes! {
            $name(__m512d), 8 lanes of f64 as to_f64,
            _mm512_loadu_pd, _mm512_storeu_pd, _mm512_set1_pd,
            _mm512_add_pd, _mm512_sub_pd, _mm512_mul_pd, _mm512_div_pd,
            fused _mm512_fmadd_pd, _mm512_fmsub_pd, _mm512_fnmadd_pd, quotient $quotient
        }
    };
    ($name:ident(__m512), quotient $quotient:path) => {
        lanes! {
            $name(__m512), 16 lanes of f32 as to_f32,
            _mm512_loadu_ps, _mm512_storeu_ps, _mm512_set1_ps,
            _mm512_add_ps, _mm512_sub_ps, _mm512_mul_ps, _mm512_div_ps,
            fused _mm512_fmadd_ps, _mm512_fmsub_ps, _mm512_fnmadd_ps, quotient $quotient
        }
    };
}
pub(super) use {lanes_of_avx512, machine};

#[inline(always)]
fn divided<L: Scalar>(a: L, b: L) -> L {
    a / b
}

lanes! {
    F64x2(__m128d), 2 lanes of f64 as to_f64,
    _mm_loadu_pd, _mm_storeu_pd, _mm_set1_pd, _mm_add_pd, _mm_sub_pd, _mm_mul_pd, _mm_div_pd,
    fused of_the_build::add_f64, of_the_build::subtract_f64, of_the_build::subtract_from_f64, quotient divided
}

lanes! {
    F32x4(__m128), 4 lanes of f32 as to_f32,
    _mm_loadu_ps, _mm_storeu_ps, _mm_set1_ps, _mm_add_ps, _mm_sub_ps, _mm_mul_ps, _mm_div_ps,
    fused of_the_build::add_f32, of_the_build::subtract_f32, of_the_build::subtract_from_f32, quotient divided
}

lanes! {
    F64x4(__m256d), 4 lanes of f64 as to_f64,
    _mm256_loadu_pd, _mm256_storeu_pd, _mm256_set1_pd, _mm256_add_pd, _mm256_sub_pd, _mm256_mul_pd, _mm256_div_pd,
    fused _mm256_fmadd_pd, _mm256_fmsub_pd, _mm256_fnmadd_pd, quotient divided
}

lanes! {
    F32x8(__m256), 8 lanes of f32 as to_f32,
    _mm256_loadu_ps, _mm256_storeu_ps, _mm256_set1_ps, _mm256_add_ps, _mm256_sub_ps, _mm256_mul_ps, _mm256_div_ps,
    fused _mm256_fmadd_ps, _mm256_fmsub_ps, _mm256_fnmadd_ps, quotient divided
}

lanes_of_avx512!(F64x8(__m512d), quotient divided);

lanes_of_avx512!(F32x16(__m512), quotient divided);

/// Multiply-adds of SSE2 registers, fused if those of scalar floats are fused in this build.
mod of_the_build {
    use core::arch::x86_64::*;

    macro_rules! one_of {
        ($name:ident($a:ident, $b:ident, $c:ident: $register:ty) fused $fused:expr, else $rounded_twice:expr) => {
            #[inline(always)]
            pub(super) fn $name($a: $register, $b: $register, $c: $register) -> $register {
                #[cfg(target_feature = "fma")]
                return machine!($fused);
                #[cfg(not(target_feature = "fma"))]
                machine!($rounded_twice)
            }
        };
    }

    one_of!(add_f64(a, b, c: __m128d) fused _mm_fmadd_pd(a, b, c), else _mm_add_pd(_mm_mul_pd(a, b), c));
    one_of!(subtract_f64(a, b, c: __m128d) fused _mm_fmsub_pd(a, b, c), else _mm_sub_pd(_mm_mul_pd(a, b), c));
    one_of!(subtract_from_f64(a, b, c: __m128d) fused _mm_fnmadd_pd(a, b, c), else _mm_sub_pd(c, _mm_mul_pd(a, b)));
    one_of!(add_f32(a, b, c: __m128) fused _mm_fmadd_ps(a, b, c), else _mm_add_ps(_mm_mul_ps(a, b), c));
    one_of!(subtract_f32(a, b, c: __m128) fused _mm_fmsub_ps(a, b, c), else _mm_sub_ps(_mm_mul_ps(a, b), c));
    one_of!(subtract_from_f32(a, b, c: __m128) fused _mm_fnmadd_ps(a, b, c), else _mm_sub_ps(c, _mm_mul_ps(a, b)));
}
