//! The steps of an orbit at which rows are taken, and a loop over these steps in floats.

use std::num::NonZeroU64;
use std::ops::ControlFlow;

use kahan_runtime::{DimensionError, End, Follow, Followed};

/// The steps at which rows are taken: after a transient, and then after every `every` steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RowSchedule {
    /// The number of steps before the first row.
    pub transient: u64,
    /// The number of steps after the first row; `every` need not divide it.
    pub steps: u64,
    /// The number of steps between rows.
    pub every: NonZeroU64,
}

impl RowSchedule {
    /// Returns the schedule of an orbit; `None` if `every` is 0.
    #[must_use]
    pub fn new(transient: u64, steps: u64, every: u64) -> Option<Self> {
        Some(RowSchedule { transient, steps, every: NonZeroU64::new(every)? })
    }

    /// Returns the number of steps to the last point.
    #[must_use]
    pub fn in_all(&self) -> u64 {
        self.transient.saturating_add(self.steps)
    }

    /// Returns the number of rows.
    #[must_use]
    pub fn rows(&self) -> u64 {
        (self.steps / self.every).saturating_add(1)
    }

    pub(super) fn steps_to(&self, row: u64) -> u64 {
        self.transient + row * self.every.get()
    }

    /// Follows an orbit from `x` to its last point and writes the scheduled points into `rows`.
    /// Reports the number of rows that were filled; the remaining rows stay unchanged.
    ///
    /// # Errors
    /// [`DimensionError`] if `x` does not have the length of a state, or the length of `rows` is
    /// not a multiple of it.
    ///
    /// # Panics
    /// If `rows` has no room for the first row.
    pub fn follow<S: Follow>(
        &self,
        step: &S,
        x: &mut [S::Scalar],
        rows: &mut [S::Scalar],
        mut watch: impl FnMut(u64) -> ControlFlow<()>,
    ) -> Result<Followed<usize>, DimensionError> {
        let settled = step.follow(x, self.transient, &mut watch)?;
        if settled.end != End::Complete {
            return Ok(Followed { report: 0, end: settled.end });
        }
        let (first, rest) = rows.split_at_mut(x.len());
        first.copy_from_slice(x);
        let Followed { report, end } = step.rows(x, self.every, rest, &mut watch)?;
        // The remaining steps, after the last row, show whether the orbit can be completed.
        let left = self.steps % self.every;
        let end = match end {
            End::Complete if left > 0 => step.follow(x, left, watch)?.end.after(self.in_all() - left),
            end => end.after(self.transient),
        };
        Ok(Followed { report: report + 1, end })
    }
}
