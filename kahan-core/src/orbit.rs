//! Orbits as iterators.
//!
//! In: a map, its first point, ε. Out: x₀, x₁, …, each computed when asked for and not before (exact points grow,
//! so one more than wanted can cost more than all before it).
//! Nothing panics at a pole: an orbit over exact scalars ends there and says why, one over floats goes on with
//! numbers that are not finite. No allocation, no `dyn`, nothing borrowed.

use core::fmt;
use core::iter::FusedIterator;

use nalgebra::SVector;

use crate::{KahanMap, PreparedStep, Scalar, SingularStep};

/// The orbit x₀, x₁, … of a Kahan map, x₀ first; made by [`KahanMap::orbit`].
///
/// It holds the prepared step, so what depends on ε and the parameters alone is computed once; each point is bit for
/// bit the [`step`](KahanMap::step) of the one before.
#[derive(Clone)]
#[must_use = "an orbit computes nothing until it is iterated"]
pub struct Orbit<M, T, const N: usize>
where
    M: KahanMap<T, N>,
    T: Scalar,
{
    prepared: M::Prepared,
    eps: T,
    /// The point given last, or x₀ before any was.
    point: SVector<T, N>,
    begun: bool,
    stopped: Option<SingularStep>,
}

impl<M, T, const N: usize> Orbit<M, T, N>
where
    M: KahanMap<T, N>,
    T: Scalar,
{
    #[inline]
    pub(crate) fn new(prepared: M::Prepared, start: SVector<T, N>, eps: T) -> Self {
        Self { prepared, eps, point: start, begun: false, stopped: None }
    }

    /// Why the orbit has ended: `Some` from the moment on when a step met a pole of an exact scalar.
    pub fn stopped(&self) -> Option<&SingularStep> {
        self.stopped.as_ref()
    }
}

impl<M, T, const N: usize> Iterator for Orbit<M, T, N>
where
    M: KahanMap<T, N>,
    T: Scalar,
{
    type Item = SVector<T, N>;

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        if self.stopped.is_some() {
            return None;
        }
        if self.begun {
            match self.prepared.next(&self.point) {
                Some(next) => self.point = next,
                None => {
                    self.stopped = Some(SingularStep::pole(self.eps.approximate()));
                    return None;
                }
            }
        }
        self.begun = true;
        Some(self.point.clone())
    }
}

impl<M, T, const N: usize> FusedIterator for Orbit<M, T, N>
where
    M: KahanMap<T, N>,
    T: Scalar,
{
}

impl<M, T, const N: usize> fmt::Debug for Orbit<M, T, N>
where
    M: KahanMap<T, N>,
    T: Scalar,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { eps, point, stopped, .. } = self;
        f.debug_struct("Orbit")
            .field("eps", eps)
            .field("point", point)
            .field("stopped", stopped)
            .finish_non_exhaustive()
    }
}
