//! Double-double numbers as a scalar.

use num_traits::{One, Zero};

use super::{Dd, arithmetic};
use crate::{Constant, Scalar};

impl Zero for Dd {
    #[inline(always)]
    fn zero() -> Self {
        Self::leading(0.0)
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.high == 0.0
    }
}

impl One for Dd {
    #[inline(always)]
    fn one() -> Self {
        Self::leading(1.0)
    }
}

impl Scalar for Dd {
    #[inline(always)]
    fn constant(c: &Constant<'_>) -> Self {
        let (high, low) = c.to_double_double();
        Self { high, low }
    }

    #[inline(always)]
    fn reciprocal(&self) -> Option<Self> {
        Some(arithmetic::quotient(Self::one(), *self))
    }

    #[inline(always)]
    fn quotient(self, divisor: Self) -> Option<Self> {
        Some(arithmetic::quotient(self, divisor))
    }

    #[inline]
    fn is_better_pivot(&self, than: &Self) -> bool {
        self.abs() > than.abs()
    }

    #[inline(always)]
    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        arithmetic::product_plus(self, factor, addend)
    }

    #[inline(always)]
    fn multiply_subtract(self, factor: Self, subtrahend: Self) -> Self {
        arithmetic::product_plus(self, factor, -subtrahend)
    }

    #[inline(always)]
    fn subtract_product(self, a: Self, b: Self) -> Self {
        arithmetic::product_plus(-a, b, self)
    }

    #[inline]
    fn approximate(&self) -> f64 {
        self.high
    }
}
