//! A pair of registers that is used as one register of twice the width. The processor executes the
//! operations on both registers in parallel.

use core::ops::Neg;

use num_traits::{One, Zero};

use crate::scalar::operators;
use crate::{Constant, Scalar};

use super::lanes::{Lanes, Square};

/// The lanes of the first register, followed by the lanes of the second register.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RegisterPair<L>(L, L);

operators!([L: Scalar + Copy] RegisterPair<L>: Self::sum, Self::difference, Self::product, Self::ratio);

/// Operators call these functions, because closures are not inlined under target features.
impl<L: Scalar + Copy> RegisterPair<L> {
    #[inline(always)]
    fn sum(self, other: Self) -> Self {
        Self(self.0 + other.0, self.1 + other.1)
    }

    #[inline(always)]
    fn difference(self, other: Self) -> Self {
        Self(self.0 - other.0, self.1 - other.1)
    }

    #[inline(always)]
    fn product(self, other: Self) -> Self {
        Self(self.0 * other.0, self.1 * other.1)
    }

    #[inline(always)]
    fn ratio(self, other: Self) -> Self {
        Self(self.0 / other.0, self.1 / other.1)
    }
}

impl<L: Scalar + Copy> Neg for RegisterPair<L> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl<L: Scalar + Copy> Zero for RegisterPair<L> {
    #[inline(always)]
    fn zero() -> Self {
        Self(L::zero(), L::zero())
    }

    fn is_zero(&self) -> bool {
        self.0.is_zero() && self.1.is_zero()
    }
}

impl<L: Scalar + Copy> One for RegisterPair<L> {
    #[inline(always)]
    fn one() -> Self {
        Self(L::one(), L::one())
    }
}

impl<L: Scalar + Copy> Scalar for RegisterPair<L> {
    #[inline(always)]
    fn constant(c: &Constant<'_>) -> Self {
        Self(L::constant(c), L::constant(c))
    }

    #[inline(always)]
    fn reciprocal(&self) -> Option<Self> {
        Some(Self(self.0.reciprocal()?, self.1.reciprocal()?))
    }

    #[inline(always)]
    fn quotient(self, divisor: Self) -> Option<Self> {
        Some(Self(self.0.quotient(divisor.0)?, self.1.quotient(divisor.1)?))
    }

    #[inline(always)]
    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        Self(self.0.multiply_add(factor.0, addend.0), self.1.multiply_add(factor.1, addend.1))
    }

    #[inline(always)]
    fn multiply_subtract(self, factor: Self, subtrahend: Self) -> Self {
        Self(
            self.0.multiply_subtract(factor.0, subtrahend.0),
            self.1.multiply_subtract(factor.1, subtrahend.1),
        )
    }

    #[inline(always)]
    fn subtract_product(self, a: Self, b: Self) -> Self {
        Self(self.0.subtract_product(a.0, b.0), self.1.subtract_product(a.1, b.1))
    }
}

macro_rules! lanes_of {
    ($float:ty) => {
        impl<L: Lanes<$float>> Lanes<$float> for RegisterPair<L> {
            const WIDTH: usize = 2 * L::WIDTH;

            type Mask = (L::Mask, L::Mask);

            #[inline(always)]
            fn load(entries: &[$float], place: usize) -> Self {
                Self(L::load(entries, place), L::load(entries, place + L::WIDTH))
            }

            #[inline(always)]
            fn store(self, entries: &mut [$float], place: usize) {
                self.0.store(entries, place);
                self.1.store(entries, place + L::WIDTH);
            }

            #[inline(always)]
            fn spread(value: &$float) -> Self {
                Self(L::spread(value), L::spread(value))
            }

            #[inline(always)]
            fn exceeds(self, other: Self) -> Self::Mask {
                (self.0.exceeds(other.0), self.1.exceeds(other.1))
            }

            #[inline(always)]
            fn any(mask: Self::Mask) -> bool {
                L::any(mask.0) | L::any(mask.1)
            }

            #[inline(always)]
            fn choose(mask: Self::Mask, yes: Self, no: Self) -> Self {
                Self(L::choose(mask.0, yes.0, no.0), L::choose(mask.1, yes.1, no.1))
            }

            #[inline(always)]
            fn transposed(rows: Square<$float>) -> Square<$float> {
                L::transposed(rows)
            }
        }
    };
}

lanes_of!(f32);
lanes_of!(f64);
