//! Software floats with sparse digits and an error radius, which prove the error bound of a step.
//!
//! The numerator of a number is a [row](rows) of at most D nonzero digits to the base 2⁶⁴, and the
//! denominator has 64 bits. Zero digits are not stored, because nonzero digits may be far apart.
//! The *radius* bounds the sum of all digits that were cut off. Numbers beyond 2^(±64·2⁴⁰),
//! non-finite floats and divisions by zero are *undefined*, and so are all results from them.

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
pub(crate) use long::{Capacity, LongNumber, equilibrate_row};
pub(crate) use size::Size;

use rows::{DigitRow, leading, size_of};

/// Numbers of 17 digits of 64 bits, with which the error bounds of a step are computed.
pub(crate) type Wide = Digits<17, 40>;

/// The largest magnitude of a number's exponent to the base 2⁶⁴.
const MAX_PLACE: u64 = 1 << 40;

/// A number of at most D digits: Σᵢ digitsᵢ·2^(64·(place − belowᵢ)), divided by the denominator.
///
/// Rows of intermediate results have M = 2D + 6 digits. An operation adds at most
/// 2^[`UNIT_EXPONENT`](Wide::UNIT_EXPONENT)·|result| to the radius.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Digits<const D: usize, const M: usize> {
    digits: [i64; D],
    /// The exponent of the leading digit, to the base 2⁶⁴.
    place: i64,
    denominator: u64,
    /// The error radius, which is NaN if the number is undefined.
    radius: Size,
    /// For each digit, the number of places between the leading digit and this digit.
    below: [u16; D],
    count: u16,
}

impl<const D: usize, const M: usize> Digits<D, M> {
    pub(crate) const MOST_DIGITS: usize = {
        assert!(M == 2 * D + 6);
        D
    };

    /// The binary exponent of the largest relative error of an operation.
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

    /// Returns the leading digits of row/denominator. Digits cut off enlarge the radius.
    fn of(row: &DigitRow<M>, denominator: u64, radius: Size) -> Self {
        let Some(&(place, _)) = row.digits().first() else {
            return Self {
                radius: radius + row.tail_bound(0) / Size::from(denominator as f64),
                ..Self::ZERO
            };
        };
        if place.unsigned_abs() > MAX_PLACE {
            return Self::UNDEFINED;
        }
        let mut number = Self { place, denominator, ..Self::ZERO };
        let mut count = 0;
        for &(at, digit) in row.digits().iter().take(D) {
            let Ok(below) = u16::try_from(place - at) else { break };
            (number.digits[count], number.below[count]) = (digit, below);
            count += 1;
        }
        let cut = row.tail_bound(count);
        let cut = if cut.is_zero() { cut } else { cut / Size::from(denominator as f64) };
        Self { count: count as u16, radius: radius + cut, ..number }
    }

    fn row(&self) -> DigitRow<M> {
        let digits = self.digits.iter().zip(&self.below).take(usize::from(self.count));
        DigitRow::of_digits(digits.map(|(digit, below)| (self.place - i64::from(*below), *digit)))
    }

    /// Converts to another number of digits. Digits cut off enlarge the radius.
    #[cfg(feature = "std")]
    fn with_digits<const E: usize, const K: usize>(&self) -> Digits<E, K> {
        let digits = self.digits.iter().zip(&self.below).take(usize::from(self.count));
        let row = DigitRow::of_digits(digits.map(|(digit, below)| (self.place - i64::from(*below), *digit)));
        Digits::of(&row, self.denominator, self.radius)
    }

    #[cfg(feature = "std")]
    fn power_of_two(power: i64) -> Self {
        Self::of(&DigitRow::of_significand(1, power), 1, Size { exponent: 0, mantissa: 0.0 })
    }

    /// Returns a bound on the distance from the exact value, which is 0 if the number is exact.
    pub(crate) fn radius(&self) -> Size {
        self.radius
    }

    pub(crate) fn is_defined(&self) -> bool {
        !self.radius.is_unknown()
    }

    /// Returns |self| up to a relative 2⁻⁵⁰, or NaN if the number is undefined.
    pub(crate) fn size(&self) -> Size {
        if !self.is_defined() {
            return self.radius;
        }
        let below = if self.below[1] == 1 { self.digits[1] } else { 0 };
        let numerator = size_of(leading(self.place, self.digits[0], below));
        if self.denominator == 1 { numerator } else { numerator / Size::from(self.denominator as f64) }
    }
}
