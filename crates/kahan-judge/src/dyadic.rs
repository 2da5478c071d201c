//! Exact arithmetic of numbers n·2^k with integers n and k, which include all finite floats.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Sub};

use kahan_algebra::rational::Rational;
use kahan_core::num_rational::BigRational;
use kahan_core::num_traits::Float;
use num_bigint::{BigInt, Sign};

/// The number integer·2^exponent. Equal numbers may differ in both fields, so use
/// [`compare`](Dyadic::compare).
#[derive(Clone, Debug)]
pub(crate) struct Dyadic {
    integer: BigInt,
    exponent: i64,
}

impl Dyadic {
    pub(crate) fn new(integer: impl Into<BigInt>, exponent: i64) -> Self {
        Self { integer: integer.into(), exponent }
    }

    pub(crate) fn of(x: f64) -> Option<Self> {
        let (significand, exponent, sign) = Float::integer_decode(x);
        // Removing trailing zeros keeps products small. The number 0 is not shifted.
        let zeros = significand.trailing_zeros() % u64::BITS;
        let integer = i64::from(sign) * (significand >> zeros) as i64;
        x.is_finite().then(|| Self::new(integer, i64::from(exponent) + i64::from(zeros)))
    }

    pub(crate) fn zero() -> Self {
        Self::new(0, 0)
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.integer.sign() == Sign::NoSign
    }

    pub(crate) fn is_negative(&self) -> bool {
        self.integer.sign() == Sign::Minus
    }

    pub(crate) fn abs(self) -> Self {
        Self { integer: self.integer.magnitude().clone().into(), ..self }
    }

    pub(crate) fn scaled(mut self, power: i64) -> Self {
        self.exponent += power;
        self
    }

    /// Returns the exponent e with 2^e ≤ |self| < 2^(e+1); `None` for 0.
    pub(crate) fn binade(&self) -> Option<i64> {
        (!self.is_zero()).then(|| self.exponent + self.integer.bits() as i64 - 1)
    }

    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        (self - other).integer.cmp(&BigInt::ZERO)
    }

    pub(crate) fn rational(&self) -> Rational {
        let power = |exponent: i64| BigInt::from(1) << exponent.max(0);
        BigRational::new(&self.integer * power(self.exponent), power(-self.exponent)).into()
    }

    /// Converts a fraction whose denominator is a power of two.
    pub(crate) fn of_rational(value: &Rational) -> Self {
        Self::new(value.numerator(), 1 - value.denominator().bits() as i64)
    }

    /// Truncates to the leading `bits` bits, and returns e such that the error is less than 2^e.
    /// Returns `None` if the number has at most `bits` bits.
    pub(crate) fn truncated(&self, bits: u64) -> Option<(Self, i64)> {
        let excess = self.integer.bits().saturating_sub(bits);
        (excess > 0).then(|| {
            let exponent = self.exponent + excess as i64;
            // The magnitude is shifted, because shifting a negative number rounds away from 0.
            let magnitude = BigInt::from(self.integer.magnitude() >> excess);
            let integer = if self.is_negative() { -magnitude } else { magnitude };
            (Self { integer, exponent }, exponent)
        })
    }

    /// Returns self/divisor to at least `bits` bits, and e such that the error is below 2^e.
    pub(crate) fn quotient(&self, divisor: &Self, bits: u64) -> (Self, i64) {
        let shift = (bits + divisor.integer.bits()).saturating_sub(self.integer.bits()) + 1;
        let exponent = self.exponent - divisor.exponent - shift as i64;
        (Self { integer: (&self.integer << shift) / &divisor.integer, exponent }, exponent)
    }

    /// Returns the truncated significand and the exponent, where 1 ≤ |significand| < 2.
    pub(crate) fn leading(&self) -> (f64, i64) {
        let mut digits = self.integer.iter_u64_digits().rev();
        let (Some(binade), Some(first)) = (self.binade(), digits.next()) else { return (0.0, 0) };
        let both = u128::from(first) << 64 | u128::from(digits.next().unwrap_or(0));
        let top = (both << first.leading_zeros() >> (128 - 53)) as u64;
        let significand = top as f64 / (1_u64 << 52) as f64;
        (if self.is_negative() { -significand } else { significand }, binade)
    }

    /// Truncates the number to an `f64`, which is infinite beyond the range of floats.
    pub(crate) fn near_f64(&self) -> f64 {
        let (significand, binade) = self.leading();
        libm::ldexp(significand, binade.clamp(-5000, 5000) as i32)
    }

    /// Returns |self/divisor| with a relative error of 2⁻⁵⁰; infinity if the divisor is zero.
    pub(crate) fn ratio(&self, divisor: &Self) -> f64 {
        if divisor.is_zero() {
            return f64::INFINITY;
        }
        let ((above, up), (below, down)) = (self.leading(), divisor.leading());
        libm::ldexp((above / below).abs(), (up - down).clamp(-5000, 5000) as i32)
    }
}

