//! Advances an ensemble by a number of steps, on one thread or on several threads.
//!
//! Each trajectory goes through a fixed sequence of operations. Therefore its bits depend neither
//! on its index nor on the number of threads.

use crate::composition::Staged;
use crate::step::error::pole;
use crate::{Composed, KahanAt, KahanMap};

use super::columns::Group;
use super::level::Instructions;
use super::{Ensemble, EnsembleScalar};

/// One or more maps that advance points of N variables: a [`KahanAt`] for all trajectories, or a
/// slice or vector with one `KahanAt` per trajectory.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no map that moves points of {N} numbers of the type `{T}`",
    label = "not one prepared map, in the dimension and the type of number of the points",
    note = "one map, as `map.at(eps)` prepares it, moves all points of an ensemble; where parameters or ε differ, give a vector with one for each point",
    note = "a point has one entry for each equation: give `Ensemble::grid` as many axes, `Ensemble::new` such vectors"
)]
pub trait Advances<T: EnsembleScalar, const N: usize> {
    /// Returns the number of maps, one per trajectory, or `None` if all trajectories have one map.
    #[doc(hidden)]
    fn count(&self) -> Option<usize> {
        None
    }

    /// Advances columns of equal length. The index of their first `Group` in the ensemble is
    /// `first`. If a map meets a pole and T has no infinity, the error is the ε of this map.
    #[doc(hidden)]
    fn advance(
        &self,
        first: usize,
        columns: ColumnSlices<'_, T, N>,
        steps: u64,
        on: Instructions,
    ) -> Result<(), T>;
}

#[diagnostic::do_not_recommend]
impl<M, T, const N: usize> Advances<T, N> for KahanAt<M, T, N>
where
    M: KahanMap<T, N>,
    T: EnsembleScalar,
    Self: Sync,
{
    #[inline]
    fn advance(
        &self,
        first: usize,
        columns: ColumnSlices<'_, T, N>,
        steps: u64,
        on: Instructions,
    ) -> Result<(), T> {
        by_one_map(self, first, columns, steps, on)
    }
}

#[diagnostic::do_not_recommend]
impl<M, T, const N: usize> Advances<T, N> for Composed<KahanAt<M, T, N>>
where
    M: KahanMap<T, N>,
    T: EnsembleScalar,
    Self: Sync,
{
    #[inline]
    fn advance(
        &self,
        first: usize,
        columns: ColumnSlices<'_, T, N>,
        steps: u64,
        on: Instructions,
    ) -> Result<(), T> {
        by_one_map(self, first, columns, steps, on)
    }
}

#[inline]
fn by_one_map<S, T, const N: usize>(
    map: &S,
    first: usize,
    columns: ColumnSlices<'_, T, N>,
    steps: u64,
    on: Instructions,
) -> Result<(), T>
where
    S: Staged<T, N> + Sync,
    T: EnsembleScalar,
{
    let sweep = |_, columns: ColumnSlices<'_, T, N>| T::sweep(map, columns, steps, on);
    divide(first, columns, steps, &sweep, &Option::and).ok_or(*map.eps())
}

