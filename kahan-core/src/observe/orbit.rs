//! Observation of one orbit.

use crate::{FloatScalar, Orbit, PointOf, Scaled, StateVector, Step};

use super::section::First;
use super::{Crossing, Direction, Observer, Section};

impl<S: Step> Orbit<S> {
    /// Shows the next point as step 0, then `steps` further points. Returns the observers' report.
    ///
    /// The run ends early if the observers are [done](Observer::is_done), or at a pole of an exact
    /// orbit; [`stopped`](Self::stopped) then returns the pole. The next call starts after the last
    /// point shown.
    ///
    /// ```
    /// use kahan_core::observe::Escape;
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// Growth without limits.
    ///     pub struct Growth;
    ///     xdot = x;
    /// }
    ///
    /// let beyond_two = || Escape::when(|x: &[f64]| x[0] > 2.0);
    /// assert_eq!(Growth.orbit(vector![1.0], 0.05).observe(100, beyond_two()), Some(7));
    ///
    /// // After two points of no interest:
    /// let mut orbit = Growth.orbit(vector![1.0], 0.05);
    /// orbit.observe(1, ());
    /// assert_eq!(orbit.observe(100, beyond_two()), Some(5));
    /// ```
    pub fn observe<O: Observer<S::Scalar>>(&mut self, steps: u64, mut observers: O) -> O::Report {
        if let Some(first) = self.next() {
            observers.observe(0, first.as_slice());
            if !observers.is_done() {
                self.show(steps, &mut observers);
            }
        }
        observers.report()
    }

    #[inline(always)]
    fn show(&mut self, steps: u64, observers: &mut impl Observer<S::Scalar>) {
        // A local copy of the state lets compilers keep it in registers.
        let mut state = self.state.clone();
        for step in 1..=steps {
            if state.step_with(&self.map, &mut self.workspace).is_none() {
                self.stop();
                break;
            }
            observers.observe(step, state.point());
            if observers.is_done() {
                break;
            }
        }
        self.state = state;
    }
}

impl<S: Step<Scalar: FloatScalar> + Clone> Orbit<S> {
    /// Returns the first zero of the function `level` on this orbit, after at most `steps` steps;
    /// see [`first_crossing`](super::first_crossing). The orbit continues from the crossing.
    pub fn first_crossing(
        &mut self,
        steps: u64,
        level: impl Fn(&[S::Scalar]) -> S::Scalar,
    ) -> Option<Crossing<PointOf<S>, S::Scalar>> {
        let section = Section::new(self.map.clone(), level, Direction::Both, First(None));
        self.observe(steps, section).points
    }
}

impl<S: Step<Scalar: FloatScalar>> Scaled<S> {
    /// Observes the points that this orbit yields, as [`Orbit::observe`] does.
    pub fn observe<O: Observer<S::Scalar>>(&mut self, steps: u64, mut observers: O) -> O::Report {
        for (step, point) in (0..=steps).zip(self) {
            observers.observe(step, point.as_slice());
            if observers.is_done() {
                break;
            }
        }
        observers.report()
    }
}
