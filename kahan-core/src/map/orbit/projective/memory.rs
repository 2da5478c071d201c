//! Tests whether an ordinary step keeps enough digits; otherwise `passage` finds the next point.
//!
//! A step has the derivative A(x,ε)⁻¹A(x̃,−ε). If A(x,ε) is nearly singular, x̃ is large or
//! inaccurate. If A(x̃,−ε) is nearly singular, the step maps different points to one x̃, up to
//! rounding.

use nalgebra::SMatrix;

use crate::Scalar;

/// The smallest allowed pivot relative to its column, so that a step loses at most ten bits.
const LEAST_PIVOT: f64 = 1.0 / 1024.0;

#[inline(always)]
fn slope<T: Scalar, const N: usize>(matrix: &SMatrix<T, N, N>, i: usize, j: usize) -> f64 {
    let slope = matrix[(i, j)].clone();
    (if i == j { slope - T::one() } else { slope }).approximate().abs()
}

/// Returns whether the absolute values in every row of εf′ sum to at most ½. If so, I − εf′ and I +
/// εf′ are far from singular.
#[inline(always)]
pub(super) fn has_small_slopes<T: Scalar, const N: usize>(matrix: &SMatrix<T, N, N>) -> bool {
    (0..N).all(|i| (0..N).map(|j| slope(matrix, i, j)).sum::<f64>() <= 0.5)
}

/// Returns whether no pivot of A = I − εf′, or none of its transpose, is small beside its column.
pub(super) fn is_far_from_singular<T: Scalar, const N: usize>(matrix: &SMatrix<T, N, N>) -> bool {
    if has_small_slopes(matrix) {
        return true;
    }
    let entry = |i: usize, j: usize| matrix[(i, j)].approximate();
    let slope = |i: usize, j: usize| slope(matrix, i, j);
    let has_pivots = |entry: &dyn Fn(usize, usize) -> f64, slope: &dyn Fn(usize, usize) -> f64| {
        let scales: [f64; N] = core::array::from_fn(|j| 1.0 + (0..N).map(|i| slope(i, j)).sum::<f64>());
        let mut rows: [[f64; N]; N] = core::array::from_fn(|i| core::array::from_fn(|j| entry(i, j)));
        (0..N).all(|k| {
            let larger = |best: usize, i: usize| {
                if rows[i][k].abs() > rows[best][k].abs() { i } else { best }
            };
            let pivot = (k..N).fold(k, larger);
            rows.swap(k, pivot);
            let pivot = rows[k];
            for row in &mut rows[k + 1..] {
                let factor = row[k] / pivot[k];
                row.iter_mut().zip(&pivot).for_each(|(entry, above)| *entry -= factor * above);
            }
            // The comparison is false if the pivot is NaN.
            pivot[k].abs() >= LEAST_PIVOT * scales[k]
        })
    };
    has_pivots(&entry, &slope) || has_pivots(&|i, j| entry(j, i), &|i, j| slope(j, i))
}
