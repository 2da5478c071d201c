//! Floats whose multiply-adds are rounded once in every build, as on a processor that fuses.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use kahan_core::num_traits::{One, Zero};
use kahan_core::{Constant, EnsembleScalar, Scalar};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Fused<F>(pub(crate) F);

macro_rules! operator {
    ($float:ty, $operator:ident, $method:ident, $assign:ident, $assign_method:ident) => {
        impl $operator for Fused<$float> {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Self($operator::$method(self.0, other.0))
            }
        }

        impl $assign for Fused<$float> {
            fn $assign_method(&mut self, other: Self) {
                *self = $operator::$method(*self, other);
            }
        }
    };
}

macro_rules! fused {
    ($float:ty, $constant:ident) => {
        operator!($float, Add, add, AddAssign, add_assign);
        operator!($float, Sub, sub, SubAssign, sub_assign);
        operator!($float, Mul, mul, MulAssign, mul_assign);
        operator!($float, Div, div, DivAssign, div_assign);

        impl Neg for Fused<$float> {
            type Output = Self;

            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl Zero for Fused<$float> {
            fn zero() -> Self {
                Self(0.0)
            }

            fn is_zero(&self) -> bool {
                self.0 == 0.0
            }
        }

        impl One for Fused<$float> {
            fn one() -> Self {
                Self(1.0)
            }
        }

        impl Scalar for Fused<$float> {
            fn constant(c: &Constant<'_>) -> Self {
                Self(c.$constant())
            }

            fn multiply_add(self, factor: Self, addend: Self) -> Self {
                Self(self.0.mul_add(factor.0, addend.0))
            }

            fn multiply_subtract(self, factor: Self, subtrahend: Self) -> Self {
                Self(self.0.mul_add(factor.0, -subtrahend.0))
            }

            fn subtract_product(self, a: Self, b: Self) -> Self {
                Self((-a.0).mul_add(b.0, self.0))
            }
        }

        impl EnsembleScalar for Fused<$float> {}
    };
}

fused!(f32, to_f32);
fused!(f64, to_f64);
