//! The smaller alignment index.

#[cfg(feature = "std")]
use crate::EnsembleScalar;
use crate::FloatScalar;

use super::carried::{Carried, Follower};
use super::growth::{Size, square};
#[cfg(feature = "std")]
use super::{Burst, Grouped, Observers, carried::follow_burst};
use super::{Observer, Tangent};

/// The smaller alignment index of two tangent vectors of length 1: the smaller of |v + w| and
/// |v − w|, after the last step.
///
/// Where motion is chaotic both turn towards the direction that grows most, and the index falls
/// exponentially, down to what the scalar rounds to or to 0. Where it is regular, in four or more
/// variables, it stays of moderate size; in two, and where vectors can only align with a flow, it
/// falls like a power of time. C. Skokos, J. Phys. A 34 (2001) 10029.
///
/// Cost: two tangent vectors, which share what depends on the points alone.
#[derive(Clone, Debug)]
pub struct Sali<M: Tangent<T>, T> {
    carried: Carried<M, T, 2>,
}

impl<M: Tangent<T>, T: FloatScalar> Sali<M, T> {
    /// The index of the map that `tangent` belongs to.
    pub fn new(tangent: M) -> Self {
        Self { carried: Carried::new(tangent) }
    }
}

impl<M: Tangent<T>, T: FloatScalar> Follower<T, 2> for Sali<M, T> {
    type Map = M;

    const LOOKS_AT_EACH: bool = false;

    #[inline(always)]
    fn carried(&mut self) -> &mut Carried<M, T, 2> {
        &mut self.carried
    }

    /// Alignment is looked at in the end.
    #[inline(always)]
    fn look(&mut self, _step: u64, _sizes: [Size; 2]) {}
}

impl<M: Tangent<T>, T: FloatScalar> Observer<T> for Sali<M, T> {
    /// From 0 to √2; not a number from a pole on.
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

    fn report(mut self) -> f64 {
        let _ = self.carried.scale();
        let vectors = self.carried.vectors();
        let lengths = vectors.map(|vector| libm::sqrt(square(vector)));
        let pairs = vectors[0].iter().zip(vectors[1]);
        let (sum, difference) = pairs.fold((0.0, 0.0), |(sum, difference), (v, w)| {
            let (v, w) = (v.approximate() / lengths[0], w.approximate() / lengths[1]);
            (sum + (v + w) * (v + w), difference + (v - w) * (v - w))
        });
        // What is not a number stays.
        libm::sqrt(if sum < difference { sum } else { difference })
    }
}
