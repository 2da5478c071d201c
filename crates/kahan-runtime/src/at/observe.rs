//! Observation of many orbits. They run in SIMD lanes if machine code exists, the maps are alike,
//! and there are at most eight variables.
//!
//! In: one map for all orbits or one for each, first points, and observers. Out: reports. Points
//! and reports equal those of single orbits bit for bit.

use core::array::from_fn;
use core::cell::Cell;
use core::ops::ControlFlow;

use kahan_core::observe::{Burst, GROUP, Grouped, Observer, Observers, observe_group};
use kahan_core::{EnsembleScalar, Level, Scalar};

use super::group::RuntimeGroup;
use super::{MachineFloat, MapAt, RuntimePoint};
use crate::dimension::Argument;
use crate::engine::{CompiledStages, GroupCode};
use crate::follow::{is_within, pause};
use crate::{DimensionError, End, Followed};

impl<T: MachineFloat> MapAt<T> {
    /// Advances many orbits by `steps` steps, each with its own observers.
    ///
    /// Column c holds variable c of all orbits; `maps` is one map for all, or one for each.
    /// `observers` makes the observers of the orbit with a given index. Observers see the first
    /// point as step 0. Points and reports equal those of single orbits.
    ///
    /// # Errors
    /// [`DimensionError`] for columns whose lengths do not fit the maps or each other.
    ///
    /// ```
    /// use kahan_core::observe::Fli;
    /// use kahan_runtime::{Field, MapAt};
    ///
    /// let field = Field::parse("xdot = p; ydot = q; pdot = -x - 2*x*y; qdot = y^2 - x^2 - y;").unwrap();
    /// let map = field.map().unwrap().at(0.05);
    /// let mut columns = [[0.0, 0.0], [0.1, -0.2], [0.3, 0.49], [0.0, 0.0]];
    /// let mut columns = columns.each_mut().map(|column| &mut column[..]);
    /// let indicators = MapAt::observe_columns(&[&map], &mut columns, 5000, |_| Fli::new(&map)).unwrap();
    /// assert!(indicators[0] < 10.0 && indicators[1] > 20.0);
    /// ```
    pub fn observe_columns<O: Observer<T>>(
        maps: &[&Self],
        columns: &mut [&mut [T]],
        steps: u64,
        observers: impl Fn(usize) -> O,
    ) -> Result<Vec<O::Report>, DimensionError> {
        Self::observe_columns_while(maps, columns, steps, observers, &|_| ControlFlow::Continue(()))
    }

    /// Observes like [`observe_columns`](Self::observe_columns). Every few thousand steps, `tell`
    /// receives the number of steps since its last call. If `tell` returns `Break`, the work stops,
    /// and the reports cover the points seen so far.
    ///
    /// # Errors
    /// [`DimensionError`], as for [`observe_columns`](Self::observe_columns).
    pub fn observe_columns_while<O: Observer<T>>(
        maps: &[&Self],
        columns: &mut [&mut [T]],
        steps: u64,
        observers: impl Fn(usize) -> O,
        tell: &dyn Fn(u64) -> ControlFlow<()>,
    ) -> Result<Vec<O::Report>, DimensionError> {
        Self::observe_groups(maps, columns, steps, observers, tell, |_, _, _, _| false)
    }

