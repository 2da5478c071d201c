//! Numbers that depend on a perturbation δ → 0, for orbits through poles.
//!
//! Over exact scalars the numbers are Laurent series in δ ([`series`]). Over floats δ is at first
//! 0, and then a number far below the last digits; numbers have up to 17 × 64 bits ([`digits`]).

mod digits;
#[cfg(feature = "exact")]
mod series;

use core::array::from_fn;

use nalgebra::{SMatrix, SVector};

use crate::field::linear::vector;
use crate::{Pivot, Scalar};

use super::point::{ProjectivePoint, first_of_the_largest};

/// A number over the scalar T that may depend on the perturbation δ.
pub(super) trait DeltaSeries<T: Scalar>: Scalar {
    /// The number of attempts. Each attempt determines more points than the attempt before.
    const EFFORTS: usize;

    fn of(number: &T) -> Self;

    /// Returns δ, which is 0 in an attempt without perturbation.
    fn delta(effort: usize) -> Self;

    /// Returns the magnitude of a point. The perturbation δ is relative to this magnitude.
    fn unit(point: &[T]) -> Self;

    /// Returns the limit of a point as δ → 0, relative to `unit`. Returns `None` if the digits of
    /// the numbers do not suffice.
    fn limit<const N: usize>(
        point: &SVector<Self, N>,
        unit: &Self,
        effort: usize,
    ) -> Option<ProjectivePoint<T, N>>;

    /// Returns whether the steps from the start of a passage to `point` are one-to-one near the
    /// start. Returns `None` if the numbers have too few digits. `derivative` is the Jacobian of
    /// the inverse steps.
    fn is_one_to_one<const N: usize>(
        derivative: &SMatrix<Self, N, N>,
        point: &SVector<Self, N>,
        unit: &Self,
    ) -> Option<bool>;
}

fn direction<S: Scalar, T: Pivot, const N: usize>(
    entries: &[S; N],
    largest: usize,
    round: impl Fn(S) -> T,
) -> ProjectivePoint<T, N> {
    let over = |divisor: usize| from_fn(|i| round(entries[i].clone() / entries[divisor].clone()));
    let first = first_of_the_largest::<T>(&over(largest));
    ProjectivePoint::at_infinity(vector(over(first)))
}
