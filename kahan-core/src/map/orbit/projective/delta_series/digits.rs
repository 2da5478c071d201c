//! Wide numbers for float orbits through poles, with a numeric δ far below a float's last digit.

use core::array::from_fn;

use nalgebra::{SMatrix, SVector};
use num_traits::{One, Zero};

use crate::field::linear::vector;
use crate::map::stable::PromiseScalar;
use crate::scalar::{Size, Wide};

use super::super::point::{ProjectivePoint, first_of_the_largest};
use super::{DeltaSeries, direction};

/// The binary exponent of the perturbation δ, relative to the size of the point. The number δ is
/// far below the digits of a [`Dd`](crate::Dd).
const DELTA_EXPONENT: i32 = -192;

/// A coordinate is treated as infinite if its exponent exceeds that of the point by this number,
/// and as 0 if its exponent is lower by this number.
const INFINITY_EXPONENT: i64 = 96;

/// The number of bits to which a limit must be known, more than any float of this crate has.
const KNOWN_BITS: i64 = 110;

/// Returns the limit of a coordinate as δ → 0, by rounding away the small terms that contain δ.
fn without_delta(entry: Wide, size: Size) -> Wide {
    if entry.size() < size.scaled(-INFINITY_EXPONENT) {
        return Wide::zero();
    }
    let leading = Wide::from(entry.to_f64());
    if (entry - leading).size() < entry.size().scaled(-KNOWN_BITS) { leading } else { entry }
}

/// The number of bits that inverse steps may lose if a passage is to count as one-to-one.
const MAX_LOST_BITS: i64 = 10;

impl<T: PromiseScalar> DeltaSeries<T> for Wide {
    /// The first attempt sets δ = 0. The other two set δ > 0, and follow lines in other directions.
    const EFFORTS: usize = 3;

    fn of(number: &T) -> Self {
        number.widen()
    }

    fn delta(effort: usize) -> Self {
        if effort == 0 { Self::zero() } else { Self::from(libm::exp2(f64::from(DELTA_EXPONENT))) }
    }

    fn unit(point: &[T]) -> Self {
        let largest = point[first_of_the_largest(point)].widen();
        if largest.is_zero() { Self::one() } else { largest }
    }

    fn limit<const N: usize>(
        point: &SVector<Self, N>,
        unit: &Self,
        effort: usize,
    ) -> Option<ProjectivePoint<T, N>> {
        let larger = |best: usize, i: usize| if point[i].size() > point[best].size() { i } else { best };
        let largest = (1..N).fold(0, larger);
        let size = point[largest].size() + unit.size();
        // Comparisons with NaN are false, and therefore the condition is negated.
        if !point.iter().all(|entry| entry.radius() <= size.scaled(-KNOWN_BITS)) {
            return None;
        }
        let is_moved = effort > 0;
        let settled: [Self; N] = from_fn(|i| if is_moved { without_delta(point[i], size) } else { point[i] });
        let affine = settled.map(T::narrow);
        let is_infinite = if is_moved {
            point[largest].size() > unit.size().scaled(INFINITY_EXPONENT)
        } else {
            !affine.iter().all(T::is_finite_number)
        };
        Some(if is_infinite { direction(&settled, largest, T::narrow) } else { vector(affine).into() })
    }

    fn is_one_to_one<const N: usize>(
        derivative: &SMatrix<Self, N, N>,
        point: &SVector<Self, N>,
        unit: &Self,
    ) -> Option<bool> {
        let most = unit.size().scaled(MAX_LOST_BITS);
        let is_small = |size: fn(&Self) -> Size| {
            let entries = (0..N).flat_map(|i| (0..N).map(move |j| (i, j)));
            entries.into_iter().all(|(i, j)| size(&derivative[(i, j)]) * point[j].size() <= most)
        };
        if !derivative.iter().all(Self::is_defined) {
            None
        } else if !is_small(Self::size) {
            Some(false)
        } else {
            is_small(|entry| entry.size() + entry.radius()).then_some(true)
        }
    }
}
