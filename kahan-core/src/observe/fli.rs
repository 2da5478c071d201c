//! The fast Lyapunov indicator.

use core::cmp::Ordering;

#[cfg(feature = "std")]
use crate::EnsembleScalar;
use crate::FloatScalar;

use super::carried::{Carried, Follower};
use super::growth::Size;
#[cfg(feature = "std")]
use super::{Burst, Grouped, Observers, carried::follow_burst};
use super::{Observer, Tangent};

/// The fast Lyapunov indicator: the logarithm of the greatest length that a tangent vector has had,
/// its first length being 1.
///
/// Over n steps it grows like log n on a torus and like n where motion is chaotic. C. Froeschlé, E.
/// Lega, R. Gonczi, Celest. Mech. Dyn. Astron. 67 (1997) 41.
///
/// Cost: a tangent vector, about that of a step, and its square; see `BENCHMARKS.md`.
#[derive(Clone, Debug)]
pub struct Fli<M: Tangent<T>, T> {
    carried: Carried<M, T, 1>,
    first: Size,
    greatest: Size,
}

impl<M: Tangent<T>, T: FloatScalar> Fli<M, T> {
    /// The indicator of the map that `tangent` belongs to.
    pub fn new(tangent: M) -> Self {
        Self { carried: Carried::new(tangent), first: Size::ONE, greatest: Size::ONE }
    }
}

impl<M: Tangent<T>, T: FloatScalar> Follower<T, 1> for Fli<M, T> {
    type Map = M;

    const LOOKS_AT_EACH: bool = true;

    #[inline(always)]
    fn carried(&mut self) -> &mut Carried<M, T, 1> {
        &mut self.carried
    }

    #[inline(always)]
    fn look(&mut self, step: u64, [size]: [Size; 1]) {
        if step == 0 {
            (self.first, self.greatest) = (size, size);
        }
        match size.partial_cmp(&self.greatest) {
            Some(Ordering::Greater) => self.greatest = size,
            // One of them is not a number, and so it stays.
            None => self.greatest = Size::of(f64::NAN),
            _ => {}
        }
    }
}

impl<M: Tangent<T>, T: FloatScalar> Observer<T> for Fli<M, T> {
    /// Not a number from a pole on.
    type Report = f64;

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

    fn report(self) -> f64 {
        0.5 * (self.greatest.ln() - self.first.ln())
    }
}
