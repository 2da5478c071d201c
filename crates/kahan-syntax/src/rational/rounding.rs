//! Rounds an exact rational to the nearest float.
//!
//! Ties go to even. Results are rounded only once, even if they are subnormal. Values at least half
//! an ulp beyond the largest float become infinite, as in IEEE 754.

use num_bigint::BigUint;
use num_integer::Integer;
use num_traits::{Signed, ToPrimitive, Zero};

use super::{Rational, Repr};

/// A binary format of IEEE 754. `precision` includes the hidden bit. Normal numbers have exponents
/// from `min_exponent` to `1 - min_exponent`.
#[derive(Clone, Copy)]
pub(super) struct Format {
    precision: i64,
    min_exponent: i64,
}

pub(super) const BINARY32: Format = Format { precision: 24, min_exponent: -126 };
pub(super) const BINARY64: Format = Format { precision: 53, min_exponent: -1022 };

impl Rational {
    /// Returns the nearest `f64`, with ties to even. Values beyond the range become ±∞.
    pub fn to_f64(&self) -> f64 {
        const EXACT: u64 = 1 << 53;
        match &self.0 {
            // Both numbers are exact in `f64`, so the division rounds correctly.
            Repr::Small { num, den } if num.unsigned_abs() <= EXACT && *den as u64 <= EXACT => {
                *num as f64 / *den as f64
            }
            _ => {
                let magnitude = match self.dyadic() {
                    // Scaling by the power of two is exact here, so only the conversion rounds.
                    Some((num, shift @ 0..=1022)) => num as f64 * f64::from_bits((1023 - shift) << 52),
                    _ => f64::from_bits(round_bits(&self.magnitude(), BINARY64)),
                };
                if self.is_negative() { -magnitude } else { magnitude }
            }
        }
    }

    /// Returns the nearest `f32`, with ties to even. Values beyond the range become ±∞.
    pub fn to_f32(&self) -> f32 {
        const EXACT: u64 = 1 << 24;
        match &self.0 {
            Repr::Small { num, den } if num.unsigned_abs() <= EXACT && *den as u64 <= EXACT => {
                *num as f32 / *den as f32
            }
            // The value is exact in `f64`, so only the last conversion rounds.
            _ if matches!(self.dyadic(), Some((num, 0..=1022)) if num < 1 << 53) => self.to_f64() as f32,
            _ => {
                let magnitude = f32::from_bits(round_bits(&self.magnitude(), BINARY32) as u32);
                if self.is_negative() { -magnitude } else { magnitude }
            }
        }
    }

    /// Returns the nearest double-double `(hi, lo)`, where `hi` is the nearest `f64`. If `hi` is
    /// infinite, `lo` is 0.
    pub fn to_double_double(&self) -> (f64, f64) {
        let hi = self.to_f64();
        if hi.abs() >= f64::MIN_POSITIVE && self.dyadic().is_some_and(|(num, _)| num < 1 << 53) {
            return (hi, 0.0);
        }
        let Some(exact) = Self::from_f64(hi) else { return (hi, 0.0) };
        // The rest `self - hi` is `left/over`. Reducing it would cost time and change nothing.
        let left = self.numerator() * exact.denominator() - exact.numerator() * self.denominator();
        let over = self.denominator() * exact.denominator();
        let is_negative = left.is_negative();
        let lo = f64::from_bits(round_bits(&(left.into_parts().1, over.into_parts().1), BINARY64));
        (hi, if is_negative { -lo } else { lo })
    }

    pub(super) fn magnitude(&self) -> (BigUint, BigUint) {
        (self.numerator().into_parts().1, self.denominator().into_parts().1)
    }
}

pub(super) fn round_bits((num, den): &(BigUint, BigUint), format: Format) -> u64 {
    if num.is_zero() {
        return 0;
    }
    // The estimate satisfies 2^(estimate-1) < num/den < 2^(estimate+1).
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

    // Results below the normal range keep the smallest exponent, and have fewer digits.
    let binade = exponent.max(format.min_exponent);
    let last_place = binade - (format.precision - 1);
    let (scaled_num, scaled_den) = scale(num, den, last_place);
    let (quotient, remainder) = scaled_num.div_rem(&scaled_den);
    let mut significand = quotient.to_u64().expect("a significand has at most 53 bits");
    let twice = remainder << 1u32;
    if twice > scaled_den || (twice == scaled_den && significand % 2 == 1) {
        significand += 1;
    }
    // The hidden bit in `significand` adds 1 to the exponent field, and a carry adds another 1.
    (((binade - format.min_exponent) as u64) << (format.precision - 1)) + significand
}

fn scale(num: &BigUint, den: &BigUint, shift: i64) -> (BigUint, BigUint) {
    if shift >= 0 { (num.clone(), den << shift as u64) } else { (num << shift.unsigned_abs(), den.clone()) }
}
