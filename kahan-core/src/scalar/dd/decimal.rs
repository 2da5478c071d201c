//! Decimals: the digits of a number, and the number of digits.
//!
//! In: text, or a pair of floats. Out: each other, exactly; text of any length is read as if all
//! its digits counted. `core` finds the float of some digits. Nothing here allocates.

use core::fmt::{self, Write};
use core::num::ParseFloatError;
use core::str::FromStr;

use super::Dd;
use crate::scalar::significand;

/// Places before the point; the largest numbers have 309 digits there, and one more may be carried.
const BEFORE: usize = 310;

/// Places in all. No float, and no tie between two of them, has a digit beyond 1075 places behind
/// the point; a digit at the last place here stands for all digits that are farther behind.
const PLACES: usize = BEFORE + 1077;

/// Decimal digits of a chunk of a number, and what one more chunk is worth.
const CHUNK: usize = 18;
const CHUNK_BASE: u128 = 1_000_000_000_000_000_000;

/// Chunks of the significant digits of a float; none has more than 767.
const CHUNKS: usize = 767_usize.div_ceil(CHUNK);

/// Σ digits\[k\]·10^(BEFORE − 1 − k), each digit from 0 to 9.
pub(super) struct Decimal {
    digits: [i8; PLACES],
    /// The place of the first digit other than 0, and the one behind the last; both are `BEFORE`
    /// for 0. Before digits are carried there may be zeros.
    start: usize,
    end: usize,
}

impl Decimal {
    const ZERO: Self = Self { digits: [0; PLACES], start: BEFORE, end: BEFORE };

    /// Every digit of |x|, for a finite x.
    pub(super) fn of(x: Dd) -> Self {
        let mut decimal = Self::ZERO;
        decimal.add_float(1, x.high);
        let is_same_sign = x.high.is_sign_negative() == x.low.is_sign_negative();
        decimal.add_float(if is_same_sign { 1 } else { -1 }, x.low);
        decimal.settle();
        decimal
    }

    /// The digits, from the first one other than 0 to the last.
    pub(super) fn digits(&self) -> impl ExactSizeIterator<Item = char> {
        self.digits[self.start..self.end].iter().map(|digit| char::from(b'0' + digit.unsigned_abs()))
    }

    /// The power of ten of the number 0.d₁d₂…·10^exponent.
    pub(super) fn exponent(&self) -> i64 {
        BEFORE as i64 - self.start as i64
    }

    /// Adds sign·|x|, for a finite x, without carrying.
    fn add_float(&mut self, sign: i8, x: f64) {
        let (odd, exponent) = significand(x.abs());
        let zeros = if odd == 0 { 0 } else { odd.trailing_zeros() };
        let exponent = exponent + i64::from(zeros);
        // Powers below a chunk: n·2⁻ᵏ is n·5ᵏ·10⁻ᵏ.
        let (base, most) = if exponent < 0 { (5_u64, 25) } else { (2, 59) };
        let mut chunks = [0; CHUNKS];
        chunks[0] = odd as u64 >> zeros;
        let (mut used, mut left) = (1, exponent.unsigned_abs() as u32);
        while left > 0 && odd != 0 {
            let power = u128::from(base.pow(left.min(most)));
            left -= left.min(most);
            let mut carry = 0;
            for chunk in &mut chunks[..used] {
                let product = u128::from(*chunk) * power + carry;
                *chunk = (product % CHUNK_BASE) as u64;
                carry = product / CHUNK_BASE;
            }
            if carry > 0 {
                chunks[used] = carry as u64;
                used += 1;
            }
        }
        let last = BEFORE - 1 + exponent.min(0).unsigned_abs() as usize;
        for (i, &chunk) in chunks[..used].iter().enumerate() {
            let (mut rest, mut place) = (chunk, last - CHUNK * i);
            while rest > 0 {
                self.digits[place] += sign * (rest % 10) as i8;
                self.start = self.start.min(place);
                self.end = self.end.max(place + 1);
                (rest, place) = (rest / 10, place.saturating_sub(1));
            }
        }
    }

