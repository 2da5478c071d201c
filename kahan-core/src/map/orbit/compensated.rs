//! The mode of orbits that floats have and exact numbers have no use for.

use crate::{FloatScalar, KahanMap};

use super::{Compensated, Method, Orbit, Rounded, State};

impl<M, T, K, const N: usize> Orbit<M, T, N, K, Rounded>
where
    M: KahanMap<T, N>,
    T: FloatScalar,
    K: Method,
{
    /// The same orbit with the rounding error of each addition x + (x̃ − x) carried into the next
    /// one (Kahan's compensated summation, of the state). It goes on from where this orbit is.
    ///
    /// What it cures: a plain step rounds each component to half an ulp; here the error of a step
    /// falls to that of its increment, O(ε)·u, so that the integrals of the map wander less.
    ///
    /// What it does not: the increments are still rounded, always in the same way. Errors that have
    /// a mean add up linearly: in `f32` they are seen beyond about 10⁶ steps, and for an ε whose
    /// powers are rounded badly in `f64` too; there [`nearest_short_eps`](crate::nearest_short_eps)
    /// helps. A linear field, whose increments are one constant matrix times the state, has such a
    /// mean at any ε: there it gains little. Nor does it help near a pole, where the increment is
    /// inaccurate.
    ///
    /// Each point that it yields is rounded, to about an ulp of where the orbit is.
    ///
    /// Cost: seven operations a component, none of which the next step waits for; `BENCHMARKS.md`
    /// has the times.
    ///
    /// ```
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// A circle around the origin, run through ever faster or slower.
    ///     pub struct Turn;
    ///     xdot = y*(2 + x);
    ///     ydot = -x*(2 + x);
    /// }
    ///
    /// let start = vector![1.0_f32, 0.0];
    /// let exact = Turn.orbit(vector![1.0, 0.0], 0.001_f32.into()).nth(100_000).unwrap();
    /// let error = |x: Option<SVector<f32, 2>>| (x.unwrap().map(f64::from) - exact).norm();
    /// let plain = error(Turn.orbit(start, 0.001).nth(100_000));
    /// let compensated = error(Turn.orbit(start, 0.001).compensated().nth(100_000));
    /// assert!(compensated < 0.2 * plain);
    /// ```
    #[inline]
    pub fn compensated(self) -> Orbit<M, T, N, K, Compensated> {
        let Self { map, eps, stages, state, begun, stopped } = self;
        Orbit { map, eps, stages, state: State::begin(state), begun, stopped }
    }
}
