//! Solves linear systems over ℚ(parameters).

use kahan_algebra::rational_function::RationalFunction;

/// Returns a basis of the null space of a matrix. In each basis vector, one free variable is 1, and
/// the other free variables are 0.
pub(crate) fn null_space(mut rows: Vec<Vec<RationalFunction>>, columns: usize) -> Vec<Vec<RationalFunction>> {
    let mut pivots: Vec<usize> = Vec::new();
    for column in 0..columns {
        let top = pivots.len();
        let Some(found) = (top..rows.len()).find(|&row| !rows[row][column].is_zero()) else { continue };
        rows.swap(top, found);
        let inverse = rows[top][column].recip().expect("a pivot is not 0");
        let pivot: Vec<RationalFunction> = rows[top].iter().map(|entry| entry * &inverse).collect();
        for (index, row) in rows.iter_mut().enumerate() {
            if index != top && !row[column].is_zero() {
                let factor = row[column].clone();
                for (entry, above) in row.iter_mut().zip(&pivot) {
                    if !above.is_zero() {
                        *entry = &*entry - &(&factor * above);
                    }
                }
            }
        }
        rows[top] = pivot;
        pivots.push(column);
    }
    let free = (0..columns).filter(|column| !pivots.contains(column));
    free.map(|free| {
        let mut vector = vec![RationalFunction::zero(); columns];
        vector[free] = RationalFunction::one();
        for (row, &pivot) in pivots.iter().enumerate() {
            vector[pivot] = -&rows[row][free];
        }
        vector
    })
    .collect()
}
