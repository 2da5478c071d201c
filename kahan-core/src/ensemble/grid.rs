//! Grids of initial points: all combinations of the values of one axis per variable.

use core::array::from_fn;

use crate::{Constant, Scalar};

use super::columns::Columns;
use super::{Ensemble, EnsembleScalar};

/// Equally spaced values of one variable in a grid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Axis<T> {
    /// The first value of the variable.
    pub start: T,
    /// The last value, which is unused if `count` is 1.
    pub end: T,
    /// The number of values of the variable.
    pub count: usize,
}

impl<T: Scalar + Copy> Axis<T> {
    /// Returns value k of an axis with m + 1 values, (start·(m − k) + end·k)/m. If both ends are
    /// small integers, only the division rounds.
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
    /// Creates all points whose entry i is a value of axis i. The last variable varies fastest. The
    /// grid is empty if any axis has no values.
    ///
    /// Value k of an axis with m + 1 values is (start·(m − k) + end·k)/m. The first value is
    /// exactly `start`. If m > 0, the last value is exactly `end`.
    ///
    /// # Panics
    /// If the number of points exceeds `usize`. If memory runs out, the program aborts.
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
        // Variable c has the same value at `runs[c]` consecutive points.
        let runs: [usize; N] = from_fn(|c| axes[c + 1..].iter().map(|axis| axis.count).product());
        Self::from_columns(Columns::new(len, |i, c| axes[c].value(i / runs[c] % axes[c].count)))
    }
}

fn integer<T: Scalar>(n: usize) -> T {
    T::constant(&Constant::integer(n as i64))
}
