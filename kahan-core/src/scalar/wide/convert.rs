//! Into [`Digits`] and out of it: floats, pairs of floats, integers, ratios.
//!
//! What comes from a float or an integer is exact. What goes to a float is correctly rounded, ties
//! to even, through the subnormal range; beyond the largest float it is infinite, and undefined is
//! not a number.

use num_traits::Zero;

use super::rows::{DigitRow, significand};
use super::{Digits, Size};

/// A format of IEEE 754 that fits 64 bits.
struct Format {
    /// Significant bits, the hidden one included.
    precision: u32,
    /// The exponent of the least normal number; the largest number has the exponent 1 − lowest.
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
    /// high + low
    pub(crate) fn from_double_double(high: f64, low: f64) -> Self {
        Self::from(high) + Self::from(low)
    }

    /// An integer of any length, its limbs in little-endian order.
    pub(crate) fn from_limbs(negative: bool, limbs: &[u64]) -> Self {
        Self::of(&DigitRow::of_limbs(negative, limbs), 1, Size::zero())
    }

    /// ±numerator/denominator from limbs of any number.
    pub(crate) fn from_ratio(negative: bool, numerator: &[u64], denominator: &[u64]) -> Self {
        Self::from_limbs(negative, numerator) / Self::from_limbs(false, denominator)
    }

    /// The nearest `f64`, ties to even; ±∞ beyond the largest, not a number for undefined.
    pub(crate) fn to_f64(self) -> f64 {
        let magnitude = f64::from_bits(self.encode(&DOUBLE));
        if self.row().sign() < 0 { -magnitude } else { magnitude }
    }

    /// The nearest `f32`, ties to even, rounded once; ±∞ beyond the largest, not a number for
    /// undefined.
    pub(crate) fn to_f32(self) -> f32 {
        // Bits of the format fill the low half.
        let magnitude = f32::from_bits(self.encode(&SINGLE) as u32);
        if self.row().sign() < 0 { -magnitude } else { magnitude }
    }

    /// The nearest `f64` and the `f64` nearest to what it leaves; (x, 0) where the first is not
    /// finite.
    ///
    /// The second is at most half an ulp of the first; where it is exactly that by its own
    /// rounding, the sum of both may round away from the first.
    pub(crate) fn to_double_double(self) -> (f64, f64) {
        let high = self.to_f64();
        // The difference is exact: it starts below the bits of `high` and ends where this number
        // does.
        let low = if high.is_finite() { (self - Self::from(high)).to_f64() } else { 0.0 };
        (high, low)
    }

    /// The bits of |self| in a format, correctly rounded.
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
        // Below the least normal number the last place stays where it is, and bits are missing at
        // the top.
        let missing = (format.lowest - exponent).max(0);
        let kept = i64::from(format.precision) - missing;
        if kept < 0 {
            // Below half of the least number.
            return 0;
        }
        let dropped = (length - kept) as u32;
        let (integer, rest) = match top.checked_shr(dropped) {
            Some(integer) => (integer as u64, top - (integer << dropped)),
            None => (0, top),
        };
        let half = 1_u128 << (dropped - 1);
        let is_up = rest > half || (rest == half && integer & 1 == 1);
        // The hidden bit, and a carry out of the fraction, count the exponent up, as far as
        // infinity.
        let binade = exponent.max(format.lowest) - format.lowest;
        ((binade as u64) << stored) + integer + u64::from(is_up)
    }

    /// |numerator| as n·2^e with 64 bits of n at least. Where more was left out n is odd,
    /// and rounds to fewer bits as the whole does.
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
