//! Sparse elimination: tables of the entries of A(x,ε) = I − εf′(x), and loops over these tables.
//!
//! LU factors replace A in place. Rows are never exchanged; [`factor`](Couplings::factor) reports
//! pivots that are too small.

use core::ops::Range;

use crate::{Constant, Scalar};

/// The ratio above which a pivot is too small. If both the row and the column of a pivot contain an
/// entry more than this many times larger than the pivot, the step uses partial pivoting instead.
pub const LARGEST_FACTOR: i64 = 16;

/// The entries of A(x,ε), including those that elimination fills in. Rows and columns are in
/// elimination order.
#[derive(Clone, Copy, Debug)]
pub struct Couplings<'a> {
    /// The variables in the order of elimination.
    pub order: &'a [u32],
    /// For each row of A, the range of its entries.
    pub rows: &'a [CouplingRow],
    /// For each entry of A, the index of its column.
    pub columns: &'a [u32],
    /// For each diagonal block of A, the index after its last row. Blocks are solved in order.
    pub blocks: &'a [u32],
    /// For each nonzero entry of f′, its index among the entries of A.
    pub places: &'a [u32],
}

/// A row's range among the entries of A, and two indices in this range; see [`new`](Self::new).
#[derive(Clone, Copy, Debug)]
pub struct CouplingRow {
    start: u32,
    own: u32,
    diagonal: u32,
    end: u32,
}

impl CouplingRow {
    /// Creates a row from indices of entries: the row's first entry, its first entry in its
    /// diagonal block, its diagonal entry, and the index after its last entry.
    #[must_use]
    pub const fn new(start: u32, own: u32, diagonal: u32, end: u32) -> Self {
        CouplingRow { start, own, diagonal, end }
    }

    pub(crate) fn left(&self) -> Range<usize> {
        self.own as usize..self.diagonal as usize
    }

    pub(crate) fn right(&self) -> Range<usize> {
        self.diagonal as usize + 1..self.end as usize
    }

    pub(crate) fn own(&self) -> Range<usize> {
        self.own as usize..self.end as usize
    }

    /// Returns the range of entries left of the diagonal, in the row's own and in earlier blocks.
    fn solved(&self) -> Range<usize> {
        self.start as usize..self.diagonal as usize
    }
}

