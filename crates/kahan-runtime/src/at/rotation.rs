//! Rotation numbers of the variables of an orbit, in two passes.
//!
//! In: a map. Out: two observers. The first pass finds the extremes of each xᵢ and ẋᵢ. The second
//! pass finds the rotation of (xᵢ, ẋᵢ) about the midpoint of the extremes.

use kahan_core::observe::{Extrema, Extremes, Observer, Rotation, RotationNumber};

use super::{MachineFloat, MapAt};

struct StatesAndRates<'a, T: MachineFloat, O> {
    at: &'a MapAt<T>,
    both: Vec<T>,
    observers: O,
}

impl<T: MachineFloat, O: Observer<T>> Observer<T> for StatesAndRates<'_, T, O> {
    type Report = O::Report;

    const MAY_END: bool = O::MAY_END;

    fn observe(&mut self, step: u64, x: &[T]) {
        let (place, rate) = self.both.split_at_mut(x.len());
        place.copy_from_slice(x);
        self.at.field(x, rate).expect("there is a rate a variable");
        self.observers.observe(step, &self.both);
    }

    fn is_done(&self) -> bool {
        self.observers.is_done()
    }

    fn report(self) -> O::Report {
        self.observers.report()
    }
}

impl<T: MachineFloat + PartialOrd> MapAt<T> {
    /// Returns an observer of the extremes of each variable and of its rate of change.
    /// [`rotations`](Self::rotations) takes the report as input. Extremes are `None` if all values
    /// were NaN.
    pub fn extremes(&self) -> impl Observer<T, Report = [Vec<Option<Extremes<T>>>; 2]> + use<'_, T> {
        let n = self.dimension();
        let of = |first: usize| (first..first + n).map(|k| Extrema::of(move |both: &[T]| both[k])).collect();
        self.with_rates([0, n].map(of) as [Vec<_>; 2])
    }

    /// Returns an observer of the rotation of each variable over `steps` steps, in turns per step.
    ///
    /// A variable rotates in the plane of its value and its rate of change. The center is the
    /// middle of the [`extremes`](Self::extremes). Without extremes or steps, the result is NaN.
    ///
    /// # Panics
    /// If there are more extremes than variables.
    ///
    /// ```
    /// use std::ops::ControlFlow;
    ///
    /// use kahan_runtime::{Field, Follow};
    ///
    /// let map = Field::parse("xdot = -y; ydot = x;").unwrap().map().unwrap().at(0.05_f64);
    /// let start = [1.0, 0.0];
    /// let go_on = |_| ControlFlow::Continue(());
    /// let first = map.observe(&mut start.clone(), 1000, map.extremes(), go_on).unwrap();
    /// let rotations = map.rotations(first.end.steps(1000), &first.report);
    /// let turns = map.observe(&mut start.clone(), 1000, rotations, go_on).unwrap().report;
    /// // Clockwise in the plane of x and its rate.
    /// assert!((turns[0].value + 0.05_f64.atan() / std::f64::consts::PI).abs() < 1e-9);
    /// ```
    pub fn rotations(
        &self,
        steps: u64,
        [variables, rates]: &[Vec<Option<Extremes<T>>>; 2],
    ) -> impl Observer<T, Report = Vec<RotationNumber>> + use<'_, T> {
        let (n, nan) = (self.dimension(), T::zero() / T::zero());
        let both = variables.iter().zip(rates).enumerate();
        let rotations = both.map(|(k, (variable, rate))| {
            let known = |of: &Option<Extremes<T>>| of.unwrap_or(Extremes { least: nan, greatest: nan });
            let plane = move |both: &[T]| [both[k], both[n + k]];
            Rotation::between(steps, plane, [known(variable), known(rate)])
        });
        self.with_rates(rotations.collect::<Vec<_>>())
    }

    fn with_rates<O: Observer<T>>(&self, observers: O) -> StatesAndRates<'_, T, O> {
        StatesAndRates { at: self, both: vec![T::zero(); 2 * self.dimension()], observers }
    }
}
