//! Grids of initial points.
//!
//! In: one axis a variable. Out: the ensemble of all points of their product, in a fixed order.

use core::array::from_fn;

use crate::{Constant, Scalar};

use super::columns::Columns;
use super::{Ensemble, EnsembleScalar};

/// Equally spaced values of one variable of a grid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Axis<T> {
    /// The first value.
    pub start: T,
    /// The last value, unless there is one value only.
    pub end: T,
    /// The number of values.
    pub count: usize,
}

impl<T: Scalar + Copy> Axis<T> {
    /// Value `k` of m + 1: (start·(m − k) + end·k)/m, so that the first and the last are as given
    /// and decimal fractions of integers are rounded once.
    fn value(&self, k: usize) -> T {
        let last = self.count - 1;
        match k {
            0 => self.start,
            k if k == last => self.end,
            k => (self.start * integer::<T>(last - k) + self.end * integer(k)) / integer(last),
        }
    }
}

impl<T: EnsembleScalar, const N: usize> Ensemble<T, N> {
    /// All points whose entry i is a value of axis i, the last variable running fastest, as in
    /// nested loops with the first variable outermost. Without an axis that has a value it is
    /// empty.
    ///
    /// Value k of an axis of m + 1 is (start·(m − k) + end·k)/m; the first is `start` itself and,
    /// where m > 0, the last `end` itself.
    ///
    /// # Panics
    /// If the number of points does not fit a `usize`; a number that fits and is more than memory
    /// can hold aborts, as any allocation does.
    ///
    /// ```
    /// use kahan_core::{Axis, Ensemble, vector};
    ///
    /// let axes = [Axis { start: 0.0, end: 1.0, count: 2 }, Axis { start: -1.0, end: 1.0, count: 3 }];
    /// let grid = Ensemble::grid(axes);
    /// assert_eq!(grid.len(), 6);
    /// assert_eq!(grid.point(1), Some(vector![0.0, 0.0]));
    /// assert_eq!(grid.point(3), Some(vector![1.0, -1.0]));
    /// ```
    pub fn grid(axes: [Axis<T>; N]) -> Self {
        let len = axes.iter().try_fold(1_usize, |len, axis| len.checked_mul(axis.count));
        let Some(len) = len else { panic!("a grid of more points than memory can hold") };
        // How many points share a value of each axis before the next value comes.
        let runs: [usize; N] = from_fn(|c| axes[c + 1..].iter().map(|axis| axis.count).product());
        Self::from_columns(Columns::new(len, |i, c| axes[c].value(i / runs[c] % axes[c].count)))
    }
}

/// The natural number `n` as a scalar.
fn integer<T: Scalar>(n: usize) -> T {
    // No axis has 2⁶³ values.
    T::constant(&Constant::integer(n as i64))
}
