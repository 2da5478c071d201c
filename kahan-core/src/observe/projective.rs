//! Observation of an orbit that continues through poles.

use crate::{ExtendScalars, Projective, ThroughPoles};

use super::Observer;

impl<M, T, const N: usize> Projective<M, T, N>
where
    M: ExtendScalars<T, N>,
    T: ThroughPoles,
{
    /// Observes this orbit as [`Orbit::observe`](crate::Orbit::observe) does, but skips points at
    /// infinity.
    ///
    /// Sections count a sign change across infinity as a jump. Observers that compare consecutive
    /// points (rotation, exponents) treat the points before and after infinity as neighbours. For
    /// such observers, use an orbit that ends at infinity.
    ///
    /// ```
    /// use kahan_core::observe::Extrema;
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// Solutions from x > 0 reach +∞ in finite time. Orbits of the map then return from −∞.
    ///     pub struct Riccati;
    ///     xdot = x^2;
    /// }
    ///
    /// let mut orbit = Riccati.orbit(vector![1.0], 0.25).projective();
    /// let extremes = orbit.observe(4, Extrema::of(|x: &[f64]| x[0])).unwrap();
    /// assert_eq!((extremes.least, extremes.greatest), (-2.0, 2.0));
    /// ```
    pub fn observe<O: Observer<T>>(&mut self, steps: u64, mut observers: O) -> O::Report {
        for (step, point) in (0..=steps).zip(self) {
            if let Some(x) = point.affine() {
                observers.observe(step, x.as_slice());
            }
            if observers.is_done() {
                break;
            }
        }
        observers.report()
    }
}
