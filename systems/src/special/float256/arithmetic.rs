//! Implements the operators of [`Float256`], and its traits for Kahan maps.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use dashu_float::Repr;
use kahan_core::num_traits::{One, Zero};
use kahan_core::{Constant, Pivot, Scalar};

use super::{CONTEXT, Float256};
use crate::special::Real;

macro_rules! operator {
    ($trait:ident, $method:ident, $assign_trait:ident, $assign:ident) => {
        impl $trait for Float256 {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                match (self.repr(), other.repr()) {
                    (Some(a), Some(b)) => Self::from_outcome(CONTEXT.$method(&a, &b)),
                    _ => Self::UNDEFINED,
                }
            }
        }

        impl $assign_trait for Float256 {
            fn $assign(&mut self, other: Self) {
                *self = $trait::$method(*self, other);
            }
        }
    };
}

operator!(Add, add, AddAssign, add_assign);
operator!(Sub, sub, SubAssign, sub_assign);
operator!(Mul, mul, MulAssign, mul_assign);
operator!(Div, div, DivAssign, div_assign);

impl Neg for Float256 {
    type Output = Self;

    fn neg(self) -> Self {
        self.repr().map_or(Self::UNDEFINED, |repr| Self::from_repr(-repr))
    }
}

impl Zero for Float256 {
    fn zero() -> Self {
        Self::from_repr(Repr::zero())
    }

    fn is_zero(&self) -> bool {
        self.repr().is_some_and(|repr| repr.significand().is_zero())
    }
}

impl One for Float256 {
    fn one() -> Self {
        Self::from_repr(Repr::one())
    }
}

impl Scalar for Float256 {
    fn constant(c: &Constant<'_>) -> Self {
        Self::from_rational(&c.to_ratio())
    }

    /// Compares absolute values. An undefined value is never the better pivot.
    fn is_better_pivot(&self, than: &Self) -> bool {
        self.magnitude_exceeds(than)
    }

    fn approximate(&self) -> f64 {
        self.to_f64()
    }
}

impl Pivot for Float256 {
    fn magnitude_exceeds(&self, other: &Self) -> bool {
        self.abs() > other.abs()
    }

    fn is_finite_number(&self) -> bool {
        self.is_defined()
    }
}