    /// Observes orbits in groups. `has_observed` observes a group, or leaves this to
    /// `observe_groups` by returning `false`.
    pub(crate) fn observe_groups<O: Observer<T>>(
        maps: &[&Self],
        columns: &mut [&mut [T]],
        steps: u64,
        observers: impl Fn(usize) -> O,
        tell: &dyn Fn(u64) -> ControlFlow<()>,
        has_observed: impl Fn(
            [&Self; GROUP],
            &mut RuntimeGroup<T>,
            &mut [O],
            &mut dyn FnMut(u64) -> ControlFlow<()>,
        ) -> bool,
    ) -> Result<Vec<O::Report>, DimensionError> {
        let pause = pause(columns.len());
        let orbits = columns.first().map_or(0, |column| column.len());
        if maps.len() != 1 {
            DimensionError::check(Argument::Maps, maps.len(), orbits)?;
        }
        maps.iter().try_for_each(|map| map.check_columns(columns).map(|_| ()))?;
        let mut reports = Vec::with_capacity(orbits);
        for first in (0..orbits).step_by(GROUP) {
            let end = orbits.min(first + GROUP);
            let own = from_fn(|lane| maps[(first + lane).min(end - 1).min(maps.len() - 1)]);
            let mut observed: Vec<O> = (first..end).map(&observers).collect();
            let told = Cell::new((0, ControlFlow::Continue(())));
            let tell = |more: u64| {
                let (made, mut flow) = told.get();
                let made = made + more;
                let is_time = flow.is_continue() && made >= pause;
                if is_time {
                    flow = tell(made);
                }
                told.set((if is_time { 0 } else { made }, flow));
                flow
            };
            let group = (end - first) as u64;
            let points = RuntimeGroup::gather(columns, first);
            let is_seen = points.is_some_and(|mut points| {
                let tell = &mut |more| tell(more * group);
                let is_seen = has_observed(own, &mut points, &mut observed, tell)
                    || Self::has_observed_group(own, &mut points, &mut observed, steps, tell);
                if is_seen {
                    points.scatter(columns, first);
                }
                is_seen
            });
            if !is_seen {
                for (orbit, (map, observer)) in (first..).zip(own.into_iter().zip(&mut observed)) {
                    map.observe_alone(columns, orbit, observer, steps, tell);
                }
            }
            reports.extend(observed.into_iter().map(O::report));
        }
        Ok(reports)
    }

    pub(crate) fn has_observed_group<O: Observer<T>>(
        maps: [&Self; GROUP],
        points: &mut RuntimeGroup<T>,
        observers: &mut [O],
        steps: u64,
        tell: &mut dyn FnMut(u64) -> ControlFlow<()>,
    ) -> bool {
        let Some(abreast) = Self::group_code(maps) else { return false };
        let advance = |points: &mut _| abreast.step(RuntimeGroup::as_mut(points));
        observe_group(points, observers, steps, Level::best(), advance, tell);
        true
    }

    fn observe_alone(
        &self,
        columns: &mut [&mut [T]],
        orbit: usize,
        observer: &mut impl Observer<T>,
        steps: u64,
        tell: impl Fn(u64) -> ControlFlow<()>,
    ) {
        let mut x: RuntimePoint<T> = columns.iter().map(|column| column[orbit]).collect();
        observer.observe(0, &x);
        for step in 1..=steps {
            if observer.is_done() {
                self.advance_checked([&mut x, &mut []], steps + 1 - step);
                break;
            }
            self.advance_checked([&mut x, &mut []], 1);
            observer.observe(step, &x);
            if tell(1).is_break() {
                break;
            }
        }
        columns.iter_mut().zip(x).for_each(|(column, x)| column[orbit] = x);
    }

    pub(super) fn group_code(maps: [&Self; GROUP]) -> Option<GroupCode<T>> {
        let [first, ..] = maps;
        first.engine().group_code(Self::coded_group(maps)?, first.set, Vec::new())
    }

    /// Returns machine code that steps orbits with their tangent vectors. `carried` holds the
    /// number of vectors, and whether the code also computes their squared lengths.
    pub(crate) fn group_code_with_vectors(
        maps: [&Self; GROUP],
        carried: (usize, bool),
        workspace: Vec<T>,
    ) -> Option<GroupCode<T>> {
        let [first, ..] = maps;
        let constants = first.has_tangent_line().then(|| maps.map(|map| &map.constants[..]))?;
        let stages = Self::coded_group(maps)?;
        first.engine().group_code_with_vectors(stages, Some(constants), carried, first.set, workspace)
    }

