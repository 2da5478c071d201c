//! Numbers of several trajectories side by side, as one scalar.
//!
//! Every operation is that of the floats, lane by lane, so each lane has the bits that it would
//! have alone. An instruction of a line is decoded once for all of them.

use core::ops::Neg;

use kahan_core::num_traits::{One, Zero};
use kahan_core::{Constant, Scalar, operators};

use crate::line::has_value;

/// How many trajectories stand side by side.
pub(crate) const LANES: usize = 8;

/// One number of each of several trajectories.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EightLanes<T>(pub(crate) [T; LANES]);

impl<T: Scalar + Copy> EightLanes<T> {
    #[inline(always)]
    pub(crate) fn splat(value: T) -> Self {
        EightLanes([value; LANES])
    }

    // Loops in place are several times as fast as arrays that `core::array::from_fn` makes.
    #[inline(always)]
    fn map(mut self, operation: impl Fn(T) -> T) -> Self {
        for lane in 0..LANES {
            self.0[lane] = operation(self.0[lane]);
        }
        self
    }

    #[inline(always)]
    fn zip(mut self, other: Self, operation: impl Fn(T, T) -> T) -> Self {
        for lane in 0..LANES {
            self.0[lane] = operation(self.0[lane], other.0[lane]);
        }
        self
    }

    #[inline(always)]
    fn zip3(mut self, b: Self, c: Self, operation: impl Fn(T, T, T) -> T) -> Self {
        for lane in 0..LANES {
            self.0[lane] = operation(self.0[lane], b.0[lane], c.0[lane]);
        }
        self
    }
}

operators! {
    [T: Scalar + Copy] EightLanes<T>:
    |a: Self, b| a.zip(b, T::add),
    |a: Self, b| a.zip(b, T::sub),
    |a: Self, b| a.zip(b, T::mul),
    |a: Self, b| a.zip(b, T::div)
}

impl<T: Scalar + Copy> Neg for EightLanes<T> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.map(T::neg)
    }
}

impl<T: Scalar + Copy> Zero for EightLanes<T> {
    fn zero() -> Self {
        EightLanes::splat(T::zero())
    }

    fn is_zero(&self) -> bool {
        self.0.iter().all(T::is_zero)
    }
}

impl<T: Scalar + Copy> One for EightLanes<T> {
    fn one() -> Self {
        EightLanes::splat(T::one())
    }
}

impl<T: Scalar + Copy> Scalar for EightLanes<T> {
    #[inline]
    fn constant(c: &Constant<'_>) -> Self {
        EightLanes::splat(T::constant(c))
    }

    #[inline(always)]
    fn reciprocal(&self) -> Option<Self> {
        Some(self.map(|value| has_value(value.reciprocal())))
    }

    #[inline(always)]
    fn quotient(self, divisor: Self) -> Option<Self> {
        Some(self.zip(divisor, |a, b| has_value(a.quotient(b))))
    }

    #[inline(always)]
    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        self.zip3(factor, addend, T::multiply_add)
    }

    #[inline(always)]
    fn multiply_subtract(self, factor: Self, subtrahend: Self) -> Self {
        self.zip3(factor, subtrahend, T::multiply_subtract)
    }

    #[inline(always)]
    fn subtract_product(self, a: Self, b: Self) -> Self {
        self.zip3(a, b, T::subtract_product)
    }
}