impl<T: EnsembleScalar, const N: usize> Ensemble<T, N> {
    /// Advances every point by `steps` steps of `map`. A step takes the time 2ε, with the map's ε.
    ///
    /// `map` is a [`KahanAt`], or for a higher order a [`composed`](KahanAt::composed) map. If ε or
    /// the parameters differ, pass a slice or vector with one map per point. Such maps also run in
    /// SIMD lanes, always with [`Divided`](crate::Reciprocal::Divided) reciprocals.
    ///
    /// No memory is allocated. With the feature `parallel`, large ensembles run on rayon's current
    /// thread pool, with equal bits. After a pole, a trajectory's floats are infinite or NaN. After
    /// an overflow, the trajectory may be wrong. Other trajectories are unaffected.
    ///
    /// # Panics
    /// If the number of maps differs from the number of points. If a trajectory meets a pole and
    /// the scalar has no reciprocal of zero. Some points are then further advanced than others.
    ///
    /// ```
    /// use kahan_core::Ensemble;
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// Predator and prey.
    ///     pub struct LotkaVolterra;
    ///     xdot = x*(1 - y);
    ///     ydot = y*(x - 1);
    /// }
    ///
    /// let map = LotkaVolterra.at(0.05);
    /// let mut ponds = Ensemble::new((1..=1000).map(|k| vector![0.002 * f64::from(k), 1.0]).collect());
    /// ponds.advance(&map, 100);
    ///
    /// let alone = LotkaVolterra.orbit(vector![1.5, 1.0], 0.05).nth(100).unwrap();
    /// assert!((ponds.point(749).unwrap() - alone).norm() < 1e-12);
    ///
    /// // A time step of its own for each.
    /// let maps: Vec<_> = (1..=1000).map(|k| LotkaVolterra.at(1e-4 * f64::from(k))).collect();
    /// ponds.advance(&maps, 100);
    /// ```
    #[track_caller]
    pub fn advance<M>(&mut self, map: &M, steps: u64)
    where
        M: Advances<T, N> + ?Sized,
    {
        self.check(map);
        if let Err(eps) = map.advance(0, self.columns.groups_mut(), steps, self.instructions) {
            pole(&eps)
        }
    }

    #[track_caller]
    pub(crate) fn check<M: Advances<T, N> + ?Sized>(&self, map: &M) {
        let (len, count) = (self.len(), map.count());
        assert!(count.is_none_or(|count| count == len), "{} maps for {len} points", count.unwrap_or(0));
    }
}

/// Splits the groups of the columns into ranges for threads, if this saves time. Calls `work` with
/// each range and with the index of its first group. Results of neighbouring ranges are combined by
/// `join`.
pub(crate) fn divide<T, R, const N: usize>(
    first: usize,
    columns: ColumnSlices<'_, T, N>,
    steps: u64,
    work: &(impl Fn(usize, ColumnSlices<'_, T, N>) -> R + Sync),
    join: &(impl Fn(R, R) -> R + Sync),
) -> R
where
    T: EnsembleScalar,
    R: Send,
{
    #[cfg(feature = "parallel")]
    let columns = match halves(columns, steps) {
        Ok([left, right]) => {
            let middle = first + left.first().map_or(0, |column| column.len());
            let (left, right) = rayon::join(
                || divide(first, left, steps, work, join),
                || divide(middle, right, steps, work, join),
            );
            return join(left, right);
        }
        Err(columns) => columns,
    };
    #[cfg(not(feature = "parallel"))]
    let _ = (steps, join);
    work(first, columns)
}

pub(crate) type ColumnSlices<'a, T, const N: usize> = [&'a mut [Group<T>]; N];

/// Splits the columns near the middle, or returns them in `Err` if there is too little work.
#[cfg(feature = "parallel")]
fn halves<T, const N: usize>(
    mut columns: ColumnSlices<'_, T, N>,
    steps: u64,
) -> Result<[ColumnSlices<'_, T, N>; 2], ColumnSlices<'_, T, N>> {
    use super::columns::GROUP;
    use super::sweep::groups_per_tile;

    /// The minimum number of steps in a task. These steps take some tens of microseconds.
    const STEPS_PER_TASK: u64 = 1 << 16;

    let tile = groups_per_tile::<T, N>();
    let groups = columns.first().map_or(0, |column| column.len());
    let trajectories = (groups / 2 * GROUP) as u64;
    let enough = trajectories.saturating_mul(steps) >= STEPS_PER_TASK;
    if groups <= tile || !enough {
        return Err(columns);
    }
    let middle = (groups / 2).next_multiple_of(tile);
    let right = columns.each_mut().map(|column| {
        let (left, right) = core::mem::take(column).split_at_mut(middle);
        *column = left;
        right
    });
    Ok([columns, right])
}
