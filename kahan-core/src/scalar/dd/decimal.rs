//! Conversion between decimal text and fixed-point numbers, exact and without allocation.

use core::num::ParseFloatError;
use core::str::FromStr;

use super::Dd;
use super::fixed::{Fixed, HALF};

const CHUNK_DIGITS: usize = 19;

const CHUNK_BASE: u64 = 10_000_000_000_000_000_000;

/// An upper bound on the digits of sums of two `f64`: 309 before the point, and 1075 after it.
const CAPACITY: usize = 1444;

/// An upper bound on the zeros between the point and the first digit of a number.
const LEADING_ZEROS: usize = 342;

/// The number 0.d₁d₂…·10^exponent with digits dᵢ. The first and the last digit are not 0.
pub(super) struct Decimal {
    digits: [u8; CAPACITY],
    length: usize,
    pub(super) exponent: i64,
    is_cut: bool,
}

impl Decimal {
    const ZERO: Self = Self { digits: [0; CAPACITY], length: 0, exponent: 0, is_cut: false };

    pub(super) fn digits(&self) -> &[u8] {
        &self.digits[..self.length]
    }

    pub(super) fn of(number: &Fixed) -> Self {
        let mut decimal = Self::ZERO;
        let (fraction, integer) = number.limbs.split_at(HALF);
        let mut chunks = [0; HALF + 1];
        let count = integer_chunks(integer, &mut chunks);
        for &chunk in chunks[..count].iter().rev() {
            decimal.push_chunk(chunk);
        }
        decimal.exponent += (CHUNK_DIGITS * count) as i64;
        let mut limbs = [0; HALF];
        limbs.copy_from_slice(fraction);
        while limbs.iter().any(|&limb| limb != 0) {
            decimal.push_chunk(next_chunk(&mut limbs));
        }
        decimal.trim();
        decimal
    }

    /// Appends nineteen digits. Zeros before the first nonzero digit of the number are left out.
    fn push_chunk(&mut self, mut chunk: u64) {
        let mut power = CHUNK_BASE / 10;
        while power != 0 {
            self.push((chunk / power) as u8);
            chunk %= power;
            power /= 10;
        }
    }

    fn push(&mut self, digit: u8) {
        if self.length == 0 && digit == 0 {
            self.exponent -= 1;
        } else if self.length < CAPACITY {
            self.digits[self.length] = digit;
            self.length += 1;
        } else {
            self.is_cut |= digit != 0;
        }
    }

    fn trim(&mut self) {
        while self.length > 0 && self.digits[self.length - 1] == 0 {
            self.length -= 1;
        }
        if self.length == 0 {
            self.exponent = 0;
        }
    }

    /// Rounds to `count` digits, ties to even. A negative count gives 0.
    pub(super) fn round(&mut self, count: i64) {
        let Ok(count) = usize::try_from(count) else {
            *self = Self::ZERO;
            return;
        };
        if count >= self.length {
            return;
        }
        let is_odd = count > 0 && self.digits[count - 1] % 2 == 1;
        // If digits follow a dropped 5, there is no tie, because the last stored digit is not 0.
        let has_rest = self.length > count + 1 || self.is_cut;
        let goes_up = self.digits[count] > 5 || self.digits[count] == 5 && (has_rest || is_odd);
        self.length = count;
        if goes_up {
            while self.length > 0 && self.digits[self.length - 1] == 9 {
                self.length -= 1;
            }
            if self.length == 0 {
                self.digits[0] = 0;
                self.length = 1;
                self.exponent += 1;
            }
            self.digits[self.length - 1] += 1;
        }
        self.trim();
    }

