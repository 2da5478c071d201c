//! The smaller alignment index.

use crate::Scalar;

use super::TangentMap;
use super::carried::{Carried, Indicator, IndicatorObserver};
use super::growth::{Size, square};

/// An observer of the smaller alignment index of two unit tangent vectors v and w. The index is the
/// smaller of |v+w| and |v−w| after the last step.
///
/// For chaotic motion both vectors align with the direction of fastest growth, and the index falls
/// exponentially to the rounding level or 0. For regular motion in four or more variables the index
/// does not fall. In two variables the index falls like a power of time. C. Skokos, J. Phys. A 34
/// (2001) 10029.
///
/// The report lies between 0 and √2, or is NaN after a pole. `Sali::new(&map)` takes a
/// [`TangentMap`]. A step costs two tangent vectors.
pub type Sali<M> = IndicatorObserver<Alignment, M, 2>;

/// The indicator that [`Sali`] computes at the end of the run.
#[derive(Clone, Debug)]
pub struct Alignment;

impl Indicator<2> for Alignment {
    type Report = f64;

    const LOOKS_AT_EACH: bool = false;

    fn new(_first: [Size; 2]) -> Self {
        Self
    }

    #[inline(always)]
    fn read_lengths(&mut self, _step: u64, _sizes: [Size; 2]) {}

    fn report<M: TangentMap>(self, mut carried: Carried<M, 2>) -> f64 {
        let _ = carried.scale();
        let vectors = carried.vectors();
        let lengths = vectors.map(|vector| libm::sqrt(square(vector)));
        let pairs = vectors[0].iter().zip(vectors[1]);
        let (sum, difference) = pairs.fold((0.0, 0.0), |(sum, difference), (v, w)| {
            let (v, w) = (v.approximate() / lengths[0], w.approximate() / lengths[1]);
            (sum + (v + w) * (v + w), difference + (v - w) * (v - w))
        });
        // If `sum` is NaN, `difference` is NaN, too, and is the result.
        libm::sqrt(if sum < difference { sum } else { difference })
    }
}
