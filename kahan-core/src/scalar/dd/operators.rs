//! `+`, `-`, `*`, `/` and their assignments, the sign, and the order.

use core::cmp::Ordering;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::{Dd, arithmetic};

impl Neg for Dd {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Add for Dd {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        arithmetic::sum(self, other)
    }
}

impl Sub for Dd {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        arithmetic::sum(self, -other)
    }
}

impl Mul for Dd {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        arithmetic::product(self, other)
    }
}

impl Div for Dd {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        arithmetic::quotient(self, other)
    }
}

macro_rules! assign {
    ($($Trait:ident, $method:ident: $operator:tt;)*) => {$(
        impl $Trait for Dd {
            #[inline(always)]
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*};
}

assign! {
    AddAssign, add_assign: +;
    SubAssign, sub_assign: -;
    MulAssign, mul_assign: *;
    DivAssign, div_assign: /;
}

/// By value; what is not a number has no place.
impl PartialOrd for Dd {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        // Rounding to the nearest float keeps the order, so the low parts matter between equal high
        // parts only.
        match self.high.partial_cmp(&other.high)? {
            Ordering::Equal => self.low.partial_cmp(&other.low),
            order => Some(order),
        }
    }
}
