//! Observing one orbit.

use crate::{FloatScalar, Orbit, PointOf, Scaled, StateVector, Step};

use super::section::First;
use super::{Crossing, Direction, Observer, Section};

impl<S: Step> Orbit<S> {
    /// Shows the observers the next point of this orbit, x₀, as that of step 0, and the points of
    /// `steps` steps more; then reports.
    ///
    /// The orbit goes on from there: what is asked of it next begins with the point after the last
    /// one that was shown, as step 0. An exact orbit that meets a pole ends, and
    /// [`stopped`](Self::stopped) says so: the reports are of the points before it. Observers that
    /// are [done](Observer::is_done) end the run at that point.
    ///
    /// It allocates nothing where a state is an array, and a copy of the state where it is a `Vec`.
    /// `benches/results` has the times.
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

    /// Shows the points of so many steps, or as many as there are.
    #[inline(always)]
    fn show(&mut self, steps: u64, observers: &mut impl Observer<S::Scalar>) {
        // A state of its own, which the compiler can keep in registers.
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
    /// Where this orbit first crosses `level` = 0 within so many steps of its next point, as
    /// [`first_crossing`](super::first_crossing) tells it; the orbit stands at the point after it.
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
    /// As [`Orbit::observe`], of the points that this orbit yields.
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
