//! Observation of every trajectory of an ensemble.
//!
//! A group of trajectories takes a burst of steps, then the group's observers read the new points,
//! and so on. For few variables, each of these two loops keeps its data in the first-level cache.

use core::array::from_fn;
use core::ops::ControlFlow;
use std::vec::Vec;

use crate::ensemble::advance::{ColumnSlices, divide};
use crate::ensemble::columns::{GROUP, Group};
use crate::step::error::pole;
use crate::{Advances, Ensemble, EnsembleScalar, Level};

use super::Observer;
use super::burst::{BURST_STEPS, Burst, Grouped};

impl<T: EnsembleScalar, const N: usize> Ensemble<T, N> {
    /// Steps as [`advance`](Self::advance) does, and shows each trajectory to its own observers.
    ///
    /// The function `observers` creates the observers of trajectory i, which starts with
    /// [`point`](Self::point) i as step 0. Reports depend neither on i nor on threads. With the
    /// feature `parallel`, large ensembles run on rayon's current thread pool.
    ///
    /// # Panics
    /// If a trajectory meets a pole of an exact scalar. If the number of maps differs from that of
    /// points.
    ///
    /// ```
    /// use kahan_core::Ensemble;
    /// use kahan_core::observe::{Escape, Sali};
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
    /// let mut ponds = Ensemble::new((1..=100).map(|k| vector![0.01 * f64::from(k), 1.0]).collect());
    /// let many_prey = |x: &[f64]| x[0] > 2.0;
    /// let reports = ponds.observe(&map, 500, |_| (Escape::when(many_prey), Sali::new(&map)));
    /// assert!(reports[0].0.is_some() && reports[99].0.is_none());
    /// ```
    pub fn observe<M, O>(
        &mut self,
        map: &M,
        steps: u64,
        observers: impl Fn(usize) -> O + Sync,
    ) -> Vec<O::Report>
    where
        M: Advances<T, N> + Sync + ?Sized,
        O: Observer<T, Report: Send>,
    {
        let (len, on) = (self.len(), self.instructions);
        self.check(map);
        let advance = |number: usize, group: &mut [Group<T>; N]| {
            if let Err(eps) = map.advance(number, group.each_mut().map(core::slice::from_mut), 1, on) {
                pole(&eps)
            }
        };
        let observe = |first: usize, mut columns: ColumnSlices<'_, T, N>| {
            let mut reports = Vec::new();
            let groups = columns.first().map_or(0, |column| column.len());
            for group in 0..groups {
                let start = (first + group) * GROUP;
                let mut observed: Vec<O> = (start..len.min(start + GROUP)).map(&observers).collect();
                let mut points: [Group<T>; N] = from_fn(|c| columns[c][group]);
                let advance = |points: &mut _| advance(first + group, points);
                observe_group(&mut points, &mut observed, steps, on.level, advance, |_| {
                    ControlFlow::Continue(())
                });
                for (column, points) in columns.iter_mut().zip(points) {
                    column[group] = points;
                }
                reports.extend(observed.into_iter().map(O::report));
            }
            reports
        };
        let join = |mut left: Vec<_>, right: Vec<_>| {
            left.extend(right);
            left
        };
        divide(0, self.columns.groups_mut(), steps, &observe, &join)
    }
}

/// Advances a group of trajectories and shows every step to the observers. After each burst, `tell`
/// gets the number of steps taken and may stop the run.
pub fn observe_group<T: EnsembleScalar, O: Observer<T>, P: Grouped<T>>(
    points: &mut P,
    observers: &mut [O],
    steps: u64,
    level: Level,
    advance: impl Fn(&mut P),
    mut tell: impl FnMut(u64) -> ControlFlow<()>,
) {
    let mut seen: [P; BURST_STEPS + 1] = from_fn(|_| points.clone());
    for (lane, observer) in observers.iter_mut().enumerate() {
        observer.observe(0, points.of(lane).as_ref());
    }
    for before in (0..steps).step_by(BURST_STEPS) {
        let len = (steps - before).min(BURST_STEPS as u64) as usize;
        seen[0].clone_from(points);
        for seen in &mut seen[1..=len] {
            advance(points);
            seen.clone_from(points);
        }
        let mut each = observers.iter_mut();
        let burst = Burst { before, seen: &seen[..=len], level };
        O::observe_burst(&mut from_fn(|_| each.next()), &burst);
        if tell(len as u64).is_break() {
            return;
        }
    }
}
