//! The smaller alignment index.

use crate::Scalar;

use super::TangentMap;
use super::carried::{Carried, Follower, Indicator};
use super::growth::{Size, square};

/// The smaller alignment index of two tangent vectors of length 1: the smaller of |v + w| and
/// |v − w|, after the last step.
///
/// Where motion is chaotic both turn towards the direction that grows most, and the index falls
/// exponentially, down to what the scalar rounds to or to 0. Where it is regular, in four or more
/// variables, it stays of moderate size; in two, and where vectors can only align with a flow, it
/// falls like a power of time. C. Skokos, J. Phys. A 34 (2001) 10029.
///
/// Cost: two tangent vectors, which share what depends on the points alone.
///
/// It reports a number from 0 to √2, and not a number from a pole on.
///
/// An [`Observer`](super::Observer) of points, made by `Sali::new(&map)`; `map` is a
/// [`TangentMap`].
pub type Sali<M> = Follower<Alignment, M, 2>;

/// Alignment is looked at in the end.
#[derive(Clone, Debug)]
pub struct Alignment;

impl Indicator<2> for Alignment {
    type Report = f64;

    const LOOKS_AT_EACH: bool = false;

    fn new(_first: [Size; 2]) -> Self {
        Self
    }

    #[inline(always)]
    fn look(&mut self, _step: u64, _sizes: [Size; 2]) {}

    fn report<M: TangentMap>(self, mut carried: Carried<M, 2>) -> f64 {
        let _ = carried.scale();
        let vectors = carried.vectors();
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
