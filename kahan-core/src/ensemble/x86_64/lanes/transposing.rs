//! Transposition of 4 × 4 matrices in registers.

use core::arch::x86_64::*;

use crate::ensemble::lanes::Square;

use super::machine;

#[inline(always)]
pub(super) fn doubles_by_four(rows: Square<f64>) -> Square<f64> {
    // SAFETY: Each pointer is valid for the four numbers of its row.
    let [a, b, c, d] = machine!([
        _mm256_loadu_pd(rows[0].as_ptr()),
        _mm256_loadu_pd(rows[1].as_ptr()),
        _mm256_loadu_pd(rows[2].as_ptr()),
        _mm256_loadu_pd(rows[3].as_ptr()),
    ]);
    let (ab, cd) = machine!((_mm256_unpacklo_pd(a, b), _mm256_unpacklo_pd(c, d)));
    let (ab_odd, cd_odd) = machine!((_mm256_unpackhi_pd(a, b), _mm256_unpackhi_pd(c, d)));
    let columns = [
        machine!(_mm256_permute2f128_pd::<0x20>(ab, cd)),
        machine!(_mm256_permute2f128_pd::<0x20>(ab_odd, cd_odd)),
        machine!(_mm256_permute2f128_pd::<0x31>(ab, cd)),
        machine!(_mm256_permute2f128_pd::<0x31>(ab_odd, cd_odd)),
    ];
    let mut square = [[0.0; 4]; 4];
    for k in 0..4 {
        // SAFETY: Each pointer is valid for the four numbers of its row.
        machine!(_mm256_storeu_pd(square[k].as_mut_ptr(), columns[k]));
    }
    square
}

#[inline(always)]
pub(super) fn doubles_by_two(rows: Square<f64>) -> Square<f64> {
    let mut square = [[0.0; 4]; 4];
    for (r, k) in [(0, 0), (0, 2), (2, 0), (2, 2)] {
        // SAFETY: Each pointer is valid for two numbers, because r and k are at most 2.
        let (a, b) = machine!((_mm_loadu_pd(rows[r][k..].as_ptr()), _mm_loadu_pd(rows[r + 1][k..].as_ptr())));
        machine!(_mm_storeu_pd(square[k][r..].as_mut_ptr(), _mm_unpacklo_pd(a, b)));
        machine!(_mm_storeu_pd(square[k + 1][r..].as_mut_ptr(), _mm_unpackhi_pd(a, b)));
    }
    square
}

#[inline(always)]
pub(super) fn singles(rows: Square<f32>) -> Square<f32> {
    // SAFETY: Each pointer is valid for the four numbers of its row.
    let [a, b, c, d] = machine!([
        _mm_loadu_ps(rows[0].as_ptr()),
        _mm_loadu_ps(rows[1].as_ptr()),
        _mm_loadu_ps(rows[2].as_ptr()),
        _mm_loadu_ps(rows[3].as_ptr()),
    ]);
    let (ab, cd) = machine!((_mm_unpacklo_ps(a, b), _mm_unpacklo_ps(c, d)));
    let (ab_high, cd_high) = machine!((_mm_unpackhi_ps(a, b), _mm_unpackhi_ps(c, d)));
    let columns = [
        machine!(_mm_movelh_ps(ab, cd)),
        machine!(_mm_movehl_ps(cd, ab)),
        machine!(_mm_movelh_ps(ab_high, cd_high)),
        machine!(_mm_movehl_ps(cd_high, ab_high)),
    ];
    let mut square = [[0.0; 4]; 4];
    for k in 0..4 {
        // Each row of `square` has room for the four numbers that are stored here.
        machine!(_mm_storeu_ps(square[k].as_mut_ptr(), columns[k]));
    }
    square
}
