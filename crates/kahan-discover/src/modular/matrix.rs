//! Matrices modulo a prime, with reduced row echelon form, rank and null space.
//!
//! Rows are equations, and columns are unknowns. A column becomes a pivot if it is not a linear
//! combination of earlier columns. If columns are monomials in ascending order, each null vector
//! expresses its highest monomial by lower ones.

use crate::deadline::Deadline;
use crate::modular::modulus::Modulus;

/// The reduced row echelon form of a matrix.
#[derive(Clone, Debug)]
pub struct Echelon {
    /// The pivot columns, ascending.
    pub pivots: Vec<usize>,
    /// One row for each pivot, with 1 in its own pivot column and 0 in the other pivot columns.
    pub rows: Vec<Vec<u64>>,
    columns: usize,
}

impl Echelon {
    /// Computes the echelon form of `rows`, each with `columns` entries. The cost is rows · rank ·
    /// columns / 2 multiplications.
    #[must_use]
    pub fn of(modulus: &Modulus, rows: Vec<Vec<u64>>, columns: usize) -> Self {
        Self::within(modulus, rows, columns, &Deadline::never()).expect("there is no deadline")
    }

    /// Computes the echelon form like [`of`](Self::of). Returns `None` if the deadline passes.
    #[must_use]
    pub fn within(
        modulus: &Modulus,
        rows: Vec<Vec<u64>>,
        columns: usize,
        deadline: &Deadline<'_>,
    ) -> Option<Self> {
        let (mut pivots, mut echelon) = (Vec::new(), Vec::new());
        for row in rows {
            if deadline.passed() {
                return None;
            }
            let mut row = reduced_by(modulus, row, &pivots, &echelon);
            let Some(pivot) = row.iter().position(|&entry| entry != 0) else { continue };
            let inverse = modulus.inverse(row[pivot]).expect("a pivot is not zero");
            for entry in &mut row[pivot..] {
                *entry = modulus.times(*entry, inverse);
            }
            let place = pivots.partition_point(|&before| before < pivot);
            pivots.insert(place, pivot);
            echelon.insert(place, row);
            if pivots.len() == columns {
                break;
            }
        }
        back_substituted(modulus, &pivots, &mut echelon, columns, deadline)?;
        Some(Echelon { pivots, rows: echelon, columns })
    }

    /// Returns the rank.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.pivots.len()
    }

    /// Returns the rank of the matrix of the first `columns` columns.
    #[must_use]
    pub fn rank_of_first(&self, columns: usize) -> usize {
        self.pivots.partition_point(|&pivot| pivot < columns)
    }

    pub(crate) fn null_vectors(
        modulus: &Modulus,
        rows: Vec<Vec<u64>>,
        columns: usize,
        deadline: &Deadline<'_>,
    ) -> Option<Vec<Vec<u64>>> {
        let echelon = Echelon::within(modulus, rows, columns, deadline)?;
        Some(echelon.null_space(modulus).into_iter().map(|vector| vector.entries).collect())
    }

    /// Subtracts multiples of the echelon rows from `row`, until `row` is 0 in all pivot columns.
    pub(crate) fn remainder(&self, modulus: &Modulus, row: Vec<u64>) -> Vec<u64> {
        reduced_by(modulus, row, &self.pivots, &self.rows)
    }

    /// Returns a basis of the null space. Each vector has 1 in one column without a pivot, and 0 in
    /// all other columns without a pivot.
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

fn reduced_by(modulus: &Modulus, row: Vec<u64>, pivots: &[usize], echelon: &[Vec<u64>]) -> Vec<u64> {
    let mut row = Sums::of(row);
    for (&pivot, own) in pivots.iter().zip(echelon) {
        let factor = modulus.opposite(modulus.reduced(row.sums[pivot]));
        row.add_multiple(modulus, factor, pivot, &own[pivot..]);
    }
    row.reduced(modulus)
}

/// Back substitution: subtracts multiples of the later rows from each row, until that row is 0 in
/// the pivot columns of the later rows. Only columns without a pivot are computed.
fn back_substituted(
    modulus: &Modulus,
    pivots: &[usize],
    rows: &mut [Vec<u64>],
    columns: usize,
    deadline: &Deadline<'_>,
) -> Option<()> {
    let free: Vec<usize> = (0..columns).filter(|column| pivots.binary_search(column).is_err()).collect();
    // The entries of all finished rows in columns without a pivot. The last row comes first.
    let mut tails: Vec<Vec<u64>> = Vec::with_capacity(rows.len());
    for (row, pivot) in rows.iter_mut().zip(pivots).rev() {
        if deadline.passed() {
            return None;
        }
        let mut tail = Sums::of(free.iter().map(|&column| row[column]).collect());
        for (later, &column) in tails.iter().zip(pivots.iter().rev()) {
            tail.add_multiple(modulus, modulus.opposite(row[column]), 0, later);
        }
        let tail = tail.reduced(modulus);
        row.fill(0);
        row[*pivot] = modulus.one();
        for (&column, &entry) in free.iter().zip(&tail) {
            row[column] = entry;
        }
        tails.push(tail);
    }
    Some(())
}

