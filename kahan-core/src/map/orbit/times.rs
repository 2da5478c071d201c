//! Orbits by time.
//!
//! In: an orbit, and times between its points. Out: the state there, by the last whole step before
//! it and the map at a part of ε: on the map's own curve from a point to the next, which is as far
//! from the flow as a step is.

use core::iter::from_fn;

use nalgebra::SVector;
use num_traits::Zero;

use crate::{Constant, FloatScalar, KahanMap, Method, Room, Scalar, Slice, Step};

use super::{Accumulation, Orbit};

impl<M, T, K, A, const N: usize> Orbit<M, T, N, K, A>
where
    M: KahanMap<T, N>,
    T: FloatScalar,
    K: Method,
    A: Accumulation,
{
    /// The states at these times, counted from the next point of this orbit; a step takes 2ε.
    ///
    /// Between two points the state is that of the map with a part of ε from the first of them: no
    /// point of this orbit, and as far from the flow as a step is, O(ε³). The orbit itself goes on
    /// from point to point. Times grow, or fall where ε is negative; one that goes back yields the
    /// state on the curve that leads on from the last point, before it.
    ///
    /// Cost: a step each, besides those of the orbit, and what ε fixes computed anew.
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
    pub fn at_times(self, times: &[T]) -> impl Iterator<Item = SVector<T, N>> {
        let (map, mut orbit) = (self.prepared(), self);
        let dt = map.eps + map.eps;
        let mut place = orbit.next();
        let mut made = 0;
        times.iter().map_while(move |&time| {
            // What is no number counts as no step.
            let steps = ((time / dt).approximate() as u64).max(made);
            if steps > made {
                place = usize::try_from(steps - made - 1).ok().and_then(|skipped| orbit.nth(skipped));
                made = steps;
            }
            Some(part(&map, place?, time / dt - count(made)))
        })
    }

    /// The points of this orbit from the next one on with their times, 0, 2ε, 4ε, … before `end`,
    /// and last the state at `end`, by [a part](Self::at_times) of a step.
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
    pub fn until(self, end: T) -> impl Iterator<Item = (T, SVector<T, N>)> {
        let (map, mut orbit) = (self.prepared(), self);
        let dt = map.eps + map.eps;
        let parts = end / dt;
        let whole = parts.approximate() as u64;
        let last = whole + u64::from((whole as f64) < parts.approximate());
        let (mut made, mut before) = (0, None);
        from_fn(move || {
            if made < last {
                let (time, x) = (dt * count(made), orbit.next()?);
                made += 1;
                before = Some(x);
                return Some((time, x));
            }
            // The end of no step is where the orbit begins.
            if last == 0 && made == 0 {
                made = 1;
                before = orbit.next();
            }
            let x = before.take()?;
            Some((end, part(&map, x, parts - count(last.saturating_sub(1)))))
        })
    }
}

/// The state a part of a step from `x`.
fn part<S: Step>(map: &S, mut x: S::State, part: S::Scalar) -> S::State {
    if !part.is_zero() {
        // Floats go on at poles.
        let _ = map.part(&(part * map.eps().clone()), x.as_mut_slice(), &mut Room::new());
    }
    x
}

fn count<T: Scalar>(steps: u64) -> T {
    T::constant(&Constant::integer(steps.cast_signed()))
}
