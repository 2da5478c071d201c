//! The largest Lyapunov exponent.

use super::TangentMap;
use super::carried::{Carried, Follower, Indicator};
use super::growth::Size;

/// The rate at which a tangent vector grows: the largest Lyapunov exponent, per unit of time.
///
/// A vector in no special direction is carried along by the exact Jacobian. After n steps its
/// length has grown by exp(λ·2εn) and a factor that stays bounded, or grows slowly: on a torus
/// linearly, so that λ tends to 0 as log(n)/n.
///
/// Cost: a tangent vector, about that of a step; see `benches/results`.
///
/// An [`Observer`](super::Observer) of points, made by `Lyapunov::new(&map)`; `map` is a
/// [`TangentMap`].
pub type Lyapunov<M> = Follower<Growth, M, 1>;

/// The square of a vector's first length, and those at powers of two.
#[derive(Clone, Debug)]
pub struct Growth {
    first: Size,
    doublings: Doublings,
}

/// A Lyapunov exponent per unit of time.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Exponent {
    /// The mean rate of growth; not a number where there was no step.
    pub value: f64,
    /// How far it has converged: its distance from the mean rate up to a point between an eighth
    /// and a quarter of the way. An estimate, not a bound, and not a number before the fourth step.
    pub error: f64,
}

impl Indicator<1> for Growth {
    type Report = Exponent;

    const LOOKS_AT_EACH: bool = false;

    fn new([first]: [Size; 1]) -> Self {
        Self { first, doublings: Doublings::default() }
    }

    #[inline(always)]
    fn look(&mut self, step: u64, [size]: [Size; 1]) {
        if step.is_power_of_two() {
            self.doublings.pass(step, size);
        }
    }

    fn report<M: TangentMap>(self, mut carried: Carried<M, 1>) -> Exponent {
        let [size] = carried.scale();
        self.doublings.exponent(self.first, (carried.steps(), size), carried.time_step())
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
