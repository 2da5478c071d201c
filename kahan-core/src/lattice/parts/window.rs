//! Elimination with partial pivoting in registers, in a window of rows that moves along a band.
//!
//! Each finished row starts with its reciprocal pivot. Loops have constant lengths; therefore they
//! are unrolled and numbers stay in registers.

use crate::Scalar;
use crate::ensemble::lanes::Lanes;

#[derive(Clone, Copy)]
pub(super) struct WindowRow<L, const B: usize, const R: usize, const WIDTH: usize> {
    pub(super) band: [L; WIDTH],
    /// The entries of the row in the columns of the left separator.
    pub(super) left: [[L; B]; R],
    pub(super) right: L,
}

impl<L: Scalar + Copy, const B: usize, const R: usize, const WIDTH: usize> WindowRow<L, B, R, WIDTH> {
    #[inline(always)]
    pub(super) fn zero() -> Self {
        Self { band: [L::zero(); WIDTH], left: [[L::zero(); B]; R], right: L::zero() }
    }

    /// In each lane, exchanges `self` and `other` if the first |entry| of `other` is larger.
    #[inline(always)]
    fn exchange_if_larger<T>(&mut self, other: &mut Self)
    where
        L: Lanes<T>,
    {
        let mask = other.band[0].exceeds(self.band[0]);
        if !L::any(mask) {
            return;
        }
        for k in 0..WIDTH {
            swap_where(&mut self.band[k], &mut other.band[k], mask);
        }
        for r in 0..R {
            for b in 0..B {
                swap_where(&mut self.left[r][b], &mut other.left[r][b], mask);
            }
        }
        swap_where(&mut self.right, &mut other.right, mask);
    }

    /// Returns the row with the right-hand side `right`, without columns of the left separator.
    #[inline(always)]
    pub(super) fn without_left(self, right: L) -> WindowRow<L, B, 0, WIDTH> {
        WindowRow { band: self.band, left: [], right }
    }

    /// Writes `columns` entries of the band to `numbers`, and then the entries outside the band.
    #[inline(always)]
    pub(super) fn write<T>(&self, numbers: &mut [T], place: usize, columns: usize)
    where
        L: Lanes<T>,
    {
        for k in 0..WIDTH {
            if k < columns {
                self.band[k].store(numbers, place + k * L::WIDTH);
            }
        }
        for r in 0..R {
            for b in 0..B {
                self.left[r][b].store(numbers, place + (columns + r * B + b) * L::WIDTH);
            }
        }
        self.right.store(numbers, place + (columns + R * B) * L::WIDTH);
    }

    /// Returns this row minus `multiplier` times the pivot row; the band loses its first entry.
    #[inline(always)]
    pub(super) fn reduced(&self, multiplier: L, pivot: &Self) -> Self {
        let mut next = Self::zero();
        for k in 1..WIDTH {
            next.band[k - 1] = self.band[k].subtract_product(multiplier, pivot.band[k]);
        }
        for r in 0..R {
            for b in 0..B {
                next.left[r][b] = self.left[r][b].subtract_product(multiplier, pivot.left[r][b]);
            }
        }
        next.right = self.right.subtract_product(multiplier, pivot.right);
        next
    }
}

#[inline(always)]
fn swap_where<L: Lanes<T>, T>(a: &mut L, b: &mut L, mask: L::Mask) {
    (*a, *b) = (L::choose(mask, *b, *a), L::choose(mask, *a, *b));
}

pub(super) struct Window<L, const B: usize, const R: usize, const LOWER: usize, const WIDTH: usize> {
    pub(super) rows: [WindowRow<L, B, R, WIDTH>; LOWER],
}

impl<L: Scalar + Copy, const B: usize, const R: usize, const LOWER: usize, const WIDTH: usize>
    Window<L, B, R, LOWER, WIDTH>
{
    /// Returns a window of rows of the identity, which stand for unknowns before the first unknown.
    #[inline(always)]
    pub(super) fn new() -> Self {
        let mut rows = [WindowRow::zero(); LOWER];
        for (k, row) in rows.iter_mut().enumerate() {
            row.band[k] = L::one();
        }
        Self { rows }
    }

    /// Appends a row and eliminates a column. Returns the pivot row with the reciprocal pivot.
    #[inline(always)]
    pub(super) fn push<T>(&mut self, row: WindowRow<L, B, R, WIDTH>) -> WindowRow<L, B, R, WIDTH>
    where
        L: Lanes<T>,
    {
        let Some(mut pivot) = self.rows.first().copied() else {
            let mut pivot = row;
            pivot.band[0] = L::one() / pivot.band[0];
            return pivot;
        };
        let mut row = row;
        for k in 1..LOWER {
            pivot.exchange_if_larger(&mut self.rows[k]);
        }
        pivot.exchange_if_larger(&mut row);
        pivot.band[0] = L::one() / pivot.band[0];
        for k in 1..LOWER {
            let multiplier = self.rows[k].band[0] * pivot.band[0];
            self.rows[k - 1] = self.rows[k].reduced(multiplier, &pivot);
        }
        let multiplier = row.band[0] * pivot.band[0];
        self.rows[LOWER - 1] = row.reduced(multiplier, &pivot);
        pivot
    }
}
