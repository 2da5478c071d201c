//! Bursts: the points of several consecutive steps of a group of trajectories.
//!
//! A group has as many trajectories as the widest register has lanes; observers read its points.

use crate::Level;
use crate::ensemble::columns::{GROUP, Group};

/// The number of steps that a group advances before its observers read the points.
pub(super) const BURST: usize = 16;

/// The observers of the trajectories of a group, followed by `None` in unused lanes.
pub type Observers<'a, O> = [Option<&'a mut O>; GROUP];

/// The points of a group of trajectories: one column for each variable.
pub trait Grouped<T>: Clone + AsRef<[Group<T>]> + AsMut<[Group<T>]> {
    /// The type of one trajectory's point.
    type Point: AsRef<[T]> + AsMut<[T]>;

    /// Returns the point of a trajectory.
    fn of(&self, lane: usize) -> Self::Point;

    /// Like [`of`](Self::of), but writes into `point`.
    #[inline(always)]
    fn read(&self, lane: usize, point: &mut [T])
    where
        T: Copy,
    {
        for (entry, column) in point.iter_mut().zip(self.as_ref()) {
            *entry = column[lane];
        }
    }
}

impl<T: Copy, const N: usize> Grouped<T> for [Group<T>; N] {
    type Point = [T; N];

    #[inline(always)]
    fn of(&self, lane: usize) -> [T; N] {
        self.each_ref().map(|column| column[lane])
    }
}

/// Tangent vectors to propagate for all trajectories of a group, in SIMD lanes.
#[derive(Debug)]
pub struct SideBySide<'a, T, P> {
    /// The consecutive points.
    pub places: &'a [P],
    /// The vectors at the first point; each has one column per variable.
    pub vectors: &'a mut [P],
    /// The squared lengths of the vectors after each step; empty if not needed.
    pub squares: &'a mut [Group<T>],
    /// The instruction set to use.
    pub level: Level,
}

/// Consecutive points of every trajectory of a group.
#[derive(Debug)]
pub struct Burst<'a, P> {
    pub(super) before: u64,
    /// The last point already shown, then the points of the following steps.
    pub(super) seen: &'a [P],
    pub(super) level: Level,
}

impl<P> Burst<'_, P> {
    /// Returns the new points of all trajectories with their step numbers.
    pub fn steps(&self) -> impl Iterator<Item = (u64, &P)> {
        (self.before + 1..).zip(&self.seen[1..])
    }

    /// Shows the new points of one trajectory except the first `done`, with their step numbers.
    #[inline(always)]
    pub fn show<T: Copy>(&self, lane: usize, done: usize, mut look: impl FnMut(u64, &[T]))
    where
        P: Grouped<T>,
    {
        let mut x = self.seen[0].of(lane);
        for (step, points) in self.steps().skip(done) {
            points.read(lane, x.as_mut());
            look(step, x.as_ref());
        }
    }
}
