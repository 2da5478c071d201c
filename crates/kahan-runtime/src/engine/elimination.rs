//! Elimination on slices: the operations of `kahan-core`'s in their order, for any number of
//! variables.

use kahan_core::Scalar;
use kahan_core::num_traits::Zero;

use crate::line::has_value;

/// Replaces `b`, a matrix of `a`'s height and any width, by the solution X of A·X = B; `a` is used
/// up. Both are row by row, A is n×n.
///
/// Whether A is singular, with a pivot that is exactly 0: the answer is then not finite.
pub(super) fn solve<V: Scalar + Copy>(a: &mut [V], b: &mut [V], n: usize) -> bool {
    let width = b.len() / n;
    let mut is_singular = false;
    for k in 0..n {
        let row = pivot_row(a, n, k);
        swap_rows(a, n, k, row);
        swap_rows(b, width, k, row);
        is_singular |= a[k * n + k].is_zero();
        // The pivot itself is not needed again: its reciprocal takes its place.
        let reciprocal = has_value(a[k * n + k].reciprocal());
        for i in k + 1..n {
            let factor = a[i * n + k] * reciprocal;
            subtract_row(a, n, [i, k], k + 1, factor);
            subtract_row(b, width, [i, k], 0, factor);
        }
        a[k * n + k] = reciprocal;
    }
    for k in (0..n).rev() {
        for j in 0..width {
            let mut entry = b[k * width + j];
            for i in k + 1..n {
                entry -= a[k * n + i] * b[i * width + j];
            }
            b[k * width + j] = entry * a[k * n + k];
        }
    }
    is_singular
}

/// The determinant of an n×n matrix, row by row; the matrix is used up.
pub(crate) fn determinant<V: Scalar + Copy>(a: &mut [V], n: usize) -> V {
    let mut determinant = V::one();
    eliminate(a, n, |pivot, flips| determinant = if flips { -determinant } else { determinant } * pivot);
    determinant
}

/// Whether the determinant of an n×n matrix, row by row, is negative; the matrix is used up.
pub(super) fn has_negative_determinant(a: &mut [f64], n: usize) -> bool {
    let (mut is_negative, mut is_zero) = (false, false);
    eliminate(a, n, |pivot, flips| {
        is_zero = pivot.is_zero();
        is_negative ^= flips != (pivot < 0.0);
    });
    is_negative && !is_zero
}

/// Eliminates below the diagonal, and shows each pivot up to the first that is 0, with whether rows
/// were exchanged for it.
fn eliminate<V: Scalar + Copy>(a: &mut [V], n: usize, mut see: impl FnMut(V, bool)) {
    for k in 0..n {
        let row = pivot_row(a, n, k);
        swap_rows(a, n, k, row);
        let pivot = a[k * n + k];
        see(pivot, row != k);
        if pivot.is_zero() {
            return;
        }
        for i in k + 1..n {
            let factor = a[i * n + k] / pivot;
            subtract_row(a, n, [i, k], k + 1, factor);
        }
    }
}

/// The row from k on that has the best pivot in column k.
fn pivot_row<V: Scalar>(a: &[V], n: usize, k: usize) -> usize {
    let better =
        |best: usize, i: usize| if a[i * n + k].is_better_pivot(&a[best * n + k]) { i } else { best };
    (k + 1..n).fold(k, better)
}

fn swap_rows<V>(matrix: &mut [V], width: usize, k: usize, row: usize) {
    if row != k {
        let (above, below) = matrix.split_at_mut(row * width);
        above[k * width..][..width].swap_with_slice(&mut below[..width]);
    }
}

/// Row i −= factor · row k, i being below k, from column `from` on.
fn subtract_row<V: Scalar + Copy>(
    matrix: &mut [V],
    width: usize,
    [i, k]: [usize; 2],
    from: usize,
    factor: V,
) {
    let (above, below) = matrix.split_at_mut(i * width);
    let upper = &above[k * width + from..][..width - from];
    for (entry, above) in below[from..width].iter_mut().zip(upper) {
        *entry -= factor * *above;
    }
}
