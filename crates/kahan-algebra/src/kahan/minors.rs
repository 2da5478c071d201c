//! Computes all maximal minors of a polynomial matrix within a budget.
//!
//! Laplace expansion computes the minors of k rows from those of k−1 rows. Zero minors are dropped,
//! so sparse matrices are cheap.

use kahan_syntax::table::Table;

use crate::poly::{Budget, OverBudget, Polynomial, WithinBudget};

const MOST_MINORS: usize = 4096;

/// Returns the nonzero n×n minors of a matrix with n rows. A key is the set of columns, with bit j
/// for column j.
///
/// # Errors
/// If the budget is spent, if there are more than 63 columns, or if more than 4096 minors are kept
/// at a time.
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
                // Each chosen column to the right of `column` changes the product's sign.
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