impl Couplings<'_> {
    /// Computes A(x,ε) = I − εf′(x). `slopes` holds the entries of f′ in the order of `places`.
    pub fn fill<T: Scalar>(&self, slopes: &[T], eps: &T, values: &mut [T]) {
        values.fill(T::zero());
        for (place, slope) in self.places.iter().zip(slopes) {
            values[*place as usize] = -(eps.clone() * slope.clone());
        }
        for row in self.rows {
            let diagonal = &mut values[row.diagonal as usize];
            *diagonal = T::one() + diagonal.clone();
        }
    }

    /// Replaces A by its LU factors, with reciprocal pivots. `row` is memory for one row. Returns
    /// `false` if a pivot is 0, or smaller than [`LARGEST_FACTOR`] allows.
    pub fn factor<T: Scalar>(&self, values: &mut [T], row: &mut [T]) -> bool {
        let most = T::constant(&Constant::integer(LARGEST_FACTOR));
        let mut is_refused = false;
        let has_pivots = self.eliminate(values, row, |turn, factor, values| {
            let (reciprocal, behind) = self.pivot(turn, values);
            let is_large = |upper: &T| (upper.clone() * reciprocal.clone()).is_better_pivot(&most);
            is_refused |= factor.is_better_pivot(&most) && behind.iter().any(is_large);
        });
        has_pivots && !is_refused
    }

    /// Replaces A by its LU factors, or returns `false` if a pivot is 0. Before each subtraction of
    /// a row, `see` gets the row's index, the factor, and the partly eliminated A.
    pub fn eliminate<T: Scalar>(
        &self,
        values: &mut [T],
        row: &mut [T],
        mut see: impl FnMut(usize, &T, &[T]),
    ) -> bool {
        let mut is_singular = false;
        for this in self.rows {
            for place in this.own() {
                row[self.columns[place] as usize] = values[place].clone();
            }
            for place in this.left() {
                let pivot = self.columns[place] as usize;
                let above = &self.rows[pivot];
                let factor = row[pivot].clone() * values[above.diagonal as usize].clone();
                see(pivot, &factor, values);
                for upper in above.right() {
                    let entry = &mut row[self.columns[upper] as usize];
                    *entry = entry.clone().subtract_product(factor.clone(), values[upper].clone());
                }
                row[pivot] = factor;
            }
            for place in this.own() {
                values[place] = row[self.columns[place] as usize].clone();
            }
            let pivot = &mut values[this.diagonal as usize];
            is_singular |= pivot.is_zero();
            let Some(reciprocal) = pivot.reciprocal() else { return false };
            *pivot = reciprocal;
        }
        !is_singular
    }

    /// Returns the reciprocal pivot of row `turn` in elimination order, and the entries after it.
    pub fn pivot<'a, T>(&self, turn: usize, values: &'a [T]) -> (&'a T, &'a [T]) {
        let row = &self.rows[turn];
        (&values[row.diagonal as usize], &values[row.right()])
    }

    /// Iterates over the reciprocal pivots of LU factors, whose product is 1/det A.
    pub fn pivots<'a, T>(&'a self, values: &'a [T]) -> impl Iterator<Item = &'a T> {
        self.rows.iter().map(|row| &values[row.diagonal as usize])
    }

    /// Solves A·x = b in place, from the LU factors `values`. `b` is in elimination order.
    pub fn solve<T: Scalar>(&self, values: &[T], b: &mut [T]) {
        let mut first = 0;
        for end in self.blocks {
            let block = first..*end as usize;
            for i in block.clone() {
                b[i] = self.reduced(self.rows[i].solved(), i, values, b);
            }
            for i in block.rev() {
                let row = &self.rows[i];
                b[i] = self.reduced(row.right().rev(), i, values, b) * values[row.diagonal as usize].clone();
            }
            first = *end as usize;
        }
    }

    /// Solves Aᵀ·x = b in place, from the LU factors that [`solve`](Self::solve) also takes.
    pub fn solve_transposed<T: Scalar>(&self, values: &[T], b: &mut [T]) {
        let subtract = |i: usize, places: Range<usize>, b: &mut [T]| {
            for place in places {
                let column = self.columns[place] as usize;
                b[column] = b[column].clone().subtract_product(values[place].clone(), b[i].clone());
            }
        };
        for (k, end) in self.blocks.iter().enumerate().rev() {
            let first = k.checked_sub(1).map_or(0, |before| self.blocks[before]);
            let block = first as usize..*end as usize;
            for i in block.clone() {
                let row = &self.rows[i];
                b[i] = b[i].clone() * values[row.diagonal as usize].clone();
                subtract(i, row.right(), b);
            }
            for i in block.rev() {
                subtract(i, self.rows[i].solved(), b);
            }
        }
    }

    /// Returns b[i] − Σ a·b[j] over the entries a of A at `places`, where j is the column of a.
    #[inline]
    fn reduced<T: Scalar>(&self, places: impl Iterator<Item = usize>, i: usize, values: &[T], b: &[T]) -> T {
        places.fold(b[i].clone(), |sum, place| {
            sum.subtract_product(values[place].clone(), b[self.columns[place] as usize].clone())
        })
    }

    /// Iterates over the entries of f′ in the order of `places`, as pairs of a row and a column.
    pub fn pairs(&self) -> impl Iterator<Item = (usize, usize)> {
        let mut row = 0;
        self.places.iter().map(move |&place| {
            while self.rows[row].end <= place {
                row += 1;
            }
            (self.order[row] as usize, self.order[self.columns[place as usize] as usize] as usize)
        })
    }

    /// Returns the largest number of entries in a row of A before elimination.
    #[must_use]
    pub fn widest_row(&self) -> usize {
        let width = |row: &CouplingRow| {
            let slopes = self.places.iter().filter(|place| (row.start..row.end).contains(place));
            let others = slopes.filter(|place| **place != row.diagonal);
            1 + others.count()
        };
        self.rows.iter().map(width).max().unwrap_or(0)
    }
}