/// A row of sums of products, which are reduced modulo p only before they overflow.
struct Sums {
    sums: Vec<u128>,
    products: usize,
}

impl Sums {
    fn of(row: Vec<u64>) -> Self {
        Sums { sums: row.into_iter().map(Modulus::unreduced).collect(), products: 0 }
    }

    /// Adds `factor` times `row` to the columns from `from` on. Earlier columns are not reduced, so
    /// later calls must not have a smaller `from`.
    fn add_multiple(&mut self, modulus: &Modulus, factor: u64, from: usize, row: &[u64]) {
        if factor == 0 {
            return;
        }
        if self.products == Modulus::MAX_UNREDUCED_PRODUCTS {
            for sum in &mut self.sums[from..] {
                *sum = Modulus::unreduced(modulus.reduced(*sum));
            }
            self.products = 0;
        }
        self.products += 1;
        for (sum, own) in self.sums[from..].iter_mut().zip(row) {
            *sum += u128::from(factor) * u128::from(*own);
        }
    }

    fn reduced(self, modulus: &Modulus) -> Vec<u64> {
        self.sums.into_iter().map(|sum| modulus.reduced(sum)).collect()
    }
}

/// The number of equations in a linear system beyond the number of unknowns.
pub(crate) const SPARE_EQUATIONS: usize = 6;

/// Returns a basis of the null space of a matrix. Each call of `row` returns one row of the matrix.
pub(crate) fn sampled_null_vectors(
    modulus: &Modulus,
    columns: usize,
    deadline: &Deadline<'_>,
    mut row: impl FnMut() -> Option<Vec<u64>>,
) -> Option<Vec<Vec<u64>>> {
    let mut rows = Vec::with_capacity(columns + SPARE_EQUATIONS);
    for _ in 0..columns + SPARE_EQUATIONS {
        if deadline.passed() {
            return None;
        }
        rows.push(row()?);
    }
    Echelon::null_vectors(modulus, rows, columns, deadline)
}

/// A vector of the null space.
#[derive(Clone, Debug)]
pub struct NullVector {
    /// The column with entry 1, which is the last nonzero entry.
    pub free: usize,
    /// All entries of the vector.
    pub entries: Vec<u64>,
}

#[cfg(test)]
mod tests {
    use kahan_algebra::prime_field::SplitMix64;

    use super::*;

    #[test]
    fn the_form_is_reduced_and_spans_the_same_rows() {
        let mut random = SplitMix64::new(3);
        for modulus in [Modulus::mersenne_61(), Modulus::random(&mut random)] {
            for (height, width, rank) in [(40, 60, 20), (60, 40, 25), (30, 30, 30), (5, 1, 1), (3, 0, 0)] {
                let mut of = |height: usize, width: usize| -> Vec<Vec<u64>> {
                    let mut entry = |column: usize| match column % 7 {
                        3 => 0,
                        _ if rank == height => modulus.sample(&mut random),
                        _ => modulus.opposite(modulus.sample(&mut random) % 5),
                    };
                    (0..height).map(|_| (0..width).map(&mut entry).collect()).collect()
                };
                let (left, right) = (of(height, rank), of(rank, width));
                let sum = |factors: &[u64], rows: &[Vec<u64>]| -> Vec<u64> {
                    let column = |j: usize| rows.iter().map(|row| row[j]).collect::<Vec<u64>>();
                    (0..width).map(|j| modulus.dot(factors, &column(j))).collect()
                };
                let rows: Vec<Vec<u64>> = left.iter().map(|factors| sum(factors, &right)).collect();
                let echelon = Echelon::of(&modulus, rows.clone(), width);
                assert!(echelon.pivots.is_sorted_by(|a, b| a < b));
                for (row, &pivot) in echelon.rows.iter().zip(&echelon.pivots) {
                    assert!(row[..pivot].iter().all(|&entry| entry == 0));
                    assert!(row.iter().all(|&entry| entry < modulus.prime()));
                    for other in &echelon.pivots {
                        assert_eq!(row[*other], if *other == pivot { modulus.one() } else { 0 });
                    }
                }
                for row in &rows {
                    let factors: Vec<u64> = echelon.pivots.iter().map(|&pivot| row[pivot]).collect();
                    assert_eq!(sum(&factors, &echelon.rows), *row);
                }
                let again = Echelon::of(&modulus, [echelon.rows.clone(), rows].concat(), width);
                assert_eq!((&again.pivots, &again.rows), (&echelon.pivots, &echelon.rows));
            }
        }
    }

    #[test]
    fn null_vectors_are_sent_to_zero_and_express_the_highest_column() {
        let modulus = Modulus::mersenne_61();
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
