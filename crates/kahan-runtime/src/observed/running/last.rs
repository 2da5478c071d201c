//! The last point of an orbit.

use kahan_core::observe::{Burst, Grouped, Observer, Observers, SparseObserver};

use super::super::observable::{ColumnScope, ObservableInfo, ObservedValue};
use crate::observed::ObservationRequest;
use crate::{MachineFloat, MapAt};

pub(super) const ABOUT: ObservableInfo =
    ObservableInfo::new("final", ColumnScope::Variables, &[("final_{}", "value after the last step")]);

pub(super) struct Last<T>(Vec<T>);

pub(super) type Own<'a, T> = Last<T>;

pub(super) fn observer<T: MachineFloat>(_: &MapAt<T>, _: &ObservationRequest<'_>) -> Last<T> {
    Last(Vec::new())
}

pub(super) fn seen<T: MachineFloat>(own: Last<T>) -> ObservedValue {
    ObservedValue::Point(own.report().iter().map(T::approximate).collect())
}

impl<T: MachineFloat> Observer<T> for Last<T> {
    type Report = Vec<T>;

    const MAY_END: bool = false;

    #[inline]
    fn observe(&mut self, _: u64, x: &[T]) {
        self.0.clear();
        self.0.extend_from_slice(x);
    }

    #[inline]
    fn observe_burst<P: Grouped<T>>(group: &mut Observers<'_, Self>, burst: &Burst<'_, P>) {
        let Some((step, points)) = burst.steps().last() else { return };
        for (lane, last) in group.iter_mut().flatten().enumerate() {
            last.observe(step, points.of(lane).as_ref());
        }
    }

    fn resumed(&mut self) -> Option<&mut dyn SparseObserver<T>> {
        Some(self)
    }

    #[inline]
    fn report(self) -> Vec<T> {
        self.0
    }
}

impl<T: MachineFloat> SparseObserver<T> for Last<T> {
    fn vectors(&mut self) -> usize {
        0
    }

    fn vector(&mut self, k: usize) -> &[T] {
        unreachable!("a point has no vector {k}")
    }

    fn resume(&mut self, step: u64, x: &[T], _: &dyn Fn(usize, usize) -> T) {
        self.observe(step, x);
    }
}
