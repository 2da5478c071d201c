//! Bursts: the points of a group of trajectories at several consecutive steps.
//!
//! A group has as many trajectories as the widest register has lanes of `f32`.

use crate::Level;
use crate::ensemble::columns::{GROUP, Group};

/// The number of steps that a group advances before its observers read the points.
pub(super) const BURST_STEPS: usize = 16;

/// The observers of a group's trajectories, one per lane. Unused lanes hold `None`.
pub type Observers<'a, O> = [Option<&'a mut O>; GROUP];

/// The points of a group of trajectories, stored as one column for each variable.
pub trait Grouped<T>: Clone + AsRef<[Group<T>]> + AsMut<[Group<T>]> {
    /// The type of one trajectory's point.
    type Point: AsRef<[T]> + AsMut<[T]>;

    /// Returns the point of the trajectory in this lane.
    fn of(&self, lane: usize) -> Self::Point;

    /// Writes the point of the trajectory in this lane into `point`.
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

/// Tangent vectors of a group's trajectories, one trajectory per SIMD lane.
#[derive(Debug)]
pub struct SideBySide<'a, T, P> {
    /// The consecutive points of the group.
    pub places: &'a [P],
    /// The vectors at the first point. Each vector has one column per variable.
    pub vectors: &'a mut [P],
    /// The squared lengths of the vectors after each step, empty if no lengths are needed.
    pub squares: &'a mut [Group<T>],
    /// The instruction set that propagates the vectors.
    pub level: Level,
}

/// Consecutive points of each trajectory of a group.
#[derive(Debug)]
pub struct Burst<'a, P> {
    pub(super) before: u64,
    /// The last point of the previous burst, and then the points of this burst.
    pub(super) seen: &'a [P],
    pub(super) level: Level,
}

impl<P> Burst<'_, P> {
    /// Returns the new points of all trajectories with their step numbers.
    pub fn steps(&self) -> impl Iterator<Item = (u64, &P)> {
        (self.before + 1..).zip(&self.seen[1..])
    }

    /// Passes the new points of one trajectory to `look`, with their step numbers. The first `done`
    /// points are skipped.
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
