//! How a step is added to the point: rounded, or with the rounding error carried along.
//!
//! In: prepared steps, one after another. Out: the point after each.
//! A pole leaves the state as it was.

use core::array::from_fn;
use core::fmt::Debug;

use nalgebra::SVector;

use crate::field::linear::vector;
use crate::{PreparedStep, Scalar};

use super::sealed::Sealed;

/// How an [`Orbit`](crate::Orbit) adds steps up: [`Rounded`] or [`Compensated`].
pub trait Accumulation: Sealed {
    /// The point, and what is carried with it.
    #[doc(hidden)]
    type State<T: Scalar, const N: usize>: State<T, N>;
}

/// A point that steps are added to.
#[doc(hidden)]
pub trait State<T: Scalar, const N: usize>: Clone + Debug {
    /// The first point.
    fn begin(point: SVector<T, N>) -> Self;

    /// The point as it is now.
    fn point(&self) -> &SVector<T, N>;

    /// One step on; `None` at a pole of a scalar that has no reciprocal of zero.
    fn advance<P: PreparedStep<T, N>>(&mut self, step: &P) -> Option<()>;
}

/// Every point is rounded: what [`KahanMap::orbit`](crate::KahanMap::orbit) does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounded {}

/// The point is carried with its rounding error; see
/// [`Orbit::compensated`](crate::Orbit::compensated).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compensated {}

impl Sealed for Rounded {}
impl Sealed for Compensated {}

impl Accumulation for Rounded {
    type State<T: Scalar, const N: usize> = SVector<T, N>;
}

impl Accumulation for Compensated {
    type State<T: Scalar, const N: usize> = CompensatedPoint<T, N>;
}

impl<T: Scalar, const N: usize> State<T, N> for SVector<T, N> {
    #[inline(always)]
    fn begin(point: SVector<T, N>) -> Self {
        point
    }

    #[inline(always)]
    fn point(&self) -> &SVector<T, N> {
        self
    }

    #[inline(always)]
    fn advance<P: PreparedStep<T, N>>(&mut self, step: &P) -> Option<()> {
        *self = step.next(self)?;
        Some(())
    }
}

/// A point and what it lacks: the orbit is at point + carry, and the carry is at most about an ulp
/// of the point or of the last increment, whichever is larger.
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct CompensatedPoint<T, const N: usize> {
    point: SVector<T, N>,
    carry: SVector<T, N>,
}

impl<T: Scalar, const N: usize> State<T, N> for CompensatedPoint<T, N> {
    #[inline(always)]
    fn begin(point: SVector<T, N>) -> Self {
        Self { point, carry: vector(from_fn(|_| T::zero())) }
    }

    #[inline(always)]
    fn point(&self) -> &SVector<T, N> {
        &self.point
    }

    #[inline(always)]
    fn advance<P: PreparedStep<T, N>>(&mut self, step: &P) -> Option<()> {
        let [point, carry] = step.next_with_carry(&self.point, &self.carry)?;
        *self = Self { point, carry };
        Some(())
    }
}
