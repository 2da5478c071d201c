//! A software float whose exponent never runs out, and whose digits lie wherever they are needed:
//! what judges a step where hardware floats cannot.
//!
//! In: floats, constants, and the generated step that runs over any [`Scalar`](crate::Scalar). Out:
//! the same step with a bound on the error of each of its values. A number is a [row](rows) of at
//! most D digits to the base 2⁶⁴ over a denominator of 64 bits. Digits that are zero take
//! no room: (2¹⁰⁰⁰ + 1)² − 2²⁰⁰⁰ has all of its bits, however far apart they lie, and sums and
//! products of fractions as a field is written with, 1/3 or 2/7, are exact. Where digits run out,
//! the lowest are cut off, and a *radius* says how far the number may be from the value of its
//! formula.
//!
//! No fixed size is enough for every step: D(x,ε) of six variables may have hundreds of terms of
//! twelve factors, 636 bits each, anywhere between 2⁻¹²⁸⁸⁸ and 2¹²²⁸⁸; written out that would be 3
//! kB a number, megabytes for a step. What has to be kept is no more than the terms that are left
//! when larger ones have cancelled.
//!
//! Nothing overflows: places reach to ±2⁴⁰, and a number beyond is undefined. What has no value (a
//! float that is not finite, a division by zero) is *undefined* as well, which every operation
//! passes on. There are no signed zeros, no infinities and no rounding modes; conversions to
//! hardware floats are correctly rounded.
//!
//! [`rows`] is arithmetic on rows of digits, [`arithmetic`] the operators, [`convert`] the ways in
//! and out, [`size`] how large such a number is, and [`scalar`] what a Kahan map asks for.

mod arithmetic;
mod convert;
#[cfg(feature = "std")]
mod long;
mod rows;
mod scalar;
mod size;

#[cfg(all(test, feature = "exact"))]
mod tests;

use num_traits::Zero;

#[cfg(feature = "std")]
pub(crate) use long::{Capacity, Long, level_row};
pub(crate) use size::Size;

use rows::{DigitRow, leading, size_of};

/// What judges a step: numbers of 17 digits of 64 bits.
pub(crate) type Wide = Digits<17, 40>;

/// Where the leading digit may be.
const FARTHEST: u64 = 1 << 40;

/// A number of at most D digits of 64 bits, and how far it may be from what it stands for. Its sums
/// and products have M = 2D + 6 digits before the lowest are cut off.
///
/// It is the sum of digit·2^(64·(place − below)), over the denominator. Beside what its operands'
/// radii grow to, the radius of a sum, difference, product or quotient is at most
/// 2^[`UNIT_EXPONENT`](Wide::UNIT_EXPONENT) of it, and 0 where nothing was cut off.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Digits<const D: usize, const M: usize> {
    digits: [i64; D],
    /// The place of the leading digit.
    place: i64,
    /// 1 for zero.
    denominator: u64,
    /// Not a number where this is undefined.
    radius: Size,
    /// How many places below the leading digit each one is.
    below: [u16; D],
    /// How many digits there are; none is zero.
    count: u16,
}

impl<const D: usize, const M: usize> Digits<D, M> {
    /// D, for reports.
    pub(crate) const MOST_DIGITS: usize = {
        assert!(M == 2 * D + 6);
        D
    };

    /// Each operation cuts off at most 2^UNIT_EXPONENT of its result: D digits are at least
    /// 2⁶⁴⁽ᴰ⁻¹⁾⁻¹ units of the last.
    pub(crate) const UNIT_EXPONENT: i64 = -(64 * (Self::MOST_DIGITS as i64 - 1) - 2);

    const ZERO: Self = Self {
        digits: [0; D],
        place: 0,
        denominator: 1,
        radius: Size { exponent: 0, mantissa: 0.0 },
        below: [0; D],
        count: 0,
    };

    const UNDEFINED: Self = Self { radius: Size { exponent: 0, mantissa: f64::NAN }, ..Self::ZERO };

    /// The leading digits of row/denominator, with this radius and what is cut off.
    fn of(row: &DigitRow<M>, denominator: u64, radius: Size) -> Self {
        let Some(&(place, _)) = row.digits().first() else {
            return Self { radius: radius + row.without(0) / Size::from(denominator as f64), ..Self::ZERO };
        };
        if place.unsigned_abs() > FARTHEST {
            return Self::UNDEFINED;
        }
        let mut number = Self { place, denominator, ..Self::ZERO };
        let mut count = 0;
        for &(at, digit) in row.digits().iter().take(D) {
            let Ok(below) = u16::try_from(place - at) else { break };
            (number.digits[count], number.below[count]) = (digit, below);
            count += 1;
        }
        let cut = row.without(count);
        let cut = if cut.is_zero() { cut } else { cut / Size::from(denominator as f64) };
        Self { count: count as u16, radius: radius + cut, ..number }
    }

    /// The numerator.
    fn row(&self) -> DigitRow<M> {
        let digits = self.digits.iter().zip(&self.below).take(usize::from(self.count));
        DigitRow::of_digits(digits.map(|(digit, below)| (self.place - i64::from(*below), *digit)))
    }

    /// The same number with room for more digits, or the leading ones of it with room for fewer.
    #[cfg(feature = "std")]
    fn with_digits<const E: usize, const K: usize>(&self) -> Digits<E, K> {
        let digits = self.digits.iter().zip(&self.below).take(usize::from(self.count));
        let row = DigitRow::of_digits(digits.map(|(digit, below)| (self.place - i64::from(*below), *digit)));
        Digits::of(&row, self.denominator, self.radius)
    }

    /// 2^power
    #[cfg(feature = "std")]
    fn power_of_two(power: i64) -> Self {
        Self::of(&DigitRow::of_significand(1, power), 1, Size { exponent: 0, mantissa: 0.0 })
    }

    /// How far the value of the formula may be from this: 0 where nothing was cut off, in it or in
    /// what it was made from.
    pub(crate) fn radius(&self) -> Size {
        self.radius
    }

    /// Whether this is a number (zero included) rather than undefined.
    pub(crate) fn is_defined(&self) -> bool {
        !self.radius.is_unknown()
    }

    /// |self|, to a relative 2⁻⁵⁰; unknown where self is undefined.
    pub(crate) fn size(&self) -> Size {
        if !self.is_defined() {
            return self.radius;
        }
        let below = if self.below[1] == 1 { self.digits[1] } else { 0 };
        let numerator = size_of(leading(self.place, self.digits[0], below));
        if self.denominator == 1 { numerator } else { numerator / Size::from(self.denominator as f64) }
    }
}
