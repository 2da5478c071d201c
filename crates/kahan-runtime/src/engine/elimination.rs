//! Gaussian elimination on slices. Dense elimination has the operations of `kahan-core` in their
//! order. Sparse elimination with row exchanges is for fields that are too large for compiled code.

use kahan_core::Scalar;
use kahan_core::num_traits::Zero;

use crate::line::has_value;

/// Replaces `b` by the solution X of A·X = B, and overwrites `a`. Both are row-major; A is n×n, and
/// B has n rows. Returns whether a pivot was exactly 0; X is then not finite.
pub(super) fn solve<V: Scalar + Copy>(a: &mut [V], b: &mut [V], n: usize) -> bool {
    let width = b.len() / n;
    let mut is_singular = false;
    for k in 0..n {
        let row = pivot_row(a, n, k);
        swap_rows(a, n, k, row);
        swap_rows(b, width, k, row);
        is_singular |= a[k * n + k].is_zero();
        // Store the reciprocal in place of the pivot, because the pivot is not read again.
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

/// Replaces `b` by the solution x of A·x = b. Returns whether A is singular; x is then not finite.
///
/// A row is a nonempty list of (column, entry), ordered by column. The pivot row is the shortest
/// row whose leading entry a satisfies `most`·|a| ≥ |b| for all leading entries b in its column.
pub(super) fn solve_sparse<V: Scalar + Copy>(mut rows: Vec<Vec<(usize, V)>>, b: &mut [V], most: V) -> bool {
    // For each column, the rows whose first entry is in this column.
    let mut beginning = vec![Vec::new(); rows.len()];
    for (r, row) in rows.iter().enumerate() {
        beginning[row[0].0].push(r);
    }
    let (mut is_singular, mut pivots) = (false, Vec::with_capacity(rows.len()));
    for k in 0..rows.len() {
        let candidates = std::mem::take(&mut beginning[k]);
        let first = |r: usize| rows[r][0].1;
        let larger = |a: usize, b: usize| if first(b).is_better_pivot(&first(a)) { b } else { a };
        let Some(largest) = candidates.iter().copied().reduce(larger) else {
            b.fill(V::zero() * has_value(V::zero().reciprocal()));
            return true;
        };
        let may_pivot = |r: &usize| !first(largest).is_better_pivot(&(most * first(*r)));
        let shortest = candidates.iter().copied().filter(may_pivot).min_by_key(|r| rows[*r].len());
        let pivot = shortest.unwrap_or(largest);
        let upper = std::mem::take(&mut rows[pivot]);
        is_singular |= upper[0].1.is_zero();
        let reciprocal = has_value(upper[0].1.reciprocal());
        for r in candidates.into_iter().filter(|r| *r != pivot) {
            let factor = rows[r][0].1 * reciprocal;
            rows[r] = reduced(&rows[r][1..], &upper[1..], factor);
            let of_pivot = b[pivot];
            b[r] -= factor * of_pivot;
            if let Some((column, _)) = rows[r].first() {
                beginning[*column].push(r);
            }
        }
        pivots.push((pivot, reciprocal, upper));
    }
    let mut x = vec![V::zero(); b.len()];
    for (k, (pivot, reciprocal, upper)) in pivots.iter().enumerate().rev() {
        let right = upper[1..].iter().fold(b[*pivot], |sum, (column, entry)| sum - *entry * x[*column]);
        x[k] = right * *reciprocal;
    }
    b.copy_from_slice(&x);
    is_singular
}

fn reduced<V: Scalar + Copy>(row: &[(usize, V)], upper: &[(usize, V)], factor: V) -> Vec<(usize, V)> {
    let (mut row, mut reduced) =
        (row.iter().copied().peekable(), Vec::with_capacity(row.len() + upper.len()));
    for &(column, above) in upper {
        while let Some(before) = row.next_if(|(own, _)| *own < column) {
            reduced.push(before);
        }
        let entry = row.next_if(|(own, _)| *own == column).map_or_else(V::zero, |(_, entry)| entry);
        reduced.push((column, entry - factor * above));
    }
    reduced.extend(row);
    reduced
}

pub(crate) fn determinant<V: Scalar + Copy>(a: &mut [V], n: usize) -> V {
    let mut determinant = V::one();
    eliminate(a, n, |pivot, flips| determinant = if flips { -determinant } else { determinant } * pivot);
    determinant
}

pub(super) fn has_negative_determinant(a: &mut [f64], n: usize) -> bool {
    let (mut is_negative, mut is_zero) = (false, false);
    eliminate(a, n, |pivot, flips| {
        is_zero = pivot.is_zero();
        is_negative ^= flips != (pivot < 0.0);
    });
    is_negative && !is_zero
}

/// Eliminates the entries below the diagonal. `see` receives each pivot, and whether rows were
/// exchanged for it; after a zero pivot the elimination ends.
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

#[cfg(test)]
mod tests {
    use super::{solve, solve_sparse};

    fn draw(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 32) as f64 / f64::from(1_u32 << 31) - 1.0
    }

    #[test]
    fn sparse_rows_are_solved_with_the_bits_of_whole_ones() {
        let (mut seed, mut singular) = (11, 0);
        for n in 1..60 {
            for density in [0.1, 0.3, 1.0] {
                let mut matrix = vec![0.0; n * n];
                for (place, entry) in matrix.iter_mut().enumerate() {
                    // Diagonal entries with `place % 3 == 0` can be 0, which forces row exchanges.
                    if place / n == place % n && place % 3 > 0 || draw(&mut seed).abs() < density {
                        *entry = draw(&mut seed);
                    }
                }
                let entries = |row: &[f64]| {
                    let row = row.iter().copied().enumerate();
                    row.filter(|(_, entry)| *entry != 0.0).collect::<Vec<_>>()
                };
                let rows: Vec<Vec<(usize, f64)>> = matrix.chunks_exact(n).map(entries).collect();
                if rows.iter().any(Vec::is_empty) {
                    continue;
                }
                let mut expected: Vec<f64> = (0..n).map(|_| draw(&mut seed)).collect();
                let mut found = expected.clone();
                let is_singular = solve(&mut matrix, &mut expected, n);
                assert_eq!(solve_sparse(rows, &mut found, 1.0), is_singular, "{n} variables");
                singular += usize::from(is_singular);
                let is_finite = found.iter().all(|x| x.is_finite());
                assert!(if is_singular { !is_finite } else { found == expected }, "{n} variables");
            }
        }
        assert!((1..60).contains(&singular), "{singular}");
    }
}
