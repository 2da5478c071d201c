//! Solves a banded system, cyclic or not, by elimination with partial pivoting.
//!
//! A cyclic band of half-bandwidth h is an ordinary band of half-bandwidth 2h in the *folded* order
//! 0, n−1, 1, n−2, …. If a ring is shorter than its band, entries of the band that have the same
//! row and column are added. To save memory, a solver may keep only some rows of U; back
//! substitution then eliminates the other rows again.

use std::vec;
use std::vec::Vec;

use crate::Scalar;

#[derive(Clone, Copy, Debug)]
pub(super) enum EliminationOrder {
    Natural,
    Folded,
}

impl EliminationOrder {
    fn unknown(self, place: usize, len: usize) -> usize {
        match self {
            Self::Folded if place % 2 == 1 => len - 1 - place / 2,
            Self::Folded => place / 2,
            Self::Natural => place,
        }
    }

    fn place(self, unknown: usize, len: usize) -> usize {
        match self {
            Self::Folded if unknown >= len.div_ceil(2) => 2 * (len - 1 - unknown) + 1,
            Self::Folded => 2 * unknown,
            Self::Natural => unknown,
        }
    }
}

pub(super) struct FoldedBand<T> {
    order: EliminationOrder,
    len: usize,
    lower: usize,
    /// The number of entries in a row, from the pivot on: `lower` + 1 + `upper`.
    width: usize,
    /// The number of successive rows of U that are stored together.
    stretch: usize,
    /// The `lower` + 1 rows from which the next pivot is chosen, with their right-hand sides.
    window: Vec<T>,
    /// The finished rows of U for `stretch` columns, stored in the layout of `window`.
    done: Vec<T>,
    /// Copies of `window`, made before the columns 0, `stretch`, 2·`stretch`, ….
    begun: Vec<T>,
    solution: Vec<T>,
}

pub(super) struct BandRow<'a, T> {
    order: EliminationOrder,
    len: usize,
    first: usize,
    entries: &'a mut [T],
}

impl<T: Scalar> BandRow<'_, T> {
    pub(super) fn add(&mut self, unknown: usize, value: T) {
        self.entries[self.order.place(unknown, self.len) - self.first] += value;
    }

    pub(super) fn add_right(&mut self, value: T) {
        if let Some(right) = self.entries.last_mut() {
            *right += value;
        }
    }
}

impl<T: Scalar> FoldedBand<T> {
    /// Allocates the memory for a band of these bandwidths. `is_ring` makes the band cyclic.
    pub(super) fn new(len: usize, is_ring: bool, lower: usize, upper: usize) -> Self {
        Self::in_stretches(len, is_ring, lower, upper, len)
    }

    /// Allocates less memory than `new`, but a long system takes about twice the operations.
    pub(super) fn with_little_memory(len: usize, is_ring: bool, lower: usize, upper: usize) -> Self {
        const WINDOWS: usize = 64;
        let window = 2 * lower.max(upper) + 1;
        Self::in_stretches(len, is_ring, lower, upper, WINDOWS * window)
    }

    fn in_stretches(len: usize, is_ring: bool, lower: usize, upper: usize, stretch: usize) -> Self {
        let farthest = 2 * lower.max(upper);
        let (order, lower, upper) = if is_ring {
            (EliminationOrder::Folded, farthest, farthest)
        } else {
            (EliminationOrder::Natural, lower, upper)
        };
        let (lower, upper) = (lower.min(len - 1), upper.min(len - 1));
        let (width, stretch) = ((lower + 1 + upper).min(len), stretch.min(len));
        let window = (lower + 1) * (width + 1);
        Self {
            order,
            len,
            lower,
            width,
            stretch,
            window: vec![T::zero(); window],
            done: vec![T::zero(); stretch * (width + 1)],
            begun: vec![T::zero(); len.div_ceil(stretch).saturating_sub(1) * window],
            solution: vec![T::zero(); len],
        }
    }