/// Writes both numbers with the smaller exponent, and combines their integers.
fn aligned(a: &Dyadic, b: &Dyadic, combine: impl Fn(&BigInt, &BigInt) -> BigInt) -> Dyadic {
    // The exponent of a zero is arbitrary, and must not become the common exponent.
    if b.is_zero() {
        return a.clone();
    }
    if a.is_zero() {
        return Dyadic { integer: combine(&BigInt::ZERO, &b.integer), exponent: b.exponent };
    }
    let exponent = a.exponent.min(b.exponent);
    let integer = if a.exponent > exponent {
        combine(&(&a.integer << (a.exponent - exponent)), &b.integer)
    } else {
        combine(&a.integer, &(&b.integer << (b.exponent - exponent)))
    };
    Dyadic { integer, exponent }
}

impl Add for &Dyadic {
    type Output = Dyadic;

    fn add(self, other: Self) -> Dyadic {
        aligned(self, other, |a, b| a + b)
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;

    fn sub(self, other: Self) -> Dyadic {
        aligned(self, other, |a, b| a - b)
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;

    fn mul(self, other: Self) -> Dyadic {
        Dyadic { integer: &self.integer * &other.integer, exponent: self.exponent + other.exponent }
    }
}

#[cfg(test)]
mod tests {
    use super::Dyadic;
    use std::cmp::Ordering;

    #[test]
    fn floats_come_back_and_sums_are_exact() {
        for x in [0.0, 1.0, -3.25, 0.1, 1e300, -1e-300, 5e-324, f64::MIN_POSITIVE, f64::MAX] {
            let dyadic = Dyadic::of(x).unwrap();
            assert_eq!(dyadic.near_f64(), x);
            assert!((&dyadic - &dyadic).is_zero());
            assert_eq!((&dyadic + &dyadic).compare(&dyadic.clone().scaled(1)), Ordering::Equal);
        }
        assert!(Dyadic::of(f64::NAN).is_none() && Dyadic::of(f64::INFINITY).is_none());
        let (a, b) = (Dyadic::of(1e300).unwrap(), Dyadic::of(1e-300).unwrap());
        let difference = &(&a * &b) - &Dyadic::of(1.0).unwrap();
        assert_eq!(difference.near_f64(), 1e300_f64.mul_add(1e-300, -1.0));
    }

    #[test]
    fn ratios_reach_beyond_the_floats() {
        let (a, b) = (Dyadic::new(3, 5000), Dyadic::new(-2, 5001));
        assert_eq!(a.ratio(&b), 0.75);
        assert_eq!(a.ratio(&Dyadic::zero()), f64::INFINITY);
        assert_eq!(Dyadic::zero().ratio(&a), 0.0);
        assert_eq!(a.binade(), Some(5001));
        assert_eq!(b.abs().compare(&a), Ordering::Greater);
    }
}
