//! Some points of a group of trajectories, one after another.
//!
//! In: as many trajectories as the widest register holds, side by side. Out: what observers of each
//! of them, or of all at once, look at.

use crate::ensemble::columns::{GROUP, Group};
use crate::{EnsembleScalar, Level};

/// Steps between two looks of an observer.
pub(super) const BURST: usize = 16;

/// The observers of a group of trajectories: as many as there are, then none.
pub type Observers<'a, O> = [Option<&'a mut O>; GROUP];

/// Some points of each trajectory of a group.
#[derive(Debug)]
pub struct Burst<'a, T, const N: usize> {
    /// The step of the first of `seen`.
    pub(super) before: u64,
    /// The points seen last, then those of the steps after them.
    pub(super) seen: &'a [[Group<T>; N]],
    /// What the ensemble runs on.
    pub(super) level: Level,
}

impl<T: EnsembleScalar, const N: usize> Burst<'_, T, N> {
    /// The points of one trajectory with their steps.
    pub(super) fn of(&self, lane: usize) -> impl Iterator<Item = (u64, [T; N])> {
        (self.before + 1..).zip(self.seen[1..].iter().map(move |points| at(points, lane)))
    }
}

/// One trajectory's point.
#[inline(always)]
pub(super) fn at<T: Copy, const N: usize>(points: &[Group<T>; N], lane: usize) -> [T; N] {
    points.each_ref().map(|column| column[lane])
}
