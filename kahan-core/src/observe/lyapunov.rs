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
/// Cost: a tangent vector, about that of a step; see `BENCHMARKS.md`.
#[derive(Clone, Debug)]
pub struct Lyapunov<M: Tangent<T>, T> {
    carried: Carried<M, T, 1>,
    first: Size,
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
        let mut carried = Carried::new(tangent);
        let [first] = carried.scale();
        Self { carried, first, doublings: Doublings::default() }
    }
}

impl<M: Tangent<T>, T: FloatScalar> Follower<T, 1> for Lyapunov<M, T> {
    type Map = M;

    const LOOKS_AT_EACH: bool = false;

    #[inline(always)]
    fn carried(&mut self) -> &mut Carried<M, T, 1> {
        &mut self.carried
    }

    #[inline(always)]
    fn look(&mut self, step: u64, [size]: [Size; 1]) {
        if step.is_power_of_two() {
            self.doublings.pass(step, size);
        }
    }
}

impl<M: Tangent<T>, T: FloatScalar> Observer<T> for Lyapunov<M, T> {
    type Report = Exponent;

    #[inline(always)]
    fn observe(&mut self, step: u64, x: &[T]) {
        self.follow(step, x);
    }
    #[cfg(feature = "std")]
    fn observe_burst<P: Grouped<T>>(group: &mut Observers<'_, Self>, burst: &Burst<'_, P>)
    where
        T: EnsembleScalar,
    {
        follow_burst(group, burst);
    }

    fn report(mut self) -> Exponent {
        let [size] = self.carried.scale();
        self.doublings.exponent(self.first, (self.carried.steps(), size), self.carried.time_step())
    }
}

/// Squares of a length at the last three powers of two, counted in steps.
///
/// Their logarithms are taken in the end, so that a loop over steps calls nothing.
#[derive(Clone, Copy, Debug)]
pub(super) struct Doublings([(u64, Size); 3]);

impl Default for Doublings {
    /// None yet: no number has been seen.
    fn default() -> Self {
        Self([(0, Size::of(f64::NAN)); 3])
    }
}

impl Doublings {
    /// To be called at every power of two.
    #[inline(always)]
    pub(super) fn pass(&mut self, step: u64, square: Size) {
        let [_, before, last] = self.0;
        self.0 = [before, last, (step, square)];
    }

    /// The exponent of a length that has grown between these squares, in so many steps of `time`
    /// each.
    pub(super) fn exponent(&self, first: Size, last: (u64, Size), time: f64) -> Exponent {
        let rate = |(steps, square): (u64, Size)| 0.5 * (square.ln() - first.ln()) / (steps as f64 * time);
        let value = rate(last);
        Exponent { value, error: (value - rate(self.0[0])).abs() }
    }
}
