//! [`Digits`] as a scalar. Zero has no reciprocal; therefore steps end at exact poles.

use core::cmp::Ordering;

use num_traits::{One, Zero};

use super::Digits;
use crate::{Constant, Scalar};

impl<const D: usize, const M: usize> Scalar for Digits<D, M> {
    fn constant(c: &Constant<'_>) -> Self {
        c.to_digits()
    }

    fn reciprocal(&self) -> Option<Self> {
        Self::one().quotient(*self)
    }

    fn quotient(self, divisor: Self) -> Option<Self> {
        if divisor.is_zero() { None } else { Some(self / divisor) }
    }

    fn is_better_pivot(&self, than: &Self) -> bool {
        self.compare_magnitudes(than) == Some(Ordering::Greater)
    }

    fn approximate(&self) -> f64 {
        self.to_f64()
    }
}
