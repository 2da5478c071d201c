//! The points of a group of orbits, whose number of variables is known at run time.

use kahan_core::observe::{Group, Grouped};
use smallvec::SmallVec;

use super::{MachineFloat, RuntimePoint};

/// A column a variable; up to four are no allocation.
#[derive(Clone, Debug)]
pub(super) struct RuntimeGroup<T>(SmallVec<[Group<T>; 4]>);

impl<T: MachineFloat> RuntimeGroup<T> {
    /// As many trajectories from this one on as make a group; where they are fewer, copies of the
    /// last one fill it.
    pub(super) fn gather(columns: &[&mut [T]], first: usize) -> Self {
        let gather =
            |column: &&mut [T]| core::array::from_fn(|lane| column[(first + lane).min(column.len() - 1)]);
        RuntimeGroup(columns.iter().map(gather).collect())
    }

    /// Puts them back.
    pub(super) fn scatter(&self, columns: &mut [&mut [T]], first: usize) {
        for (column, group) in columns.iter_mut().zip(&self.0) {
            column[first..].iter_mut().zip(group).for_each(|(entry, own)| *entry = *own);
        }
    }

    /// Replaces the point of a trajectory.
    pub(super) fn put(&mut self, lane: usize, point: &[T]) {
        self.0.iter_mut().zip(point).for_each(|(column, entry)| column[lane] = *entry);
    }
}

impl<T> AsRef<[Group<T>]> for RuntimeGroup<T> {
    fn as_ref(&self) -> &[Group<T>] {
        &self.0
    }
}

impl<T> AsMut<[Group<T>]> for RuntimeGroup<T> {
    fn as_mut(&mut self) -> &mut [Group<T>] {
        &mut self.0
    }
}

impl<T: MachineFloat> Grouped<T> for RuntimeGroup<T> {
    type Point = RuntimePoint<T>;

    fn of(&self, lane: usize) -> RuntimePoint<T> {
        self.0.iter().map(|column| column[lane]).collect()
    }
}