    /// Solves the system. `write` adds the entries of a row to zeros, and may be called twice for a
    /// row. Returns `None` if an exact scalar has no nonzero pivot.
    pub(super) fn solve(&mut self, mut write: impl FnMut(usize, &mut BandRow<'_, T>)) -> Option<&[T]> {
        let (stretch, window) = (self.stretch, self.window.len());
        let last = (self.len - 1) / stretch;
        for index in 0..last {
            self.begun[index * window..][..window].clone_from_slice(&self.window);
            self.eliminate_stretch(index * stretch, &mut write)?;
        }
        self.eliminate_stretch(last * stretch, &mut write)?;
        self.substitute(last * stretch);
        for index in (0..last).rev() {
            self.window.clone_from_slice(&self.begun[index * window..][..window]);
            self.eliminate_stretch(index * stretch, &mut write)?;
            self.substitute(index * stretch);
        }
        Some(&self.solution)
    }

    fn eliminate_stretch(
        &mut self,
        begin: usize,
        write: &mut impl FnMut(usize, &mut BandRow<'_, T>),
    ) -> Option<()> {
        let stride = self.width + 1;
        let mut rows = if begin == 0 { 0 } else { self.len.min(begin + self.lower) };
        for place in begin..self.len.min(begin + self.stretch) {
            while rows < self.len && rows <= place + self.lower {
                let entries = &mut self.window[(rows - place) * stride..][..stride];
                entries.fill(T::zero());
                let (order, len) = (self.order, self.len);
                write(order.unknown(rows, len), &mut BandRow { order, len, first: place, entries });
                rows += 1;
            }
            self.eliminate(place - begin, rows - place)?;
        }
        Some(())
    }

    pub(super) fn solution(&self) -> &[T] {
        &self.solution
    }

    /// Eliminates a column: moves the pivot row to `done`, and moves the other rows up.
    fn eliminate(&mut self, place: usize, rows: usize) -> Option<()> {
        let (width, stride) = (self.width, self.width + 1);
        let mut best = 0;
        for row in 1..rows {
            if self.window[row * stride].is_better_pivot(&self.window[best * stride]) {
                best = row;
            }
        }
        let pivot_row = &mut self.done[place * stride..][..stride];
        pivot_row.clone_from_slice(&self.window[best * stride..][..stride]);
        if best > 0 {
            let (first, others) = self.window.split_at_mut(best * stride);
            others[..stride].clone_from_slice(&first[..stride]);
        }
        let reciprocal = pivot_row[0].reciprocal()?;
        pivot_row[0] = reciprocal.clone();
        for row in 1..rows {
            let (above, rest) = self.window.split_at_mut(row * stride);
            let (target, row) = (&mut above[(row - 1) * stride..], &rest[..stride]);
            if row[0].is_zero() {
                target[..width - 1].clone_from_slice(&row[1..width]);
                target[width] = row[width].clone();
            } else {
                let multiplier = row[0].clone() * reciprocal.clone();
                let reduced =
                    |k: usize| row[k].clone().subtract_product(multiplier.clone(), pivot_row[k].clone());
                for k in 1..width {
                    target[k - 1] = reduced(k);
                }
                target[width] = reduced(width);
            }
            target[width - 1] = T::zero();
        }
        Some(())
    }

    /// Computes the unknowns of a stretch by back substitution. The later unknowns must be known.
    fn substitute(&mut self, begin: usize) {
        let (width, stride) = (self.width, self.width + 1);
        for place in (begin..self.len.min(begin + self.stretch)).rev() {
            let row = &self.done[(place - begin) * stride..][..stride];
            let mut right = row[width].clone();
            for (k, entry) in row[1..width.min(self.len - place)].iter().enumerate().rev() {
                let known = self.solution[self.order.unknown(place + 1 + k, self.len)].clone();
                right = right.subtract_product(entry.clone(), known);
            }
            self.solution[self.order.unknown(place, self.len)] = right * row[0].clone();
        }
    }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::FoldedBand;

    /// Returns an entry of a test matrix. Every third diagonal entry is 0; therefore rows must be
    /// exchanged.
    fn entry(row: usize, offset: isize) -> f64 {
        if offset == 0 && row % 3 == 1 { 0.0 } else { ((row * 7 + 3) as f64 * 0.1 + offset as f64).sin() }
    }

    fn solved(folded: &mut FoldedBand<f64>, len: usize, is_ring: bool, reach: isize) -> Vec<f64> {
        let solution = folded.solve(|unknown, row| {
            for offset in -reach..=reach {
                let place = unknown as isize + offset;
                if is_ring || (0..len as isize).contains(&place) {
                    row.add(place.rem_euclid(len as isize) as usize, entry(unknown, offset));
                }
            }
            row.add_right(1.0 + unknown as f64);
        });
        solution.unwrap().to_vec()
    }

    #[test]
    fn stretches_change_no_bit() {
        for (len, is_ring, reach) in [(1000, true, 1), (1000, false, 3), (777, true, 2), (40, true, 2)] {
            let whole =
                solved(&mut FoldedBand::new(len, is_ring, reach, reach), len, is_ring, reach as isize);
            for stretch in [1, 7, 13, 64, 999] {
                let mut folded = FoldedBand::in_stretches(len, is_ring, reach, reach, stretch);
                for _ in 0..2 {
                    let parts = solved(&mut folded, len, is_ring, reach as isize);
                    assert!(parts == whole, "{len} {is_ring} {reach} {stretch}");
                }
            }
        }
    }

    #[test]
    fn what_is_rarely_needed_takes_a_number_or_two_an_unknown() {
        let (len, reach) = (1_000_000, 17);
        let folded = FoldedBand::<f64>::with_little_memory(len, true, reach, reach);
        let numbers = [&folded.window, &folded.done, &folded.begun, &folded.solution].map(Vec::len);
        assert!(numbers.iter().sum::<usize>() < 3 * len, "{numbers:?}");
    }
}
