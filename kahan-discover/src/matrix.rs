//! Matrices modulo a prime: reduced echelon form, rank and null space.
//!
//! Rows are equations, columns unknowns in an order that matters: a column becomes a pivot if it is
//! no combination of the columns before it, so with monomials in ascending order every null vector
//! expresses one monomial by lower ones.

use crate::deadline::Deadline;
use crate::modulus::Modulus;

/// The reduced row echelon form of a matrix.
#[derive(Clone, Debug)]
pub struct Echelon {
    /// The pivot columns, ascending.
    pub pivots: Vec<usize>,
    /// One row a pivot: 1 in its own pivot column, 0 in the others.
    pub rows: Vec<Vec<u64>>,
    columns: usize,
}

impl Echelon {
    /// The echelon form of `rows`, each with `columns` entries. Cost: rows · rank · columns
    /// products.
    #[must_use]
    pub fn of(modulus: &Modulus, rows: Vec<Vec<u64>>, columns: usize) -> Self {
        Self::reduced(modulus, rows, columns, &Deadline::never()).0
    }

    /// The same, if it is done before the deadline.
    #[must_use]
    pub fn within(
        modulus: &Modulus,
        rows: Vec<Vec<u64>>,
        columns: usize,
        deadline: &Deadline,
    ) -> Option<Self> {
        let (echelon, is_done) = Self::reduced(modulus, rows, columns, deadline);
        is_done.then_some(echelon)
    }

    fn reduced(
        modulus: &Modulus,
        mut rows: Vec<Vec<u64>>,
        columns: usize,
        deadline: &Deadline,
    ) -> (Self, bool) {
        let mut pivots = Vec::new();
        let mut is_done = true;
        for column in 0..columns {
            if deadline.passed() {
                is_done = false;
                break;
            }
            let rank = pivots.len();
            let Some(found) = (rank..rows.len()).find(|&row| rows[row][column] != 0) else { continue };
            rows.swap(rank, found);
            let inverse = modulus.inverse(rows[rank][column]).expect("a pivot is not zero");
            for entry in &mut rows[rank][column..] {
                *entry = modulus.times(*entry, inverse);
            }
            let (above, rest) = rows.split_at_mut(rank);
            let Some((pivot, below)) = rest.split_first_mut() else { break };
            for row in above.iter_mut().chain(below) {
                let factor = row[column];
                if factor != 0 {
                    let factor = modulus.opposite(factor);
                    for (entry, own) in row[column..].iter_mut().zip(&pivot[column..]) {
                        *entry = modulus.plus(*entry, modulus.times(factor, *own));
                    }
                }
            }
            pivots.push(column);
            if pivots.len() == rows.len() {
                break;
            }
        }
        rows.truncate(pivots.len());
        (Echelon { pivots, rows, columns }, is_done)
    }

    /// The rank.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.pivots.len()
    }

    /// The rank of the first `columns` columns.
    #[must_use]
    pub fn rank_of_first(&self, columns: usize) -> usize {
        self.pivots.partition_point(|&pivot| pivot < columns)
    }

    /// The vectors that rows of so many columns send to zero; `None` if the deadline passes first.
    pub(crate) fn null_vectors(
        modulus: &Modulus,
        rows: Vec<Vec<u64>>,
        columns: usize,
        deadline: &Deadline,
    ) -> Option<Vec<Vec<u64>>> {
        let echelon = Echelon::within(modulus, rows, columns, deadline)?;
        Some(echelon.null_space(modulus).into_iter().map(|vector| vector.entries).collect())
    }

    /// A basis of the null space: for each column without a pivot the vector with 1 there, 0 in the
    /// other such columns.
    #[must_use]
    pub fn null_space(&self, modulus: &Modulus) -> Vec<NullVector> {
        let mut is_pivot = vec![false; self.columns];
        for &pivot in &self.pivots {
            is_pivot[pivot] = true;
        }
        let free = (0..self.columns).filter(|&column| !is_pivot[column]);
        free.map(|free| {
            let mut entries = vec![0; self.columns];
            entries[free] = modulus.one();
            for (row, &pivot) in self.rows.iter().zip(&self.pivots) {
                entries[pivot] = modulus.opposite(row[free]);
            }
            NullVector { free, entries }
        })
        .collect()
    }
}

/// Equations beyond the number of unknowns.
const SPARE: usize = 6;

/// The vectors that random rows of so many columns all send to zero; `None` where a row is, or the
/// deadline passes.
pub(crate) fn sampled_null_vectors(
    modulus: &Modulus,
    columns: usize,
    deadline: &Deadline,
    mut row: impl FnMut() -> Option<Vec<u64>>,
) -> Option<Vec<Vec<u64>>> {
    let mut rows = Vec::with_capacity(columns + SPARE);
    for _ in 0..columns + SPARE {
        if deadline.passed() {
            return None;
        }
        rows.push(row()?);
    }
    Echelon::null_vectors(modulus, rows, columns, deadline)
}

/// A vector that the matrix sends to zero.
#[derive(Clone, Debug)]
pub struct NullVector {
    /// The column whose entry is 1; it is the highest that is not zero.
    pub free: usize,
    /// All entries.
    pub entries: Vec<u64>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn null_vectors_are_sent_to_zero_and_express_the_highest_column() {
        let modulus = Modulus::mersenne_61();
        // Columns: a, b, 2a + 3b, 0, c, a − c.
        let columns = |a: u64, b: u64, c: u64| {
            let entries = [a, b, 2 * a + 3 * b, 0, c];
            let mut row: Vec<u64> = entries.iter().map(|&value| modulus.integer(value)).collect();
            row.push(modulus.minus(row[0], row[4]));
            row
        };
        let rows = vec![columns(1, 2, 3), columns(4, 5, 7), columns(6, 8, 9), columns(1, 1, 1)];
        let echelon = Echelon::of(&modulus, rows.clone(), 6);
        assert_eq!(echelon.pivots, [0, 1, 4]);
        assert_eq!((echelon.rank(), echelon.rank_of_first(3)), (3, 2));
        let null = echelon.null_space(&modulus);
        assert_eq!(null.iter().map(|vector| vector.free).collect::<Vec<_>>(), [2, 3, 5]);
        for vector in null {
            assert!(vector.entries[vector.free + 1..].iter().all(|&entry| entry == 0));
            for row in &rows {
                assert_eq!(modulus.dot(row, &vector.entries), 0);
            }
        }
    }
}