    /// Returns code for points x and vectors v: Kahan's map of ẋ = f(x), v̇ = f′(x)v.
    pub(super) fn variational_abreast(
        maps: [&Self; GROUP],
        vectors: usize,
        workspace: Vec<T>,
    ) -> Option<GroupCode<T>> {
        let variational = maps.map(Self::variational);
        let [first, ..] = variational;
        let stages = Self::coded_group(variational)?;
        first.engine().group_code_with_vectors(stages, None, (vectors, true), first.set, workspace)
    }

    fn coded_group(maps: [&Self; GROUP]) -> Option<[&CompiledStages<T>; GROUP]> {
        let [first, ..] = maps;
        let mut stages = [first.coded.as_ref()?; GROUP];
        for (stages, map) in stages.iter_mut().zip(maps) {
            *stages = map.coded.as_ref().filter(|_| map.is_like(first))?;
        }
        Some(stages)
    }

    pub(super) fn is_like(&self, other: &Self) -> bool {
        core::ptr::eq(self.engine(), other.engine()) && self.set == other.set && self.kind == other.kind
    }
}

/// Observers that see only the finite points of an orbit; the report says how the orbit ended.
///
/// The start is always observed. In [`MapAt::observe_columns`], the columns continue to advance
/// after the end of the orbit.
#[derive(Clone, Debug)]
pub struct WhileFinite<O> {
    pub(crate) observers: O,
    pub(crate) bound: f64,
    pub(crate) end: End,
}

impl<O> WhileFinite<O> {
    /// Shows only finite points to `observers`.
    #[must_use]
    pub fn new(observers: O) -> Self {
        Self::within(f64::MAX, observers)
    }

    /// Shows points up to and including the first point at which some |xᵢ| exceeds `bound`. There
    /// the orbit has [escaped](End::Escaped).
    #[must_use]
    pub fn within(bound: f64, observers: O) -> Self {
        WhileFinite { observers, bound, end: End::Complete }
    }
}

impl<T: Scalar, O: Observer<T>> Observer<T> for WhileFinite<O> {
    type Report = Followed<O::Report>;

    fn observe(&mut self, step: u64, x: &[T]) {
        if self.end != End::Complete {
            return;
        }
        let is_finite = is_within(x, f64::MAX);
        if is_finite || step == 0 {
            self.observers.observe(step, x);
        }
        self.end = match is_finite {
            false => End::Range(step.saturating_sub(1)),
            true if !is_within(x, self.bound) => End::Escaped(step),
            true if self.observers.is_done() => End::Stopped(step),
            true => return,
        };
    }

    fn is_done(&self) -> bool {
        self.end != End::Complete
    }

    fn report(self) -> Self::Report {
        Followed { report: self.observers.report(), end: self.end }
    }

    /// Shows the points of a burst to all observers together, until an orbit ends. Without a bound,
    /// only the last points are tested, because nonfinite points stay nonfinite.
    fn observe_burst<P: Grouped<T>>(group: &mut Observers<'_, Self>, burst: &Burst<'_, P>)
    where
        T: EnsembleScalar,
    {
        let bound = group.iter().flatten().map(|own| own.bound).fold(f64::MAX, f64::min);
        let are_within = |points: &P| points.as_ref().iter().all(|lanes| is_within(lanes, bound));
        let go_on = match burst.steps().last() {
            Some((_, last)) if bound == f64::MAX => are_within(last),
            _ => burst.steps().all(|(_, points)| are_within(points)),
        };
        if O::MAY_END || !go_on || !group.iter().flatten().all(|own| own.end == End::Complete) {
            for (lane, own) in group.iter_mut().flatten().enumerate() {
                burst.show(lane, 0, |step, x| own.observe(step, x));
            }
            return;
        }
        O::observe_burst(&mut group.each_mut().map(|own| own.as_mut().map(|own| &mut own.observers)), burst);
    }
}
