//! Sums and products of sparse rows of base-2⁶⁴ digits, exact up to digits that are cut off.
//!
//! Digits are signed, from −2⁶³ to 2⁶³ − 1. The value of a row is Σ digit·2^(64·place), which has
//! the sign of the leading digit. A full row cuts off low digits, and stores a bound on them.

use num_traits::Zero;

use super::Size;

/// A row of at most M nonzero digits, each stored with its place. The leading digit comes first.
#[derive(Clone, Copy, Debug)]
pub(super) struct DigitRow<const M: usize> {
    digits: [(i64, i64); M],
    /// The index of the leading digit. Rows are filled from the end of the array.
    start: usize,
    /// An upper bound on the value of the digits cut off.
    cut: Size,
}

/// The most digits of a short row. Longer rows estimate quotients from `LEADING` leading digits.
const SHORT: usize = 40;
const LEADING: usize = 18;

/// Returns an upper bound on the magnitude of a digit and all lower digits together.
fn from_here_on((place, digit): (i64, i64)) -> Size {
    Size::from(digit.unsigned_abs() as f64 * (1.0 + 4.0 * f64::EPSILON) + 1.0).scaled(64 * place)
}

impl<const M: usize> DigitRow<M> {
    /// Whether quotient digits are estimated from short rows of leading digits instead of floats.
    const IS_LONG: bool = M > SHORT;

    /// The minimum number of correct bits of an estimated quotient.
    const GUESSED: usize = if Self::IS_LONG { 64 * (LEADING - 2) } else { 48 };

    /// The number of rounds of a division. Each round determines `GUESSED` bits of the quotient.
    const ROUNDS: usize = 64 * (M / 2 - 2) / Self::GUESSED + 1;

    pub(super) const EMPTY: Self =
        Self { digits: [(0, 0); M], start: M, cut: Size { exponent: 0, mantissa: 0.0 } };

    /// Adds the low 64 bits of `total` as the new leading digit, and returns the other bits.
    fn settle(&mut self, place: i64, total: i128) -> i128 {
        let digit = total as i64;
        if digit != 0 {
            self.lead((place, digit));
        }
        (total - i128::from(digit)) >> 64
    }

    /// Adds a new leading digit. A full row cuts off its last digit.
    fn lead(&mut self, digit: (i64, i64)) {
        if self.start == 0 {
            self.cut = self.cut + from_here_on(self.digits[M - 1]);
            self.digits.copy_within(..M - 1, 1);
            self.start = 1;
        }
        self.start -= 1;
        self.digits[self.start] = digit;
    }

    pub(super) fn of_limbs(negative: bool, limbs: &[u64]) -> Self {
        let (mut row, mut carry, mut place) = (Self::EMPTY, 0, 0);
        for limb in limbs {
            let limb = i128::from(*limb);
            carry = row.settle(place, if negative { -limb } else { limb } + carry);
            place += 1;
        }
        row.settle(place, carry);
        row
    }

    pub(super) fn of_significand(significand: i64, exponent: i64) -> Self {
        let (place, shift) = (exponent.div_euclid(64), exponent.rem_euclid(64));
        let mut row = Self::EMPTY;
        let carry = row.settle(place, i128::from(significand) << shift);
        row.settle(place + 1, carry);
        row
    }

    pub(super) fn of_digits(digits: impl DoubleEndedIterator<Item = (i64, i64)>) -> Self {
        let mut row = Self::EMPTY;
        digits.rev().for_each(|digit| row.lead(digit));
        row
    }

    pub(super) fn digits(&self) -> &[(i64, i64)] {
        &self.digits[self.start..]
    }

    /// Returns an upper bound on the value of all digits after the first `kept`, including digits
    /// that were cut off.
    pub(super) fn tail_bound(&self, kept: usize) -> Size {
        self.digits().get(kept).map_or(self.cut, |&digit| self.cut + from_here_on(digit))
    }

    /// Returns 1, −1, or 0 for an empty row.
    pub(super) fn sign(&self) -> i64 {
        self.digits().first().map_or(0, |(_, digit)| digit.signum())
    }

    /// Returns m and e with m·2^e equal to the row up to a relative 2⁻⁵¹.
    pub(super) fn leading(&self) -> (f64, i64) {
        match *self.digits() {
            [] => (0.0, 0),
            [(place, digit), (next, rest), ..] if next == place - 1 => leading(place, digit, rest),
            [(place, digit), ..] => leading(place, digit, 0),
        }
    }

    pub(super) fn size(&self) -> Size {
        size_of(self.leading())
    }

    /// Returns |d·2⁶⁴ + d′| for the leading digit d and the next digit d′, with the place of d′.
    pub(super) fn leading_pair(&self) -> Option<(u128, i64)> {
        let (&(place, first), rest) = self.digits().split_first()?;
        let second = rest.first().filter(|(next, _)| *next == place - 1).map_or(0, |(_, digit)| *digit);
        let size = u128::from(first.unsigned_abs()) << 64;
        Some((size.wrapping_add_signed(i128::from(second) * i128::from(first.signum())), place - 1))
    }

    pub(super) fn plus(&self, other: &Self, sign: i64) -> Self {
        let mut sum = Self { cut: self.cut + other.cut, ..Self::EMPTY };
        let (mut these, mut those) = (self.digits(), other.digits());
        let (mut place, mut carry) = (0, 0);
        loop {
            let lowest = |digits: &[(i64, i64)]| digits.last().map(|(place, _)| *place);
            let next = match (lowest(these), lowest(those)) {
                (Some(this), Some(that)) => Some(this.min(that)),
                (this, that) => this.or(that),
            };
            let here = if carry == 0 { next } else { Some(place) };
            let Some(here) = here else { break };
            let mut take = |digits: &mut &[(i64, i64)], sign: i64| {
                if let Some(((place, digit), higher)) = digits.split_last()
                    && *place == here
                {
                    carry += i128::from(sign) * i128::from(*digit);
                    *digits = higher;
                }
            };
            take(&mut these, 1);
            take(&mut those, sign);
            carry = sum.settle(here, carry);
            place = here + 1;
        }
        sum
    }

