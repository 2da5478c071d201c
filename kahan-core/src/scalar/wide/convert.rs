//! Conversions between [`Digits`] and floats, double-doubles, integers and ratios.
//!
//! Conversions from floats and 64-bit integers are exact. Conversions to floats round correctly,
//! ties to even. Values beyond the range become ±∞, and undefined numbers become NaN.

use num_traits::Zero;

use super::rows::{DigitRow, significand};
use super::{Digits, Size};

/// An IEEE 754 format of at most 64 bits.
struct Format {
    /// The number of significant bits, including the hidden bit.
    precision: u32,
    /// The exponent of the smallest normal number. The largest exponent is 1 − `lowest`.
    lowest: i64,
}

const DOUBLE: Format = Format { precision: 53, lowest: -1022 };
const SINGLE: Format = Format { precision: 24, lowest: -126 };

impl<const D: usize, const M: usize> From<i64> for Digits<D, M> {
    fn from(n: i64) -> Self {
        Self::of(&DigitRow::of_significand(n, 0), 1, Size::zero())
    }
}

impl<const D: usize, const M: usize> From<f64> for Digits<D, M> {
    fn from(x: f64) -> Self {
        if !x.is_finite() {
            return Self::UNDEFINED;
        }
        let (significand, exponent) = significand(x);
        Self::of(&DigitRow::of_significand(significand, exponent), 1, Size::zero())
    }
}

impl<const D: usize, const M: usize> From<f32> for Digits<D, M> {
    fn from(x: f32) -> Self {
        Self::from(f64::from(x))
    }
}

impl<const D: usize, const M: usize> Digits<D, M> {
    pub(crate) fn from_double_double(high: f64, low: f64) -> Self {
        Self::from(high) + Self::from(low)
    }

    pub(crate) fn from_limbs(negative: bool, limbs: &[u64]) -> Self {
        Self::of(&DigitRow::of_limbs(negative, limbs), 1, Size::zero())
    }

    pub(crate) fn from_ratio(negative: bool, numerator: &[u64], denominator: &[u64]) -> Self {
        Self::from_limbs(negative, numerator) / Self::from_limbs(false, denominator)
    }

    /// Returns the nearest `f64`, ties to even.
    pub(crate) fn to_f64(self) -> f64 {
        let magnitude = f64::from_bits(self.encode(&DOUBLE));
        if self.row().sign() < 0 { -magnitude } else { magnitude }
    }

    pub(crate) fn to_f32(self) -> f32 {
        let magnitude = f32::from_bits(self.encode(&SINGLE) as u32);
        if self.row().sign() < 0 { -magnitude } else { magnitude }
    }

    /// Returns the nearest `f64`, and the `f64` nearest to the remainder.
    pub(crate) fn to_double_double(self) -> (f64, f64) {
        let high = self.to_f64();
        // The difference is exact, because it has few digits.
        let low = if high.is_finite() { (self - Self::from(high)).to_f64() } else { 0.0 };
        (high, low)
    }

    fn encode(&self, format: &Format) -> u64 {
        let stored = format.precision - 1;
        let infinity = ((2 - 2 * format.lowest) as u64 + 1) << stored;
        if !self.is_defined() {
            return infinity | 1 << (stored - 1);
        }
        let Some((top, place)) = self.divided_out().odd_leading() else { return 0 };
        let length = 128 - i64::from(top.leading_zeros());
        let exponent = place + length - 1;
        if exponent > 1 - format.lowest {
            return infinity;
        }
        // Below the normal range, numbers have fewer bits.
        let missing = (format.lowest - exponent).max(0);
        let kept = i64::from(format.precision) - missing;
        if kept < 0 {
            // The number is below half of the smallest float.
            return 0;
        }
        let dropped = (length - kept) as u32;
        let (integer, rest) = match top.checked_shr(dropped) {
            Some(integer) => (integer as u64, top - (integer << dropped)),
            None => (0, top),
        };
        let half = 1_u128 << (dropped - 1);
        let is_up = rest > half || (rest == half && integer & 1 == 1);
        // The exponent field starts one too low; the hidden bit in `integer` increments it.
        let binade = exponent.max(format.lowest) - format.lowest;
        ((binade as u64) << stored) + integer + u64::from(is_up)
    }

    /// Returns the leading bits n ≥ 2⁶³ of |numerator|, and the exponent of their last bit. If any
    /// digits are cut off, the last bit is set, so that n rounds to fewer bits like the numerator.
    fn odd_leading(&self) -> Option<(u128, i64)> {
        let row = self.row();
        let (size, place) = row.leading_pair()?;
        let left = row.digits().iter().find(|(at, _)| *at < place).map_or(0, |(_, digit)| digit.signum());
        let odd = match left * row.sign() {
            0 => size,
            1.. => size | 1,
            _ => (size - 1) | 1,
        };
        Some((odd, 64 * place))
    }
}
