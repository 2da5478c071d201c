//! A band, cyclic or not, solved by one elimination with partial pivoting.
//!
//! In: the rows of a square system, one at a time, in the order asked for. Out: its solution. A
//! cyclic band of half-bandwidth h is an open one of 2h in the *folded* order 0, n−1, 1, n−2, …: a
//! ring pressed flat. Only what back-substitution reads is stored, U and the right-hand side; the
//! rows that may still become pivots stand in a window that moves along. Entries are added, so that
//! a ring shorter than its band, where two couplings meet in one entry, is right as well.

use std::vec;
use std::vec::Vec;

use crate::Scalar;

/// In which order the unknowns are eliminated.
#[derive(Clone, Copy, Debug)]
pub(super) enum Order {
    /// 0, 1, 2, …
    Natural,
    /// 0, n−1, 1, n−2, …
    Folded,
}

impl Order {
    /// The unknown at a place in the order.
    fn unknown(self, place: usize, len: usize) -> usize {
        match self {
            Self::Folded if place % 2 == 1 => len - 1 - place / 2,
            Self::Folded => place / 2,
            Self::Natural => place,
        }
    }

    /// The place of an unknown in the order.
    fn place(self, unknown: usize, len: usize) -> usize {
        match self {
            Self::Folded if unknown >= len.div_ceil(2) => 2 * (len - 1 - unknown) + 1,
            Self::Folded => 2 * unknown,
            Self::Natural => unknown,
        }
    }
}

/// The memory of an elimination of so many unknowns.
pub struct Folded<T> {
    order: Order,
    len: usize,
    /// How far the entries of a row reach to the left and, before exchanges, to the right.
    lower: usize,
    /// The entries of a row from its pivot on: `lower` + 1 + `upper`.
    width: usize,
    /// The rows from the current one on, `lower` + 1 of them, each from the current place on, and
    /// its right-hand side last.
    window: Vec<T>,
    /// The rows that are done, place by place, as in the window.
    done: Vec<T>,
    /// What is solved for, unknown by unknown.
    solution: Vec<T>,
}

/// A row while it is written.
pub struct Row<'a, T> {
    order: Order,
    len: usize,
    /// The place of the first entry.
    first: usize,
    entries: &'a mut [T],
}

impl<T: Scalar> Row<'_, T> {
    /// Adds to the entry of an unknown.
    pub fn add(&mut self, unknown: usize, value: T) {
        self.entries[self.order.place(unknown, self.len) - self.first] += value;
    }

    /// Adds to the right-hand side.
    pub fn add_right(&mut self, value: T) {
        if let Some(right) = self.entries.last_mut() {
            *right += value;
        }
    }
}

impl<T: Scalar> Folded<T> {
    /// For a band that reaches so far to the left and right, closed to a ring or not.
    pub fn new(len: usize, is_ring: bool, lower: usize, upper: usize) -> Self {
        let farthest = 2 * lower.max(upper);
        let (order, lower, upper) =
            if is_ring { (Order::Folded, farthest, farthest) } else { (Order::Natural, lower, upper) };
        // No row reaches beyond the system.
        let (lower, upper) = (lower.min(len - 1), upper.min(len - 1));
        let width = (lower + 1 + upper).min(len);
        Self {
            order,
            len,
            lower,
            width,
            window: vec![T::zero(); (lower + 1) * (width + 1)],
            done: vec![T::zero(); len * (width + 1)],
            solution: vec![T::zero(); len],
        }
    }

    /// The solution of the system whose row of an unknown `write` adds to one of zeros; `None`
    /// where an exact scalar has no pivot.
    pub fn solve(&mut self, mut write: impl FnMut(usize, &mut Row<'_, T>)) -> Option<&[T]> {
        let stride = self.width + 1;
        let mut rows = 0;
        for place in 0..self.len {
            // All rows that have an entry at this place; the window is full but near the end.
            while rows < self.len && rows <= place + self.lower {
                let entries = &mut self.window[(rows - place) * stride..][..stride];
                entries.fill(T::zero());
                let (order, len) = (self.order, self.len);
                write(order.unknown(rows, len), &mut Row { order, len, first: place, entries });
                rows += 1;
            }
            self.eliminate(place, rows - place)?;
        }
        self.substitute();
        Some(&self.solution)
    }

    /// What the last call solved for.
    pub(super) fn solution(&self) -> &[T] {
        &self.solution
    }

    /// Eliminates a place from the rows of the window, of which the best becomes the pivot's and is
    /// done; the others move up.
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
        // The first row's place is free now.
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

    /// From the last place to the first, with what is known of those after it.
    fn substitute(&mut self) {
        let (width, stride) = (self.width, self.width + 1);
        for place in (0..self.len).rev() {
            let row = &self.done[place * stride..][..stride];
            let mut right = row[width].clone();
            for (k, entry) in row[1..width.min(self.len - place)].iter().enumerate().rev() {
                let known = self.solution[self.order.unknown(place + 1 + k, self.len)].clone();
                right = right.subtract_product(entry.clone(), known);
            }
            self.solution[self.order.unknown(place, self.len)] = right * row[0].clone();
        }
    }
}
