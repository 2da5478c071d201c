//! All maximal minors of an n×(n+1) polynomial matrix at once, within a budget.
//!
//! Laplace expansion row by row: after k rows, the minor of every set of k columns is known, each
//! from those of k−1. Zero minors are left out, so sparse matrices stay cheap.

use crate::poly::{Budget, OverBudget, Polynomial};
use crate::table::Table;

/// The largest number of nonzero minors kept at a time.
const MOST_MINORS: usize = 4096;

/// The minors of n columns of `rows` (n rows of n+1 entries): item j is the minor without column j.
pub(super) fn maximal_minors(
    rows: &[Vec<Polynomial>],
    budget: &mut Budget,
) -> Result<Vec<Polynomial>, OverBudget> {
    let columns = rows.len() + 1;
    if columns > 63 {
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
                // The entry moves past the chosen columns to its right.
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
    let all = (1u64 << columns) - 1;
    Ok((0..columns).map(|column| minors.remove(&(all & !(1 << column))).unwrap_or_default()).collect())
}
