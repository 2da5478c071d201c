//! Numbers that depend on a perturbation δ, for orbits through poles.
//!
//! In: numbers of a scalar, and the effort to spend. Out: numbers that depend on δ, and their
//! limits as δ → 0. Exact scalars use Laurent series in δ ([`series`]). Floats use a δ far below
//! their last digits and numbers of 17 digits of 64 bits ([`digits`]).

mod digits;
#[cfg(feature = "exact")]
mod series;

use core::array::from_fn;

use nalgebra::{SMatrix, SVector};

use crate::field::linear::vector;
use crate::{Pivot, Scalar};

use super::point::{ProjectivePoint, first_of_the_largest};

/// A number over the scalar T that may depend on δ.
pub(super) trait Germ<T: Scalar>: Scalar {
    /// The number of efforts; each resolves more than the previous one.
    const EFFORTS: usize;

    fn of(number: &T) -> Self;

    /// Returns δ; 0 in an effort without perturbation.
    fn delta(effort: usize) -> Self;

    /// Returns the size of coordinates near a point, the unit of δ.
    fn unit(point: &[T]) -> Self;

    /// Returns the limit of a point as δ → 0, in these units; `None` if too little is known.
    fn limit<const N: usize>(
        point: &SVector<Self, N>,
        unit: &Self,
        effort: usize,
    ) -> Option<ProjectivePoint<T, N>>;

    /// Returns whether neighbourhoods of the first point and `point` correspond one-to-one;
    /// `derivative` is that of the first point by `point`. `None` if too little is known.
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
