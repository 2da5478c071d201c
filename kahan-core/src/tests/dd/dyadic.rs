//! Exact numbers m·2ᵉ, which are faster than fractions.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Sub};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use crate::Dd;

#[derive(Clone, Debug)]
pub(super) struct Dyadic {
    significand: BigInt,
    exponent: i32,
}

impl Dyadic {
    pub(super) fn new(significand: i64, exponent: i32) -> Self {
        Self { significand: significand.into(), exponent }
    }

    pub(super) fn float(x: f64) -> Self {
        let bits = x.abs().to_bits();
        let biased = (bits >> 52) as i32;
        let fraction = (bits & ((1 << 52) - 1)) as i64;
        assert!(x.is_finite());
        let size = if biased == 0 { fraction } else { fraction | 1 << 52 };
        Self::new(if x.is_sign_negative() { -size } else { size }, biased.max(1) - 1075)
    }

    pub(super) fn of(x: Dd) -> Self {
        Self::float(x.high()) + Self::float(x.low())
    }

    pub(super) fn abs(self) -> Self {
        Self { significand: self.significand.abs(), ..self }
    }

    pub(super) fn to_rational(&self) -> BigRational {
        let one = BigInt::from(1);
        match u32::try_from(self.exponent) {
            Ok(left) => (&self.significand << left).into(),
            Err(_) => BigRational::new(self.significand.clone(), one << self.exponent.unsigned_abs()),
        }
    }

    /// Returns n, m and e with self = n·2ᵉ and other = m·2ᵉ.
    fn aligned(self, other: Self) -> (BigInt, BigInt, i32) {
        if self.significand.is_zero() || other.significand.is_zero() {
            let exponent = if self.significand.is_zero() { other.exponent } else { self.exponent };
            return (self.significand, other.significand, exponent);
        }
        let exponent = self.exponent.min(other.exponent);
        let shifted = |x: Self| x.significand << (x.exponent - exponent) as u32;
        (shifted(self), shifted(other), exponent)
    }
}

impl Add for Dyadic {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (a, b, exponent) = self.aligned(other);
        Self { significand: a + b, exponent }
    }
}

impl Sub for Dyadic {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        let (a, b, exponent) = self.aligned(other);
        Self { significand: a - b, exponent }
    }
}

impl Mul for Dyadic {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self { significand: self.significand * other.significand, exponent: self.exponent + other.exponent }
    }
}

impl PartialEq for Dyadic {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd for Dyadic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let (a, b, _) = self.clone().aligned(other.clone());
        a.partial_cmp(&b)
    }
}
