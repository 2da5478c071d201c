//! From an exact rational to the nearest float.
//!
//! In goes p/q, out comes the float nearest to it, ties to even, straight from the exact value: no
//! intermediate float is rounded first. Subnormals are exact to their last bit, and what exceeds
//! the largest float by half an ulp or more is infinite, as IEEE 754 has it.

use num_bigint::BigUint;
use num_integer::Integer;
use num_traits::{Signed, ToPrimitive, Zero};

use super::{Rational, Repr};

/// A binary interchange format: `precision` bits with the hidden one, exponents of normal numbers
/// from `min_exponent` to `-min_exponent + 1`.
#[derive(Clone, Copy)]
pub(super) struct Format {
    precision: i64,
    min_exponent: i64,
}

pub(super) const BINARY32: Format = Format { precision: 24, min_exponent: -126 };
pub(super) const BINARY64: Format = Format { precision: 53, min_exponent: -1022 };

impl Rational {
    /// The nearest `f64`, ties to even; ±∞ beyond the range.
    pub fn to_f64(&self) -> f64 {
        const EXACT: u64 = 1 << 53;
        match &self.0 {
            // Both are floats, so IEEE division rounds the true quotient, which is far from the
            // subnormals.
            Repr::Small { num, den } if num.unsigned_abs() <= EXACT && *den as u64 <= EXACT => {
                *num as f64 / *den as f64
            }
            _ => {
                let magnitude = match self.dyadic() {
                    // A normal number, whose rounding is that of the numerator.
                    Some((num, shift @ 0..=1022)) => num as f64 * f64::from_bits((1023 - shift) << 52),
                    _ => f64::from_bits(round_bits(&self.magnitude(), BINARY64)),
                };
                if self.is_negative() { -magnitude } else { magnitude }
            }
        }
    }

    /// The nearest `f32`, ties to even, rounded once from the exact value; ±∞ beyond the range.
    pub fn to_f32(&self) -> f32 {
        const EXACT: u64 = 1 << 24;
        match &self.0 {
            Repr::Small { num, den } if num.unsigned_abs() <= EXACT && *den as u64 <= EXACT => {
                *num as f32 / *den as f32
            }
            // The number is an `f64`, so that one rounding leads to `f32`.
            _ if matches!(self.dyadic(), Some((num, 0..=1022)) if num < 1 << 53) => self.to_f64() as f32,
            _ => {
                let magnitude = f32::from_bits(round_bits(&self.magnitude(), BINARY32) as u32);
                if self.is_negative() { -magnitude } else { magnitude }
            }
        }
    }

    /// The nearest double-double `(hi, lo)`: `hi` is [`to_f64`](Self::to_f64) and `lo` the nearest
    /// `f64` to what `hi` leaves; `lo` is 0 where `hi` is infinite.
    pub fn to_double_double(&self) -> (f64, f64) {
        let hi = self.to_f64();
        if hi.abs() >= f64::MIN_POSITIVE && self.dyadic().is_some_and(|(num, _)| num < 1 << 53) {
            return (hi, 0.0);
        }
        let Some(exact) = Self::from_f64(hi) else { return (hi, 0.0) };
        // Common factors of what is left change no rounding, and to look for them in thousands of
        // digits takes longer than all the rest.
        let left = self.numerator() * exact.denominator() - exact.numerator() * self.denominator();
        let over = self.denominator() * exact.denominator();
        let is_negative = left.is_negative();
        let lo = f64::from_bits(round_bits(&(left.into_parts().1, over.into_parts().1), BINARY64));
        (hi, if is_negative { -lo } else { lo })
    }

    /// |p| and q.
    pub(super) fn magnitude(&self) -> (BigUint, BigUint) {
        (self.numerator().into_parts().1, self.denominator().into_parts().1)
    }
}

/// The bits of the float of `format` nearest to num/den.
pub(super) fn round_bits((num, den): &(BigUint, BigUint), format: Format) -> u64 {
    if num.is_zero() {
        return 0;
    }
    // 2^(estimate-1) < num/den < 2^(estimate+1)
    let estimate = num.bits() as i64 - den.bits() as i64;
    let max_exponent = 1 - format.min_exponent;
    let infinity = ((max_exponent - format.min_exponent + 1) as u64 + 1) << (format.precision - 1);
    if estimate > max_exponent + 1 {
        return infinity;
    }
    if estimate < format.min_exponent - format.precision - 1 {
        return 0;
    }
    let (scaled_num, scaled_den) = scale(num, den, estimate);
    let exponent = if scaled_num < scaled_den { estimate - 1 } else { estimate };
    if exponent > max_exponent {
        return infinity;
    }

    // num/den = significand · 2^last_place, with gradual underflow below the normal numbers.
    let binade = exponent.max(format.min_exponent);
    let last_place = binade - (format.precision - 1);
    let (scaled_num, scaled_den) = scale(num, den, last_place);
    let (quotient, remainder) = scaled_num.div_rem(&scaled_den);
    let mut significand = quotient.to_u64().expect("a significand has at most 53 bits");
    let twice = remainder << 1u32;
    if twice > scaled_den || (twice == scaled_den && significand % 2 == 1) {
        significand += 1;
    }
    // The hidden bit of the significand adds one to the exponent field, and so does a carry out of
    // rounding, up to infinity; a subnormal has neither.
    (((binade - format.min_exponent) as u64) << (format.precision - 1)) + significand
}

/// num/den · 2^-shift as a pair of integers.
fn scale(num: &BigUint, den: &BigUint, shift: i64) -> (BigUint, BigUint) {
    if shift >= 0 { (num.clone(), den << shift as u64) } else { (num << shift.unsigned_abs(), den.clone()) }
}
