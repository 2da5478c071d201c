//! Into [`Wide`] and out of it: floats, pairs of floats, integers, ratios.
//!
//! What comes from a float or an integer is exact. What goes to a float is correctly rounded, ties to even, through the
//! subnormal range; beyond the largest float it is infinite, and undefined is not a number.

use core::cmp::Ordering;

use super::{LIMBS, State, Wide};

/// A format of IEEE 754 that fits 64 bits.
struct Format {
    /// Significant bits, the hidden one included.
    precision: u32,
    /// The exponent of the least normal number; the largest number has the exponent 1 − lowest.
    lowest: i64,
}

const DOUBLE: Format = Format { precision: 53, lowest: -1022 };
const SINGLE: Format = Format { precision: 24, lowest: -126 };

impl From<i64> for Wide {
    fn from(n: i64) -> Self {
        Self::from_limbs(n < 0, &[n.unsigned_abs()])
    }
}

impl From<f64> for Wide {
    fn from(x: f64) -> Self {
        if !x.is_finite() {
            return Self::UNDEFINED;
        }
        let bits = x.to_bits();
        let (fraction, field) = (bits & ((1 << 52) - 1), (bits >> 52 & 0x7ff) as i64);
        // Subnormal numbers have no hidden bit, and the exponent of the least normal ones.
        let (significand, exponent) =
            if field == 0 { (fraction, -1074) } else { (fraction | 1 << 52, field - 1075) };
        Self::from_limbs(x.is_sign_negative(), &[significand]).scaled(exponent)
    }
}

impl From<f32> for Wide {
    fn from(x: f32) -> Self {
        Self::from(f64::from(x))
    }
}

impl Wide {
    /// high + low; exact where the sum has at most 1024 bits, as for every pair whose parts are less than 2⁹⁷⁰ apart.
    pub(crate) fn from_double_double(high: f64, low: f64) -> Self {
        Self::from(high) + Self::from(low)
    }

    /// An integer of any length, its limbs in little-endian order, cut off after 1024 bits: exact up to there.
    pub(crate) fn from_limbs(negative: bool, limbs: &[u64]) -> Self {
        let Some(top) = limbs.iter().rposition(|&limb| limb != 0) else { return Self::ZERO };
        // One limb more than a mantissa, as the top one may hold few bits.
        let mut leading = [0; LIMBS + 1];
        let count = (top + 1).min(LIMBS + 1);
        leading[LIMBS + 1 - count..].copy_from_slice(&limbs[top + 1 - count..=top]);
        Self::normalised(negative, i64::try_from(64 * (top + 1) - 1).ok(), leading)
    }

    /// ±numerator/denominator from limbs of any number: at most 2⁻¹⁰²¹ of relative error.
    ///
    /// Three cuts of at most 2⁻¹⁰²³ each: of the numerator, of the denominator and of the quotient.
    pub(crate) fn from_ratio(negative: bool, numerator: &[u64], denominator: &[u64]) -> Self {
        Self::from_limbs(negative, numerator) / Self::from_limbs(false, denominator)
    }

    /// The nearest `f64`, ties to even; ±∞ beyond the largest, not a number for undefined.
    pub(crate) fn to_f64(self) -> f64 {
        let magnitude = f64::from_bits(self.encode(&DOUBLE));
        if self.negative { -magnitude } else { magnitude }
    }

    /// The nearest `f32`, ties to even, rounded once; ±∞ beyond the largest, not a number for undefined.
    pub(crate) fn to_f32(self) -> f32 {
        // Bits of the format fill the low half.
        let magnitude = f32::from_bits(self.encode(&SINGLE) as u32);
        if self.negative { -magnitude } else { magnitude }
    }

    /// The nearest `f64` and the `f64` nearest to what it leaves; (x, 0) where the first is not finite.
    ///
    /// The second is at most half an ulp of the first; where it is exactly that by its own rounding, the sum of both may
    /// round away from the first.
    pub(crate) fn to_double_double(self) -> (f64, f64) {
        let high = self.to_f64();
        // The difference is exact: it starts below the bits of `high` and ends where this number does.
        let low = if high.is_finite() { (self - Self::from(high)).to_f64() } else { 0.0 };
        (high, low)
    }

    /// The bits of |self| in a format, correctly rounded.
    fn encode(&self, format: &Format) -> u64 {
        let stored = format.precision - 1;
        let infinity = ((2 - 2 * format.lowest) as u64 + 1) << stored;
        match self.state {
            State::Zero => return 0,
            State::Undefined => return infinity | 1 << (stored - 1),
            State::Number if self.exponent > 1 - format.lowest => return infinity,
            State::Number => {}
        }
        // Below the least normal number the last place stays where it is, and bits are missing at the top.
        let missing = format.lowest.saturating_sub(self.exponent).max(0);
        let kept = i64::from(format.precision).saturating_sub(missing);
        if kept < 0 {
            // Below half of the least number.
            return 0;
        }
        let (top, lower) = (self.mantissa[LIMBS - 1], &self.mantissa[..LIMBS - 1]);
        let split = u128::from(top) << kept;
        let (integer, rest) = ((split >> 64) as u64, split as u64);
        let is_odd = integer & 1 == 1;
        let is_up = match rest.cmp(&(1 << 63)) {
            Ordering::Less => false,
            Ordering::Equal => is_odd || lower.iter().any(|&limb| limb != 0),
            Ordering::Greater => true,
        };
        // The hidden bit, and a carry out of the fraction, count the exponent up, as far as infinity.
        let binade = self.exponent.max(format.lowest) - format.lowest;
        ((binade as u64) << stored) + integer + u64::from(is_up)
    }
}
