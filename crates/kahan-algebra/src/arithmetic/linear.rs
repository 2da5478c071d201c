//! Solves linear systems in any arithmetic. Elimination uses the best pivot of each column.

use kahan_syntax::rational::Rational;

use super::OverRationals;

/// The solution X of M X = R and the determinant of M.
#[derive(Clone, Debug)]
pub struct Solved<V> {
    /// The rows of X.
    pub solution: Vec<Vec<V>>,
    /// The determinant det M.
    pub determinant: V,
}

/// Solves M X = R for an n×n matrix M and n rows R. Returns `None` if det M = 0.
pub fn solve<A: OverRationals>(
    arithmetic: &A,
    matrix: &[Vec<A::Value>],
    right: &[Vec<A::Value>],
) -> Option<Solved<A::Value>> {
    let n = matrix.len();
    let mut rows: Vec<Vec<A::Value>> =
        matrix.iter().zip(right).map(|(row, right)| row.iter().chain(right).cloned().collect()).collect();
    let one = arithmetic.constant(&Rational::one())?;
    let mut determinant = one.clone();
    for k in 0..n {
        let better = |best: usize, i: usize| {
            if arithmetic.is_better_pivot(&rows[i][k], &rows[best][k]) { i } else { best }
        };
        let pivot_row = (k + 1..n).fold(k, better);
        if arithmetic.is_zero(&rows[pivot_row][k]) {
            return None;
        }
        if pivot_row != k {
            rows.swap(pivot_row, k);
            determinant = arithmetic.negate(&determinant);
        }
        determinant = arithmetic.multiply(&determinant, &rows[k][k]);
        let inverse = arithmetic.divide(&one, &rows[k][k])?;
        for entry in &mut rows[k][k..] {
            *entry = arithmetic.multiply(entry, &inverse);
        }
        let pivot = rows[k].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            if i != k && !arithmetic.is_zero(&row[k]) {
                let factor = row[k].clone();
                for (entry, above) in row[k..].iter_mut().zip(&pivot[k..]) {
                    *entry = arithmetic.subtract(entry, &arithmetic.multiply(&factor, above));
                }
            }
        }
    }
    let solution = rows.into_iter().map(|row| row[n..].to_vec()).collect();
    Some(Solved { solution, determinant })
}

/// Returns the determinant of a square matrix.
pub fn determinant<A: OverRationals>(arithmetic: &A, matrix: &[Vec<A::Value>]) -> Option<A::Value> {
    let nothing = vec![Vec::new(); matrix.len()];
    match solve(arithmetic, matrix, &nothing) {
        Some(solved) => Some(solved.determinant),
        None => arithmetic.constant(&Rational::zero()),
    }
}
