//! The mean exponential growth factor of nearby orbits.

#[cfg(feature = "std")]
use crate::EnsembleScalar;
use crate::FloatScalar;

use super::carried::{Carried, Follower};
use super::growth::Size;
#[cfg(feature = "std")]
use super::{Burst, Grouped, Observers, carried::follow_burst};
use super::{Observer, Tangent};

/// MEGNO, the mean exponential growth factor of nearby orbits, of a map:
/// Y(n) = (2/n)·Σ k·log(|vₖ|/|vₖ₋₁|), k = 1, …, n, and the mean of Y(1), …, Y(n).
///
/// The mean tends to 2 where motion is quasi-periodic, to 0 where tangent vectors stay bounded, and
/// grows like λ·εn where it is chaotic, λ the largest exponent per unit of time. P. M. Cincotta, C.
/// M. Giordano, C. Simó, Physica D 182 (2003) 151.
///
/// Cost: a tangent vector, about that of a step, and a logarithm.
#[derive(Clone, Debug)]
pub struct Megno<M: Tangent<T>, T> {
    carried: Carried<M, T, 1>,
    /// log |v₀|
    first: f64,
    /// The sum of log |vₖ|/|v₀| over the steps before the last.
    before: f64,
    last: f64,
    /// The sum of Y.
    sum: f64,
    steps: u64,
}

/// What [`Megno`] reports: not numbers where there was no step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Megnos {
    /// The mean of Y over all steps.
    pub mean: f64,
    /// Y at the last step.
    pub last: f64,
}

impl<M: Tangent<T>, T: FloatScalar> Megno<M, T> {
    /// The factor of the map that `tangent` belongs to.
    pub fn new(tangent: M) -> Self {
        let carried = Carried::new(tangent);
        Self { carried, first: 0.0, before: 0.0, last: 0.0, sum: 0.0, steps: 0 }
    }

    /// Y(n) = 2·(log |vₙ| − (log |v₀| + … + log |vₙ₋₁|)/n), where |v₀| = 1: the sum of its
    /// definition, by parts.
    fn value(&self) -> f64 {
        2.0 * (self.last - self.before / self.steps as f64)
    }
}

impl<M: Tangent<T>, T: FloatScalar> Follower<T, 1> for Megno<M, T> {
    type Map = M;

    const LOOKS_AT_EACH: bool = true;

    #[inline(always)]
    fn carried(&mut self) -> &mut Carried<M, T, 1> {
        &mut self.carried
    }

    fn look(&mut self, step: u64, [size]: [Size; 1]) {
        let ln = 0.5 * size.ln();
        if step == 0 {
            self.first = ln;
            return;
        }
        self.steps = step;
        self.before += self.last;
        self.last = ln - self.first;
        self.sum += self.value();
    }
}

impl<M: Tangent<T>, T: FloatScalar> Observer<T> for Megno<M, T> {
    type Report = Megnos;

    #[inline]
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

    fn report(self) -> Megnos {
        Megnos { mean: self.sum / self.steps as f64, last: self.value() }
    }
}
