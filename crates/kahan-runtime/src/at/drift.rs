//! The drift of a field's claimed integrals from their initial values along an orbit.

use kahan_core::observe::{Burst, Drift, Drifted, GROUP, Grouped, Observer, Observers};

use super::group::{AlignedGroups, MOST};
use super::{MachineFloat, MapAt};
use crate::engine::{GroupCode, Scratch, with_scratch};

const MOST_INTEGRALS: usize = 8;

/// An observer that reports the drift of each integral of a field.
#[derive(Clone, Debug)]
pub struct IntegralDrift<'a, T: MachineFloat> {
    at: &'a MapAt<T>,
    values: Vec<T>,
    drifts: Vec<Drift<Itself<T>, T, 1>>,
}

type Itself<T> = fn(&[T]) -> [T; 1];

impl<'a, T: MachineFloat> IntegralDrift<'a, T> {
    /// Observes the integrals of this map.
    #[must_use]
    pub fn of(at: &'a MapAt<T>) -> Self {
        let count = at.map().field().integrals().len();
        let itself: Itself<T> = |value| [value[0]];
        let drifts = (0..count).map(|_| Drift::of(itself)).collect();
        IntegralDrift { at, values: vec![T::zero(); count], drifts }
    }

    fn look(&mut self, step: u64) {
        for (drift, value) in self.drifts.iter_mut().zip(&self.values) {
            drift.observe(step, core::slice::from_ref(value));
        }
    }
}

impl<T: MachineFloat> Observer<T> for IntegralDrift<'_, T> {
    type Report = Vec<Drifted>;

    const MAY_END: bool = false;

    fn observe(&mut self, step: u64, x: &[T]) {
        // Both slices have the lengths that the map requires, so the call succeeds.
        let _ = self.at.integrals(x, &mut self.values);
        self.look(step);
    }

    fn observe_burst<P: Grouped<T>>(group: &mut Observers<'_, Self>, burst: &Burst<'_, P>) {
        if !has_looked_side_by_side(group, burst) {
            for (lane, drift) in group.iter_mut().flatten().enumerate() {
                burst.show(lane, 0, |step, x| drift.observe(step, x));
            }
        }
    }

    fn report(self) -> Vec<Drifted> {
        self.drifts.into_iter().map(|drift| drift.report()[0]).collect()
    }
}

fn has_looked_side_by_side<T: MachineFloat, P: Grouped<T>>(
    group: &mut Observers<'_, IntegralDrift<'_, T>>,
    burst: &Burst<'_, P>,
) -> bool {
    let [Some(first), ..] = group else { return true };
    let (first, count) = (first.at, first.values.len());
    let mut maps = [first; GROUP];
    for (map, drift) in maps.iter_mut().zip(group.iter().flatten()) {
        *map = drift.at;
    }
    let variables = first.dimension();
    let mut columns = AlignedGroups::<T, { MOST + MOST_INTEGRALS }>::zeros();
    let Some(columns) = columns.0.get_mut(..variables + count) else { return false };
    with_scratch(T::single(), |Scratch { given, .. }| {
        let Some(abreast) = MapAt::group_code_of_integrals(maps, core::mem::take(given)) else {
            return false;
        };
        for (step, points) in burst.steps() {
            columns.iter_mut().zip(points.as_ref()).for_each(|(column, point)| *column = *point);
            abreast.step(columns);
            for (lane, drift) in group.iter_mut().flatten().enumerate() {
                drift
                    .values
                    .iter_mut()
                    .zip(&columns[variables..])
                    .for_each(|(value, column)| *value = column[lane]);
                drift.look(step);
            }
        }
        *given = abreast.into_memory();
        true
    })
}

impl<T: MachineFloat> MapAt<T> {
    /// Returns code that stores each orbit's integrals after the coordinates of its point.
    fn group_code_of_integrals(maps: [&Self; GROUP], workspace: Vec<T>) -> Option<GroupCode<T>> {
        let [first, ..] = maps;
        let are_like_first = maps.iter().all(|map| map.is_like(first));
        let constants = maps.map(|map| &*map.of_integrals);
        first.engine().group_code_of_integrals(constants, first.set, workspace).filter(|_| are_like_first)
    }
}
