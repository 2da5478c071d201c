//! Linear systems over ℤ, solved without fractions by Bareiss's algorithm.

use dashu_int::IBig;

/// Solves M x = r, where `rows` are the rows of the n×(n+1) matrix (M | r). Returns X₁, …, X_n and
/// W with xᵢ = Xᵢ/W and |W| = |det M|, or only zeros if det M = 0. Intermediate numbers have at
/// most n times the digits of an entry.
pub(crate) fn solve_projectively(mut rows: Vec<Vec<IBig>>) -> Vec<IBig> {
    let n = rows.len();
    let mut last_pivot = IBig::ONE;
    for k in 0..n {
        let candidates = (k..n).filter(|&i| !rows[i][k].is_zero());
        let Some(best) = candidates.min_by_key(|&i| super::integers::bits(&rows[i][k])) else {
            return vec![IBig::ZERO; n + 1];
        };
        rows.swap(k, best);
        let pivot_row = rows[k].clone();
        let pivot = &pivot_row[k];
        for (i, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
            let factor = std::mem::take(&mut row[k]);
            for (entry, above) in row.iter_mut().zip(&pivot_row).skip(k + 1) {
                // Skip zeros: in a field with many variables, most entries are 0 and stay 0.
                if entry.is_zero() && (factor.is_zero() || above.is_zero()) {
                    continue;
                }
                *entry = (&*entry * pivot - &factor * above) / &last_pivot;
            }
            if i < k {
                row[i] = pivot.clone();
            }
        }
        last_pivot = pivot.clone();
    }
    let mut solution: Vec<IBig> = rows.iter_mut().map(|row| std::mem::take(&mut row[n])).collect();
    solution.push(last_pivot);
    solution
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(entries: &[&[i64]]) -> Vec<Vec<IBig>> {
        entries.iter().map(|row| row.iter().map(|&entry| IBig::from(entry)).collect()).collect()
    }

    #[test]
    fn the_solution_satisfies_every_row() {
        let m = rows(&[&[0, 2, -1, 3], &[4, 0, 5, -7], &[1, 1, 0, 11]]);
        let solution = solve_projectively(m.clone());
        let (weight, x) = solution.split_last().expect("a solution");
        for row in &m {
            let left: IBig = row.iter().zip(x).map(|(a, x)| a * x).sum();
            assert_eq!(left, &row[3] * weight);
        }
        // By hand, the determinant of the matrix is 6; `weight` may be 6 or −6.
        assert_eq!(weight * weight, IBig::from(36));
    }

    #[test]
    fn a_singular_matrix_has_no_solution() {
        assert!(solve_projectively(rows(&[&[1, 2, 1], &[2, 4, 1]])).iter().all(IBig::is_zero));
    }
}
