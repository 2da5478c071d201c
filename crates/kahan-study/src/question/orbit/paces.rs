//! Which points of an orbit are rows, and the way along them in floats.

use std::num::NonZeroU64;
use std::ops::ControlFlow;

use kahan_runtime::{DimensionError, End, Follow, Followed};

/// The points of an orbit that are shown: the first behind a transient, and those after every so
/// many of the steps behind it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Paces {
    /// The steps to the first row.
    pub transient: u64,
    /// The steps behind the first row, of which the last may lead to no row.
    pub steps: u64,
    /// The steps from row to row.
    pub every: NonZeroU64,
}

impl Paces {
    /// Returns the paces of an orbit; `None` where rows are no steps apart.
    #[must_use]
    pub fn new(transient: u64, steps: u64, every: u64) -> Option<Self> {
        Some(Paces { transient, steps, every: NonZeroU64::new(every)? })
    }

    /// The steps to the last point.
    #[must_use]
    pub fn in_all(&self) -> u64 {
        self.transient.saturating_add(self.steps)
    }

    /// The number of rows.
    #[must_use]
    pub fn rows(&self) -> u64 {
        (self.steps / self.every).saturating_add(1)
    }

    /// The steps to a row.
    pub(super) fn steps_to(&self, row: u64) -> u64 {
        self.transient + row * self.every.get()
    }

    /// Follows an orbit from `x` to its last point, and writes its rows one after the other. The
    /// report is the number of rows that were filled; the others stay as they are.
    ///
    /// # Errors
    /// [`DimensionError`] if `x` has not as many entries as a state of the map, or `rows` is not a
    /// whole number of states.
    ///
    /// # Panics
    /// Where `rows` has no room for the first row.
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
        // The steps behind the last row show whether the orbit goes as far as it was asked.
        let left = self.steps % self.every;
        let end = match end {
            End::Complete if left > 0 => step.follow(x, left, watch)?.end.after(self.in_all() - left),
            end => end.after(self.transient),
        };
        Ok(Followed { report: report + 1, end })
    }
}
