//! Some points of a group of trajectories, one after another.
//!
//! In: as many trajectories as the widest register holds, side by side. Out: what observers of each
//! of them, or of all at once, look at.

use crate::Level;
use crate::ensemble::columns::{GROUP, Group};

/// Steps between two looks of an observer.
pub(super) const BURST: usize = 16;

/// The observers of a group of trajectories: as many as there are, then none.
pub type Observers<'a, O> = [Option<&'a mut O>; GROUP];

/// Points of a group of trajectories: a column a variable, in an array where the number of
/// variables is known while compiling.
pub trait Grouped<T>: Clone + AsRef<[Group<T>]> + AsMut<[Group<T>]> {
    /// A point of one of them.
    type Point: AsRef<[T]> + AsMut<[T]>;

    /// That of a trajectory.
    fn of(&self, lane: usize) -> Self::Point;

    /// The same in a place that there is.
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

/// Tangent vectors of a group of trajectories that are carried along its points side by side.
#[derive(Debug)]
pub struct SideBySide<'a, T, P> {
    /// The points, one after another.
    pub places: &'a [P],
    /// The vectors at the first of them, each as many columns as there are variables.
    pub vectors: &'a mut [P],
    /// The squares of their lengths after each step, or room for none.
    pub squares: &'a mut [Group<T>],
    /// The instructions to use.
    pub level: Level,
}

/// Some points of each trajectory of a group.
#[derive(Debug)]
pub struct Burst<'a, P> {
    /// The step of the first of `seen`.
    pub(super) before: u64,
    /// The points seen last, then those of the steps after them.
    pub(super) seen: &'a [P],
    /// What the ensemble runs on.
    pub(super) level: Level,
}

impl<P> Burst<'_, P> {
    /// The points of all of them with their steps.
    pub fn steps(&self) -> impl Iterator<Item = (u64, &P)> {
        (self.before + 1..).zip(&self.seen[1..])
    }

    /// Shows the points of one trajectory with their steps, without the first `done` of them.
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