    /// Adds sign times a number that `f64` accepts and is finite, its own sign aside, without
    /// carrying.
    fn add(&mut self, sign: i8, text: &str) {
        let text = text.trim_start_matches(['+', '-']);
        let (significand, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let exponent: i64 =
            exponent.parse().expect("beyond 64 bits of exponent every number is 0 or infinite");
        let whole = significand.find('.').unwrap_or(significand.len());
        let first = BEFORE as i64 - whole as i64 - exponent;
        let digits = significand.bytes().filter(|character| *character != b'.');
        for (place, digit) in (first..).zip(digits.map(|character| (character - b'0').cast_signed())) {
            // Zeros may lead where there is no place.
            if digit != 0 {
                let place = (place as usize).min(PLACES - 1);
                if place < PLACES - 1 {
                    self.digits[place] += sign * digit;
                } else {
                    self.digits[place] = sign;
                }
                self.start = self.start.min(place);
                self.end = self.end.max(place + 1);
            }
        }
    }

    /// Carries, and changes the sign of a number below zero; returns whether it was one.
    fn settle(&mut self) -> bool {
        let from = self.start.saturating_sub(1);
        let digits = &mut self.digits[from..self.end];
        // All digits behind the first are less than a unit of it.
        let is_negative = digits.iter().find(|digit| **digit != 0).is_some_and(|digit| *digit < 0);
        let mut carry = 0;
        for digit in digits.iter_mut().rev() {
            let sum = carry + if is_negative { -*digit } else { *digit };
            carry = sum.div_euclid(10);
            *digit = sum.rem_euclid(10);
        }
        let place = |found: Option<usize>| found.map(|place| from + place);
        let last = place(digits.iter().rposition(|digit| *digit != 0));
        self.start = place(digits.iter().position(|digit| *digit != 0)).unwrap_or(BEFORE);
        self.end = last.map_or(BEFORE, |last| last + 1);
        is_negative
    }

    /// Rounds to `count` digits, ties to even. A negative count, which is no less than the negative
    /// [`exponent`](Self::exponent), leaves nothing.
    pub(super) fn round(&mut self, count: i64) {
        let end = self.start as i64 + count;
        if end >= self.end as i64 {
            return;
        }
        let end = end as usize;
        let (next, last) = (self.digits[end], self.digits[end - 1]);
        // The last digit is not 0, so more than one digit is more than a tie.
        let goes_up = next > 5 || next == 5 && (self.end > end + 1 || last % 2 == 1);
        self.digits[end - 1] += i8::from(goes_up);
        self.digits[end..self.end].fill(0);
        self.settle();
    }

    /// The nearest float, ties to even.
    fn to_float(&self) -> f64 {
        let mut text = Text::EMPTY;
        let power = self.exponent() - (self.end - self.start) as i64;
        self.digits()
            .try_for_each(|digit| text.write_char(digit))
            .and_then(|()| write!(text, "0e{}", power - 1))
            .expect("there is room for all places");
        text.as_str().parse().expect("digits and an exponent are a number")
    }
}

/// Digits, a point and an exponent as text.
struct Text {
    bytes: [u8; PLACES + 16],
    length: usize,
}

impl Text {
    const EMPTY: Self = Self { bytes: [0; PLACES + 16], length: 0 };

    fn as_str(&self) -> &str {
        str::from_utf8(&self.bytes[..self.length]).expect("whole strings were written")
    }
}

impl Write for Text {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let free = self.bytes[self.length..].get_mut(..text.len()).ok_or(fmt::Error)?;
        free.copy_from_slice(text.as_bytes());
        self.length += text.len();
        Ok(())
    }
}

/// A number as `f64` reads it, also `inf` and `NaN`: high is the float nearest to it, low the float
/// nearest to the rest.
impl FromStr for Dd {
    type Err = ParseFloatError;

    /// # Errors
    /// Where the text is no number for `f64` either.
    fn from_str(text: &str) -> Result<Self, ParseFloatError> {
        let high: f64 = text.parse()?;
        if !high.is_finite() || high == 0.0 {
            return Ok(Self::leading(high));
        }
        let mut rest = Decimal::ZERO;
        rest.add(1, text);
        rest.add_float(-1, high);
        let is_below = rest.settle();
        let low = rest.to_float();
        Ok(Self { high, low: if is_below == high.is_sign_negative() { low } else { -low } })
    }
}
