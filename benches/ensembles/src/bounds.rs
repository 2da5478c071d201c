//! Measures how many divisions and multiply-adds the machine can do per second. Closures are
//! avoided, because they may be compiled without vector instructions.

// `unsafe` is needed to call functions that are compiled for AVX2 or AVX-512F.
#![allow(unsafe_code)]

/// Computes `divisions` divisions of `f64`, four at a time. Does nothing without AVX2.
pub(crate) fn divisions_avx2(divisions: usize) {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") {
        // SAFETY: the condition above checks that the processor has AVX2.
        unsafe { x86_64::divisions_avx2(divisions / 32) }
    }
}

/// Computes `multiply_adds` multiply-adds of `f64`, eight at a time. Does nothing without AVX-512F.
pub(crate) fn multiply_adds_avx512(multiply_adds: usize) {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx512f") {
        // SAFETY: the condition above checks that the processor has AVX-512F.
        unsafe { x86_64::multiply_adds_avx512(multiply_adds / 128) }
    }
}

#[cfg(target_arch = "x86_64")]
mod x86_64 {
    use std::arch::x86_64::{
        __m256d, __m512d, _mm256_div_pd, _mm256_set1_pd, _mm512_fmadd_pd, _mm512_set1_pd,
    };
    use std::hint::black_box;

    #[target_feature(enable = "avx2")]
    pub(super) fn divisions_avx2(rounds: usize) {
        let numerator = _mm256_set1_pd(black_box(1.5));
        let mut x: [__m256d; 8] = [_mm256_set1_pd(black_box(1.25)); 8];
        for _ in 0..rounds {
            for x in &mut x {
                *x = _mm256_div_pd(numerator, *x);
            }
        }
        black_box(x);
    }

    #[target_feature(enable = "avx512f")]
    pub(super) fn multiply_adds_avx512(rounds: usize) {
        let (factor, addend) = (_mm512_set1_pd(black_box(0.5)), _mm512_set1_pd(black_box(0.25)));
        let mut x: [__m512d; 16] = [_mm512_set1_pd(black_box(1.25)); 16];
        for _ in 0..rounds {
            for x in &mut x {
                *x = _mm512_fmadd_pd(*x, factor, addend);
            }
        }
        black_box(x);
    }
}
