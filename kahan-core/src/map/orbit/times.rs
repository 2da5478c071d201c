//! The states of an orbit at given times.
//!
//! Between two points, a step with a fraction of ε leads from the earlier point to the given time.

use core::iter::from_fn;

use num_traits::Zero;

use crate::{Constant, FloatScalar, PointOf, Scalar, StateVector, Step};

use super::Orbit;

impl<S: Step<Scalar: FloatScalar>> Orbit<S> {
    /// Yields the states at these times. The next point has the time 0, and a step takes the time
    /// 2ε.
    ///
    /// Between two points, the map with a fraction of ε computes the state from the earlier point.
    /// The state is not on the orbit, and its distance from the flow is O(ε³). Times should
    /// increase, or decrease for negative ε. For an earlier time, the map steps back from the last
    /// point. Each time costs one step and its preparation, in addition to the steps of the orbit.
    ///
    /// ```
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// A circle around the origin.
    ///     pub struct Turn;
    ///     xdot = y;
    ///     ydot = -x;
    /// }
    ///
    /// let times = [0.0_f64, 0.1, 1.0, 2.5];
    /// for (x, t) in Turn.orbit(vector![0.0, 1.0], 0.005).at_times(&times).zip(times) {
    ///     assert!((x[0] - t.sin()).abs() < 1e-4);
    /// }
    /// ```
    pub fn at_times(mut self, times: &[S::Scalar]) -> impl Iterator<Item = PointOf<S>> {
        let dt = *self.map.eps() + *self.map.eps();
        let mut place = self.next();
        let mut made = 0;
        times.iter().map_while(move |&time| {
            // A cast of NaN to `u64` gives 0.
            let steps = ((time / dt).approximate() as u64).max(made);
            if steps > made {
                place = usize::try_from(steps - made - 1).ok().and_then(|skipped| self.nth(skipped));
                made = steps;
            }
            place.as_ref()?;
            Some(self.part(time / dt - count(made)))
        })
    }

    /// Yields the points of this orbit before the time `end`, with their times 0, 2ε, 4ε, …. The
    /// next point has the time 0. The last item is the state at `end`, computed by [a
    /// part](Self::at_times) of a step.
    ///
    /// ```
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// A circle around the origin.
    ///     pub struct Turn;
    ///     xdot = y;
    ///     ydot = -x;
    /// }
    ///
    /// let (time, x) = Turn.orbit(vector![0.0, 1.0], 0.005).until(1.0).last().unwrap();
    /// assert!(time == 1.0 && (x[0] - 1.0_f64.sin()).abs() < 1e-4);
    /// ```
    pub fn until(mut self, end: S::Scalar) -> impl Iterator<Item = (S::Scalar, PointOf<S>)> {
        let dt = *self.map.eps() + *self.map.eps();
        let parts = end / dt;
        let whole = parts.approximate() as u64;
        let last = whole + u64::from((whole as f64) < parts.approximate());
        let (mut made, mut is_at_end) = (0, false);
        from_fn(move || {
            if made < last {
                let (time, x) = (dt * count(made), self.next()?);
                made += 1;
                return Some((time, x));
            }
            // If no point has been yielded yet, `next` yields x₀, from which `self.part` starts.
            if is_at_end || (last == 0 && self.next().is_none()) {
                return None;
            }
            is_at_end = true;
            Some((end, self.part(parts - count(last.saturating_sub(1)))))
        })
    }

    /// Returns the state after a fraction of a step from the last yielded point.
    fn part(&mut self, part: S::Scalar) -> PointOf<S> {
        let mut state = self.state.clone();
        if !part.is_zero() {
            let _ = self.map.part(&(part * *self.map.eps()), state.as_mut_slice(), &mut self.workspace);
        }
        state.to_point()
    }
}

fn count<T: Scalar>(steps: u64) -> T {
    T::constant(&Constant::integer(steps.cast_signed()))
}
