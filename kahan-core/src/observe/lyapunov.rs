//! The largest Lyapunov exponent.

#[cfg(feature = "std")]
use crate::EnsembleScalar;
use crate::FloatScalar;

use super::carried::{Carried, Follower};
use super::growth::Size;
#[cfg(feature = "std")]
use super::{Burst, Grouped, Observers, carried::follow_burst};
use super::{Observer, Tangent};

/// The rate at which a tangent vector grows: the largest Lyapunov exponent, per unit of time.
///
/// A vector in no special direction is carried along by the exact Jacobian. After n steps its
/// length has grown by exp(λ·2εn) and a factor that stays bounded, or grows slowly: on a torus
/// linearly, so that λ tends to 0 as log(n)/n.
///
/// Cost: a step over dual numbers, and the vector's square.
#[derive(Clone, Debug)]
pub struct Lyapunov<M: Tangent<T>, T> {
    carried: Carried<M, T, 1>,
    first: Size,
    last: Size,
    steps: u64,
    doublings: Doublings,
}

/// A Lyapunov exponent per unit of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponent {
    /// The mean rate of growth; not a number where there was no step.
    pub value: f64,
    /// How far it has converged: its distance from the mean rate up to a point between an eighth
    /// and a quarter of the way. An estimate, not a bound, and not a number before the fourth step.
    pub error: f64,
}

impl<M: Tangent<T>, T: FloatScalar> Lyapunov<M, T> {
    /// The exponent of the map that `tangent` belongs to.
    pub fn new(tangent: M) -> Self {
        let carried = Carried::new(tangent);
        Self { carried, first: Size::ONE, last: Size::ONE, steps: 0, doublings: Doublings::default() }
    }

    /// The logarithm of the growth since step 0.
    fn ln(&self) -> f64 {
        0.5 * (self.last.ln() - self.first.ln())
    }
}

impl<M: Tangent<T>, T: FloatScalar> Follower<T, 1> for Lyapunov<M, T> {
    type Map = M;

    #[cfg(feature = "std")]
    #[inline(always)]
    fn carried(&mut self) -> &mut Carried<M, T, 1> {
        &mut self.carried
    }

    #[inline(always)]
    fn look(&mut self, step: u64, [size]: [Size; 1]) {
        (self.steps, self.last) = (step, size);
        if step == 0 {
            self.first = size;
        } else if step.is_power_of_two() {
            self.doublings.pass(step, self.ln());
        }
    }
}

impl<M: Tangent<T>, T: FloatScalar> Observer<T> for Lyapunov<M, T> {
    type Report = Exponent;

    #[inline(always)]
    fn observe(&mut self, step: u64, x: &[T]) {
        let sizes = self.carried.follow(step, x);
        self.look(step, sizes);
    }

    #[cfg(feature = "std")]
    fn observe_burst<P: Grouped<T>>(group: &mut Observers<'_, Self>, burst: &Burst<'_, P>)
    where
        T: EnsembleScalar,
    {
        follow_burst(group, burst);
    }

    fn report(self) -> Exponent {
        self.doublings.exponent(self.steps, self.ln(), self.carried.time_step())
    }
}

/// A logarithm of growth at the last three powers of two, counted in steps.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Doublings([(u64, f64); 3]);

impl Doublings {
    /// To be called at every power of two.
    pub(super) fn pass(&mut self, step: u64, ln: f64) {
        let [_, before, last] = self.0;
        self.0 = [before, last, (step, ln)];
    }

    /// The exponent of a growth of exp(`ln`) in so many steps of `time` each.
    pub(super) fn exponent(&self, steps: u64, ln: f64, time: f64) -> Exponent {
        let rate = |(steps, ln): (u64, f64)| ln / (steps as f64 * time);
        let value = rate((steps, ln));
        Exponent { value, error: (value - rate(self.0[0])).abs() }
    }
}
