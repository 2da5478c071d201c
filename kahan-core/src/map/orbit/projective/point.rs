//! Points of projective space: the points of Tᴺ, and a point at infinity for each pair of opposite
//! directions.

use nalgebra::SVector;

use crate::{Pivot, Scalar};

/// A point \[X : W\] of projective space. If W ≠ 0, the point is x = X/W. If W = 0, the point lies
/// at infinity in the directions ±X.
///
/// In normal form W is 1 or 0. At infinity, the first coordinate that is within a relative 2⁻²⁰ of
/// the largest coordinate is 1. Equal points therefore have equal coordinates, up to rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "SVector<T, N>: serde::Serialize",
        deserialize = "SVector<T, N>: serde::Deserialize<'de>"
    ))
)]
pub struct ProjectivePoint<T, const N: usize> {
    coordinates: SVector<T, N>,
    is_infinite: bool,
}

impl<T: Scalar, const N: usize> ProjectivePoint<T, N> {
    /// Returns the finite point x, or `None` if the point is at infinity.
    pub fn affine(self) -> Option<SVector<T, N>> {
        if self.is_infinite { None } else { Some(self.coordinates) }
    }

    /// Returns whether the point is at infinity.
    pub fn is_infinite(&self) -> bool {
        self.is_infinite
    }

    /// Returns the coordinates X: the point x itself, or at infinity the direction.
    pub fn coordinates(&self) -> &SVector<T, N> {
        &self.coordinates
    }

    /// Returns the weight W, which is 1, or 0 at infinity.
    pub fn weight(&self) -> T {
        if self.is_infinite { T::zero() } else { T::one() }
    }

    pub(super) fn at_infinity(direction: SVector<T, N>) -> Self {
        Self { coordinates: direction, is_infinite: true }
    }
}

impl<T: Scalar, const N: usize> From<SVector<T, N>> for ProjectivePoint<T, N> {
    fn from(coordinates: SVector<T, N>) -> Self {
        Self { coordinates, is_infinite: false }
    }
}

/// Coordinates count as equal to the largest if they differ by at most this fraction of it.
const TIE_TOLERANCE: f64 = 1.0 / (1_u32 << 20) as f64;

pub(super) fn first_of_the_largest<T: Pivot>(coordinates: &[T]) -> usize {
    let larger = |best: usize, i: usize| {
        if coordinates[i].magnitude_exceeds(&coordinates[best]) { i } else { best }
    };
    let largest = (1..coordinates.len()).fold(0, larger);
    let near = |one: &T| {
        let part = one.clone() / coordinates[largest].clone();
        part.approximate().abs() >= 1.0 - TIE_TOLERANCE
    };
    if coordinates[largest].is_zero() {
        return largest;
    }
    coordinates.iter().position(near).unwrap_or(largest)
}