    /// Returns self·factor·2^(64·up).
    fn times_digit(&self, (up, factor): (i64, i64)) -> Self {
        let cut = self.cut * Size::from(factor.unsigned_abs() as f64).scaled(64 * up);
        let mut product = Self { cut, ..Self::EMPTY };
        let (mut place, mut carry) = (0, 0);
        for &(at, digit) in self.digits().iter().rev() {
            if carry != 0 && place != at + up {
                carry = product.settle(place, carry);
            }
            carry = product.settle(at + up, i128::from(digit) * i128::from(factor) + carry);
            place = at + up + 1;
        }
        product.settle(place, carry);
        product
    }

    /// Returns self·factor. The factor must be exact.
    pub(super) fn times(&self, factor: &Self) -> Self {
        self.times_in_place(factor).unwrap_or_else(|| self.times_far_apart(factor))
    }

    /// Returns self·factor, or `None` if self is inexact or the product does not fit a row.
    pub(super) fn times_in_place(&self, factor: &Self) -> Option<Self> {
        let (these, those) = (self.digits(), factor.digits());
        let (&(top, _), &(low, _)) = (these.first()?, these.last()?);
        let (&(factor_top, _), &(factor_low, _)) = (those.first()?, those.last()?);
        let lowest = low + factor_low;
        // Carries need at most two places above the sum of the leading places.
        let places = usize::try_from(top + factor_top - lowest).ok().filter(|span| span + 3 <= M)? + 3;
        if !self.cut.is_zero() {
            return None;
        }
        let mut sums = [0_i64; M];
        for &(up, factor) in those {
            let (mut at, mut carry) = ((low + up - lowest) as usize, 0_i128);
            let mut add = |sum: &mut i64, part: i128| {
                let total = part + i128::from(*sum) + carry;
                *sum = total as i64;
                carry = (total - i128::from(*sum)) >> 64;
                carry != 0
            };
            for &(place, digit) in these.iter().rev() {
                let here = (place + up - lowest) as usize;
                while at < here && add(&mut sums[at], 0) {
                    at += 1;
                }
                add(&mut sums[here], i128::from(digit) * i128::from(factor));
                at = here + 1;
            }
            while add(&mut sums[at], 0) {
                at += 1;
            }
        }
        let mut product = Self::EMPTY;
        for (sum, place) in sums[..places].iter().zip(lowest..).filter(|(sum, _)| **sum != 0) {
            product.lead((place, *sum));
        }
        Some(product)
    }

    /// Returns self·factor for digits that may be far apart.
    pub(super) fn times_far_apart(&self, factor: &Self) -> Self {
        let parts = factor.digits().iter().map(|&digit| self.times_digit(digit));
        parts.reduce(|sum, part| sum.plus(&part, 1)).unwrap_or(Self::EMPTY)
    }

    /// Returns q and r with self = q·divisor + r exactly, for a nonzero divisor. |r/divisor| is
    /// less than one unit of the last digit that `Digits` keeps of q.
    pub(super) fn divided(&self, divisor: &Self) -> (Self, Self) {
        let (mut quotient, mut rest) = (Self::EMPTY, *self);
        for _ in 0..Self::ROUNDS {
            if rest.sign() == 0 {
                break;
            }
            let digits = rest.guessed_quotient(divisor);
            rest = rest.plus(&divisor.times(&digits), -1);
            quotient = quotient.plus(&digits, 1);
        }
        (quotient, rest)
    }

    /// Returns an estimate of the leading digits of self/divisor.
    fn guessed_quotient(&self, divisor: &Self) -> Self {
        if Self::IS_LONG {
            let (quotient, _) = self.leading_digits().divided(&divisor.leading_digits());
            return Self::of_digits(quotient.digits().iter().copied());
        }
        let ((above, up), (below, down)) = (self.leading(), divisor.leading());
        let (significand, exponent) = significand(above / below);
        Self::of_significand(significand, exponent + up - down)
    }

    fn leading_digits(&self) -> DigitRow<SHORT> {
        DigitRow::of_digits(self.digits().iter().take(LEADING).copied())
    }
}

/// Returns m and e with m·2^e ≈ (digit + below·2⁻⁶⁴)·2^(64·place), where `below` is the next digit.
pub(super) fn leading(place: i64, digit: i64, below: i64) -> (f64, i64) {
    (digit as f64 + below as f64 * f64::from_bits((1023 - 64) << 52), 64 * place)
}

pub(super) fn size_of((leading, exponent): (f64, i64)) -> Size {
    Size::from(leading.abs()).scaled(exponent)
}

/// Returns n and e with n·2^e = x, for a finite x.
pub(super) fn significand(x: f64) -> (i64, i64) {
    let bits = x.to_bits();
    let (fraction, field) = ((bits & ((1 << 52) - 1)) as i64, (bits >> 52 & 0x7ff) as i64);
    // A subnormal number has the exponent of the smallest normal number, and no hidden bit.
    let (size, exponent) = if field == 0 { (fraction, -1074) } else { (fraction | 1 << 52, field - 1075) };
    (if x.is_sign_negative() { -size } else { size }, exponent)
}
