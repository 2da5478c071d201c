//! Comparison and selection in each lane, and the transposition of 4 × 4 matrices.

use core::arch::x86_64::*;

use crate::ensemble::lanes::Square;
use crate::ensemble::registers::{SelectLanes, choosing};

use super::{machine, transposing};

choosing! {
    __m128d of f64, __m128d:
    |a, b| {
        let sign = _mm_set1_pd(-0.0);
        _mm_cmpgt_pd(_mm_andnot_pd(sign, a), _mm_andnot_pd(sign, b))
    },
    |mask| _mm_movemask_pd(mask) != 0,
    |mask, yes, no| _mm_or_pd(_mm_and_pd(mask, yes), _mm_andnot_pd(mask, no)),
    transposed transposing::doubles_by_two
}

choosing! {
    __m128 of f32, __m128:
    |a, b| {
        let sign = _mm_set1_ps(-0.0);
        _mm_cmpgt_ps(_mm_andnot_ps(sign, a), _mm_andnot_ps(sign, b))
    },
    |mask| _mm_movemask_ps(mask) != 0,
    |mask, yes, no| _mm_or_ps(_mm_and_ps(mask, yes), _mm_andnot_ps(mask, no)),
    transposed transposing::singles
}

choosing! {
    __m256d of f64, __m256d:
    |a, b| {
        let sign = _mm256_set1_pd(-0.0);
        _mm256_cmp_pd::<_CMP_GT_OQ>(_mm256_andnot_pd(sign, a), _mm256_andnot_pd(sign, b))
    },
    |mask| _mm256_movemask_pd(mask) != 0,
    |mask, yes, no| _mm256_blendv_pd(no, yes, mask),
    transposed transposing::doubles_by_four
}

choosing! {
    __m256 of f32, __m256:
    |a, b| {
        let sign = _mm256_set1_ps(-0.0);
        _mm256_cmp_ps::<_CMP_GT_OQ>(_mm256_andnot_ps(sign, a), _mm256_andnot_ps(sign, b))
    },
    |mask| _mm256_movemask_ps(mask) != 0,
    |mask, yes, no| _mm256_blendv_ps(no, yes, mask),
    transposed transposing::singles
}

choosing! {
    __m512d of f64, __mmask8:
    |a, b| _mm512_cmp_pd_mask::<_CMP_GT_OQ>(_mm512_abs_pd(a), _mm512_abs_pd(b)),
    |mask| mask != 0,
    |mask, yes, no| _mm512_mask_blend_pd(mask, no, yes),
    transposed transposing::doubles_by_four
}

choosing! {
    __m512 of f32, __mmask16:
    |a, b| _mm512_cmp_ps_mask::<_CMP_GT_OQ>(_mm512_abs_ps(a), _mm512_abs_ps(b)),
    |mask| mask != 0,
    |mask, yes, no| _mm512_mask_blend_ps(mask, no, yes),
    transposed transposing::singles
}