    /// Parses a text that `f64` also parses, and ignores its sign.
    fn read(text: &str) -> Self {
        let text = text.trim_start_matches(['+', '-']);
        let (significand, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let mut decimal = Self::ZERO;
        let mut is_fraction = false;
        for character in significand.bytes() {
            match character {
                b'.' => is_fraction = true,
                digit => {
                    decimal.push(digit - b'0');
                    decimal.exponent += i64::from(!is_fraction);
                }
            }
        }
        let exponent = exponent.parse().expect("beyond 64 bits of exponent every number is 0 or infinite");
        decimal.exponent = decimal.exponent.saturating_add(exponent);
        decimal.trim();
        decimal
    }

    /// Truncates a nonzero number to fixed point, and returns whether digits were cut off.
    fn to_fixed(&self) -> (Fixed, bool) {
        let digit =
            |place: i64| usize::try_from(place).ok().and_then(|place| self.digits().get(place)).copied();
        let chunk = |first: i64| {
            (first..first + CHUNK_DIGITS as i64)
                .fold(0, |chunk, place| 10 * chunk + u64::from(digit(place).unwrap_or(0)))
        };
        let mut fixed = Fixed::ZERO;
        let (fraction, integer) = fixed.limbs.split_at_mut(HALF);
        let mut first = self.exponent.rem_euclid(CHUNK_DIGITS as i64) - CHUNK_DIGITS as i64;
        while first < self.exponent {
            append_chunk(integer, chunk(first));
            first += CHUNK_DIGITS as i64;
        }
        const CHUNKS: usize = (CAPACITY + LEADING_ZEROS) / CHUNK_DIGITS + 1;
        let mut chunks = [0; CHUNKS];
        let behind = (self.length as i64 - self.exponent).max(0) as usize;
        let used = behind.div_ceil(CHUNK_DIGITS).min(CHUNKS);
        for (i, entry) in chunks[..used].iter_mut().enumerate() {
            *entry = chunk(self.exponent + (CHUNK_DIGITS * i) as i64);
        }
        for limb in fraction.iter_mut().rev() {
            *limb = next_limb(&mut chunks[..used]);
        }
        let has_more = self.is_cut || chunks.iter().any(|&chunk| chunk != 0);
        (fixed, has_more)
    }
}

/// Writes an integer as chunks of 19 decimal digits, lowest first, and returns their number.
fn integer_chunks(integer: &[u64], chunks: &mut [u64; HALF + 1]) -> usize {
    let mut limbs = [0; HALF];
    limbs.copy_from_slice(integer);
    let mut count = 0;
    while limbs.iter().any(|&limb| limb != 0) {
        let mut remainder = 0;
        for limb in limbs.iter_mut().rev() {
            let dividend = u128::from(remainder) << 64 | u128::from(*limb);
            *limb = (dividend / u128::from(CHUNK_BASE)) as u64;
            remainder = (dividend % u128::from(CHUNK_BASE)) as u64;
        }
        chunks[count] = remainder;
        count += 1;
    }
    count
}

fn append_chunk(integer: &mut [u64], chunk: u64) {
    let mut carry = chunk;
    for limb in integer {
        let product = u128::from(*limb) * u128::from(CHUNK_BASE) + u128::from(carry);
        *limb = product as u64;
        carry = (product >> 64) as u64;
    }
}

/// Removes and returns the first nineteen decimal digits of a binary fraction.
fn next_chunk(fraction: &mut [u64; HALF]) -> u64 {
    let mut carry = 0;
    for limb in fraction {
        let product = u128::from(*limb) * u128::from(CHUNK_BASE) + u128::from(carry);
        *limb = product as u64;
        carry = (product >> 64) as u64;
    }
    carry
}

/// Removes and returns the first 64 bits of a decimal fraction.
fn next_limb(fraction: &mut [u64]) -> u64 {
    let mut carry = 0;
    for chunk in fraction.iter_mut().rev() {
        let product = u128::from(*chunk) << 64 | u128::from(carry);
        carry = (product / u128::from(CHUNK_BASE)) as u64;
        *chunk = (product % u128::from(CHUNK_BASE)) as u64;
    }
    carry
}

/// Parses the text forms that `f64` parses, with both parts correctly rounded.
impl FromStr for Dd {
    type Err = ParseFloatError;

    /// # Errors
    /// If `f64` rejects the text.
    fn from_str(text: &str) -> Result<Self, ParseFloatError> {
        let high: f64 = text.parse()?;
        if !high.is_finite() || high == 0.0 {
            return Ok(Self::leading(high));
        }
        let (number, has_more) = Decimal::read(text).to_fixed();
        let leading = Fixed::magnitude(high);
        let low = if number.is_less(&leading) {
            let rest = leading.minus(&number);
            let rest = if has_more { rest.minus(&Fixed::last_place()) } else { rest };
            -rest.rounded(has_more)
        } else {
            number.minus(&leading).rounded(has_more)
        };
        Ok(Self { high, low: if high.is_sign_negative() { -low } else { low } })
    }
}
