//! Comparing and choosing, lane by lane, and what transposes squares beside it.

use core::arch::x86_64::*;

use crate::ensemble::lanes::{Lanes, Square};

use super::{F32x4, F32x8, F32x16, F64x2, F64x4, F64x8, machine, transposing};

/// A register's comparison of magnitudes, and its choice between two.
macro_rules! choosing {
    ($name:ident of $float:ty, $mask:ty: |$a:ident, $b:ident| $exceeds:expr, |$asked:ident| $any:expr, |$chosen:ident, $yes:ident, $no:ident| $choose:expr, transposed $transposed:path) => {
        impl Lanes<$float> for $name {
            type Mask = $mask;

            #[inline(always)]
            fn exceeds(self, other: Self) -> $mask {
                let ($a, $b) = (self.0, other.0);
                machine!($exceeds)
            }

            #[inline(always)]
            fn any($asked: $mask) -> bool {
                machine!($any)
            }

            #[inline(always)]
            fn choose($chosen: $mask, yes: Self, no: Self) -> Self {
                let ($yes, $no) = (yes.0, no.0);
                Self(machine!($choose))
            }

            #[inline(always)]
            fn transposed(rows: Square<$float>) -> Square<$float> {
                $transposed(rows)
            }
        }
    };
}

choosing! {
    F64x2 of f64, __m128d:
    |a, b| {
        let sign = _mm_set1_pd(-0.0);
        _mm_cmpgt_pd(_mm_andnot_pd(sign, a), _mm_andnot_pd(sign, b))
    },
    |mask| _mm_movemask_pd(mask) != 0,
    |mask, yes, no| _mm_or_pd(_mm_and_pd(mask, yes), _mm_andnot_pd(mask, no)),
    transposed transposing::doubles_by_two
}

choosing! {
    F32x4 of f32, __m128:
    |a, b| {
        let sign = _mm_set1_ps(-0.0);
        _mm_cmpgt_ps(_mm_andnot_ps(sign, a), _mm_andnot_ps(sign, b))
    },
    |mask| _mm_movemask_ps(mask) != 0,
    |mask, yes, no| _mm_or_ps(_mm_and_ps(mask, yes), _mm_andnot_ps(mask, no)),
    transposed transposing::singles
}

choosing! {
    F64x4 of f64, __m256d:
    |a, b| {
        let sign = _mm256_set1_pd(-0.0);
        _mm256_cmp_pd::<_CMP_GT_OQ>(_mm256_andnot_pd(sign, a), _mm256_andnot_pd(sign, b))
    },
    |mask| _mm256_movemask_pd(mask) != 0,
    |mask, yes, no| _mm256_blendv_pd(no, yes, mask),
    transposed transposing::doubles_by_four
}

choosing! {
    F32x8 of f32, __m256:
    |a, b| {
        let sign = _mm256_set1_ps(-0.0);
        _mm256_cmp_ps::<_CMP_GT_OQ>(_mm256_andnot_ps(sign, a), _mm256_andnot_ps(sign, b))
    },
    |mask| _mm256_movemask_ps(mask) != 0,
    |mask, yes, no| _mm256_blendv_ps(no, yes, mask),
    transposed transposing::singles
}

choosing! {
    F64x8 of f64, __mmask8:
    |a, b| _mm512_cmp_pd_mask::<_CMP_GT_OQ>(_mm512_abs_pd(a), _mm512_abs_pd(b)),
    |mask| mask != 0,
    |mask, yes, no| _mm512_mask_blend_pd(mask, no, yes),
    transposed transposing::doubles_by_four
}

choosing! {
    F32x16 of f32, __mmask16:
    |a, b| _mm512_cmp_ps_mask::<_CMP_GT_OQ>(_mm512_abs_ps(a), _mm512_abs_ps(b)),
    |mask| mask != 0,
    |mask, yes, no| _mm512_mask_blend_ps(mask, no, yes),
    transposed transposing::singles
}
