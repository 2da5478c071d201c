//! All maximal minors of a polynomial matrix, within a budget.
//!
//! Laplace expansion row by row: minors of k rows follow from those of k−1 rows. Zero minors are
//! dropped, so sparse matrices stay cheap.

use kahan_syntax::table::Table;

use crate::poly::{Budget, OverBudget, Polynomial, WithinBudget};

const MOST_MINORS: usize = 4096;

/// Returns the nonzero n×n minors of a matrix with n rows, keyed by their set of columns; bit j
/// stands for column j.
///
/// # Errors
/// Beyond the budget, 63 columns, or 4096 minors at a time.
pub fn maximal_minors(rows: &[Vec<Polynomial>], budget: &mut Budget) -> WithinBudget<Table<u64, Polynomial>> {
    if rows.first().is_some_and(|row| row.len() > 63) {
        return Err(OverBudget);
    }
    let mut minors: Table<u64, Polynomial> = Table::from_sorted(vec![(0, Polynomial::one())]);
    for row in rows {
        let mut next: Table<u64, Polynomial> = Table::new();
        for (&chosen, minor) in minors.iter() {
            for (column, entry) in row.iter().enumerate() {
                if entry.is_zero() || chosen >> column & 1 == 1 {
                    continue;
                }
                let product = minor.mul_within(entry, budget)?;
                // The entry moves past the chosen columns to its right, with one sign change for
                // each.
                let odd = (chosen >> column).count_ones() % 2 == 1;
                let product = if odd { -&product } else { product };
                let sum = next.or_default(chosen | 1 << column);
                *sum = sum.add_within(&product, budget)?;
            }
        }
        next.retain(|_, minor| !minor.is_zero());
        if next.len() > MOST_MINORS {
            return Err(OverBudget);
        }
        minors = next;
    }
    Ok(minors)
}
