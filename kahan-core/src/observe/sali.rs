//! The smaller alignment index.

use crate::Scalar;

use super::TangentMap;
use super::carried::{Carried, Follower, Indicator};
use super::growth::{Size, square};

/// An observer of the smaller alignment index of two unit tangent vectors: the smaller of |v + w|
/// and |v − w| after the last step.
///
/// For chaotic motion both vectors turn to the direction of fastest growth, and the index falls
/// exponentially to rounding errors or 0. For regular motion in four or more variables the index
/// stays of moderate size. In two variables, and where vectors align with the flow, it falls like a
/// power of time. C. Skokos, J. Phys. A 34 (2001) 10029.
///
/// The report is a number from 0 to √2, or NaN after a pole. Cost: two tangent vectors, which share
/// the work on the points.
/// Made by `Sali::new(&map)` for a [`TangentMap`].
pub type Sali<M> = Follower<Alignment, M, 2>;

/// The indicator of [`Sali`], which reads the vectors only at the end.
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
        // NaN compares false, so `difference`, NaN as well, is returned.
        libm::sqrt(if sum < difference { sum } else { difference })
    }
}
