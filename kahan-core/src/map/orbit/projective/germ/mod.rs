//! The numbers that an orbit goes through a pole in: those of points that are moved by δ along a
//! straight line.
//!
//! In: numbers of a scalar, and how hard to try. Out: numbers that depend on δ, and of those that
//! came of them the limit δ → 0. Exact scalars take δ as an unknown, and series in it ([`series`]).
//! Floats take a δ far below their last digits, and numbers of seventeen digits of 64 bits
//! ([`digits`]).

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
    /// How many efforts there are; each sees further than the one before.
    const EFFORTS: usize;

    /// A number that does not depend on δ.
    fn of(number: &T) -> Self;

    /// δ; 0 in an effort in which nothing is moved.
    fn delta(effort: usize) -> Self;

    /// How large coordinates near a point are: δ is measured by that.
    fn unit(point: &[T]) -> Self;

    /// Where a point tends to, in coordinates of this unit; `None` where too little is known.
    fn limit<const N: usize>(
        point: &SVector<Self, N>,
        unit: &Self,
        effort: usize,
    ) -> Option<ProjectivePoint<T, N>>;

    /// Whether the points around `point` still tell those around the first one apart, given the
    /// derivative of the first one by it; `None` where too little is known.
    fn is_one_to_one<const N: usize>(
        derivative: &SMatrix<Self, N, N>,
        point: &SVector<Self, N>,
        unit: &Self,
    ) -> Option<bool>;
}

/// A direction, scaled as points at infinity are.
fn direction<S: Scalar, T: Pivot, const N: usize>(
    entries: &[S; N],
    largest: usize,
    round: impl Fn(S) -> T,
) -> ProjectivePoint<T, N> {
    let over = |divisor: usize| from_fn(|i| round(entries[i].clone() / entries[divisor].clone()));
    let first = first_of_the_largest::<T>(&over(largest));
    ProjectivePoint::at_infinity(vector(over(first)))
}
