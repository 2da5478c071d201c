//! The points of orbits that advance together, for dimensions that are known only at run time.

use core::array::from_fn;

use kahan_core::observe::{GROUP, Group, Grouped};

use super::{MachineFloat, RuntimePoint};

/// Groups of numbers aligned to cache lines, so that no load crosses two lines.
#[derive(Clone, Debug)]
#[repr(align(64))]
pub(crate) struct AlignedGroups<T, const N: usize>(pub(crate) [Group<T>; N]);

impl<T: MachineFloat, const N: usize> AlignedGroups<T, N> {
    pub(crate) fn zeros() -> Self {
        AlignedGroups([[T::zero(); GROUP]; N])
    }
}

pub(crate) const MOST: usize = 8;

#[derive(Debug)]
pub(crate) struct RuntimeGroup<T> {
    columns: AlignedGroups<T, MOST>,
    variables: usize,
}

impl<T: MachineFloat> RuntimeGroup<T> {
    /// Gathers the points of a group from columns; `None` if there are more than [`MOST`]
    /// variables.
    pub(crate) fn gather(columns: &[&mut [T]], first: usize) -> Option<Self> {
        let mut group = RuntimeGroup { columns: AlignedGroups::zeros(), variables: columns.len() };
        for (own, column) in group.columns.0.get_mut(..columns.len())?.iter_mut().zip(columns) {
            *own = from_fn(|lane| column[(first + lane).min(column.len() - 1)]);
        }
        Some(group)
    }

    pub(crate) fn scatter(&self, columns: &mut [&mut [T]], first: usize) {
        for (column, group) in columns.iter_mut().zip(self.as_ref()) {
            column[first..].iter_mut().zip(group).for_each(|(entry, own)| *entry = *own);
        }
    }
}

impl<T: Copy> Clone for RuntimeGroup<T> {
    fn clone(&self) -> Self {
        RuntimeGroup { columns: self.columns.clone(), variables: self.variables }
    }

    #[inline]
    fn clone_from(&mut self, other: &Self) {
        self.variables = other.variables;
        self.as_mut().iter_mut().zip(other.as_ref()).for_each(|(own, other)| *own = *other);
    }
}

impl<T> AsRef<[Group<T>]> for RuntimeGroup<T> {
    #[inline]
    fn as_ref(&self) -> &[Group<T>] {
        &self.columns.0[..self.variables]
    }
}

impl<T> AsMut<[Group<T>]> for RuntimeGroup<T> {
    #[inline]
    fn as_mut(&mut self) -> &mut [Group<T>] {
        &mut self.columns.0[..self.variables]
    }
}

impl<T: MachineFloat> Grouped<T> for RuntimeGroup<T> {
    type Point = RuntimePoint<T>;

    #[inline]
    fn of(&self, lane: usize) -> RuntimePoint<T> {
        self.as_ref().iter().map(|column| column[lane]).collect()
    }
}
