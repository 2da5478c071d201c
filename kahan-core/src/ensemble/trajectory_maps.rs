//! One map per trajectory, all of one field, with different ε and parameters.
//!
//! Each lane of a register holds the constants of one map. A trajectory's bits do not depend on the
//! contents of the neighbouring lanes.

use core::array::from_fn;
use std::vec::Vec;

use crate::composition::Staged;
use crate::field::linear::vector;
use crate::{KahanMap, PreparedStep, Workspace};

use super::EnsembleScalar;
use super::advance::{Advances, ColumnSlices, divide};
use super::columns::{GROUP, Group};
use super::lanes::{Lanes, OverLanes};
use super::level::Instructions;

struct TrajectoryMaps<'a, 'c, S, T, const N: usize> {
    /// The map of each lane. Padding lanes repeat the last map.
    maps: [&'a S; GROUP],
    columns: [&'c mut Group<T>; N],
    steps: u64,
}

impl<S, T, const N: usize> OverLanes<T> for TrajectoryMaps<'_, '_, S, T, N>
where
    S: Staged<T, N>,
    T: EnsembleScalar,
{
    type Output = Option<()>;
    const IS_SMALL: bool = false;

    #[inline(always)]
    fn run<L: Lanes<T>>(self) -> Option<()> {
        let Self { maps, mut columns, steps } = self;
        // Advances two registers at a time, which hides latency.
        for part in (0..GROUP).step_by(2 * L::WIDTH) {
            let parts = [part, (part + L::WIDTH) % GROUP];
            let [first, second] = parts.map(|part| {
                let own = from_fn::<_, GROUP, _>(|lane| maps[(part + lane) % GROUP]);
                S::zip_stages(own, |each| {
                    let prepared = each.map(|at| &at.prepared);
                    PreparedStep::gather(prepared, |own| L::load(&own.map(|own| *own), 0))
                })
            });
            let stages = [first?, second?];
            let mut x = parts.map(|part| vector(from_fn(|c| L::load(&columns[c][..], part))));
            for _ in 0..steps {
                for (stages, x) in stages.iter().zip(&mut x) {
                    for step in S::in_order(stages) {
                        *x = PreparedStep::<L, N>::next(step, x)?;
                    }
                }
            }
            for (part, x) in parts.into_iter().zip(&x) {
                for (entry, column) in x.iter().zip(&mut columns) {
                    entry.store(&mut column[..], part);
                }
            }
        }
        Some(())
    }
}

impl<S, T, const N: usize> TrajectoryMaps<'_, '_, S, T, N>
where
    S: Staged<T, N>,
    T: EnsembleScalar,
{
    fn advance(mut self, on: Instructions) -> Result<(), T> {
        if S::zip_stages(self.maps, |_| ()).is_none() {
            return self.in_turn(on);
        }
        if <S::Map as KahanMap<T, N>>::Prepared::HAS_LANES {
            let columns = self.columns.each_mut().map(|column| &mut **column);
            let each = TrajectoryMaps { maps: self.maps, columns, steps: self.steps };
            if let Some(done) = T::over_lanes(each, on.level) {
                return done.ok_or(*self.maps[0].eps());
            }
        }
        for (lane, map) in self.maps.into_iter().enumerate() {
            let mut x: [T; N] = from_fn(|c| self.columns[c][lane]);
            map.advance(&mut x, self.steps, &mut Workspace::new()).map_err(|_| *map.eps())?;
            for (entry, column) in x.iter().zip(&mut self.columns) {
                column[lane] = *entry;
            }
        }
        Ok(())
    }

    /// Advances one trajectory after another, because the maps have different compositions. The
    /// trajectory and its map fill all lanes.
    fn in_turn(self, on: Instructions) -> Result<(), T> {
        let Self { maps, mut columns, steps } = self;
        for (lane, map) in maps.into_iter().enumerate() {
            let mut all: [Group<T>; N] = from_fn(|c| [columns[c][lane]; GROUP]);
            TrajectoryMaps { maps: [map; GROUP], columns: all.each_mut(), steps }.advance(on)?;
            for (all, column) in all.iter().zip(&mut columns) {
                column[lane] = all[lane];
            }
        }
        Ok(())
    }
}

#[diagnostic::do_not_recommend]
impl<S, T, const N: usize> Advances<T, N> for [S]
where
    S: Staged<T, N> + Sync,
    T: EnsembleScalar,
{
    fn count(&self) -> Option<usize> {
        Some(self.len())
    }

    fn advance(
        &self,
        first: usize,
        columns: ColumnSlices<'_, T, N>,
        steps: u64,
        on: Instructions,
    ) -> Result<(), T> {
        let work = |first: usize, mut columns: ColumnSlices<'_, T, N>| {
            let groups = columns.first().map_or(0, |column| column.len());
            (0..groups).try_for_each(|group| {
                let map = |lane: usize| &self[((first + group) * GROUP + lane).min(self.len() - 1)];
                let columns = columns.each_mut().map(|column| &mut column[group]);
                TrajectoryMaps { maps: from_fn(map), columns, steps }.advance(on)
            })
        };
        divide(first, columns, steps, &work, &Result::and)
    }
}

#[diagnostic::do_not_recommend]
impl<A, T, const N: usize> Advances<T, N> for Vec<A>
where
    [A]: Advances<T, N>,
    T: EnsembleScalar,
{
    fn count(&self) -> Option<usize> {
        self.as_slice().count()
    }

    fn advance(
        &self,
        first: usize,
        columns: ColumnSlices<'_, T, N>,
        steps: u64,
        on: Instructions,
    ) -> Result<(), T> {
        self.as_slice().advance(first, columns, steps, on)
    }
}
