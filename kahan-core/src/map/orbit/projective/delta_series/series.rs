//! Laurent series in an unknown δ, exact up to their truncation.

use core::array::from_fn;

use nalgebra::{SMatrix, SVector};
use num_traits::One;

use crate::Pivot;
use crate::field::linear::vector;
use crate::scalar::Laurent;

use super::super::point::{ProjectivePoint, first_of_the_largest};
use super::{DeltaSeries, direction};

const SERIES_LENGTHS: [usize; 3] = [6, 12, 24];

impl<T: Pivot> DeltaSeries<T> for Laurent<T> {
    const EFFORTS: usize = SERIES_LENGTHS.len();

    fn of(number: &T) -> Self {
        Laurent::Number(number.clone())
    }

    fn delta(effort: usize) -> Self {
        Laurent::delta(SERIES_LENGTHS[effort])
    }

    fn unit(_point: &[T]) -> Self {
        Self::one()
    }

    fn limit<const N: usize>(
        point: &SVector<Self, N>,
        _unit: &Self,
        _effort: usize,
    ) -> Option<ProjectivePoint<T, N>> {
        let lowest = point.iter().map(Laurent::start).fold(0, i64::min);
        if point.iter().any(|entry| entry.coefficient(lowest).is_none()) {
            return None;
        }
        let leading: [T; N] = from_fn(|i| point[i].coefficient(lowest).expect("all entries have one"));
        if lowest == 0 {
            return Some(vector(leading).into());
        }
        let largest = first_of_the_largest(&leading);
        Some(direction(&leading, largest, |entry| entry))
    }

    fn is_one_to_one<const N: usize>(
        derivative: &SMatrix<Self, N, N>,
        _point: &SVector<Self, N>,
        _unit: &Self,
    ) -> Option<bool> {
        if derivative.iter().any(|entry| entry.order().is_some_and(|order| order < 0)) {
            return Some(false);
        }
        derivative.iter().all(|entry| entry.start() >= 0).then_some(true)
    }
}
