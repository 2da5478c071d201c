//! Reads rationals as exact decimals or quotients of two decimals, and writes them as `p` or `p/q`.

use std::fmt;

use num_bigint::BigInt;

use super::numeral::Numeral;
use super::{Rational, Repr};

/// The largest decimal exponent. The limit prevents short texts from creating huge numbers.
pub(crate) const LARGEST_EXPONENT: i64 = 4096;

impl Rational {
    /// Reads a signed decimal, or a quotient of two decimals. Examples are `3/7`, `-2`, `1e-3`,
    /// `1_000`, `.5` and `5.`.
    ///
    /// Returns `None` for other texts, for a divisor that is zero, and for exponents beyond ±4096.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
        let size = match unsigned.split_once('/') {
            Some((above, below)) => decimal(above)?.checked_div(&decimal(below)?)?,
            None => decimal(unsigned)?,
        };
        Some(if text.starts_with('-') { -size } else { size })
    }
}

/// Reads a decimal without a sign. Forms such as `.5` and `5.e3` are allowed.
fn decimal(text: &str) -> Option<Rational> {
    if let Some(value) = short_decimal(text) {
        return Some(value);
    }
    let text = without_separators(text).replacen(".e", "e", 1).replacen(".E", "E", 1);
    let Numeral { whole, fraction, exponent, rest } = Numeral::scan(&text);
    if !rest.is_empty() {
        return None;
    }
    let exponent = if exponent.is_empty() { 0 } else { decimal_exponent(exponent)? };
    let power = exponent - i64::try_from(fraction.len()).ok()?;
    Some(&natural(&format!("{whole}{fraction}"))? * &Rational::from(10).pow(i32::try_from(power).ok()?)?)
}

/// Reads a decimal of at most 18 digits, without an exponent and without separators.
fn short_decimal(text: &str) -> Option<Rational> {
    const MOST_DIGITS: usize = 18;

    let (mut numerator, mut denominator, mut digits, mut has_point) = (0, 1, 0, false);
    for byte in text.bytes() {
        match byte {
            b'0'..=b'9' if digits < MOST_DIGITS => {
                digits += 1;
                numerator = 10 * numerator + i64::from(byte - b'0');
                denominator *= if has_point { 10 } else { 1 };
            }
            b'.' if !has_point => has_point = true,
            _ => return None,
        }
    }
    (digits > 0).then(|| Rational::new(numerator, denominator))
}

fn natural(digits: &str) -> Option<Rational> {
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    match digits.parse::<i64>() {
        Ok(small) => Some(Rational::from(small)),
        Err(_) => digits.parse::<BigInt>().ok().map(Rational::from),
    }
}

fn decimal_exponent(text: &str) -> Option<i64> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    let size = natural(digits)?.as_i64().filter(|size| *size <= LARGEST_EXPONENT)?;
    Some(if text.starts_with('-') { -size } else { size })
}

fn without_separators(text: &str) -> String {
    let is_digit =
        |at: Option<usize>| at.and_then(|at| text.as_bytes().get(at)).is_some_and(u8::is_ascii_digit);
    let kept = text.char_indices();
    let kept = kept.filter(|&(at, c)| c != '_' || !is_digit(at.checked_sub(1)) || !is_digit(Some(at + 1)));
    kept.map(|(_, c)| c).collect()
}

/// The number is written as `p`, or as `p/q` if q ≠ 1.
impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Repr::Small { num, den: 1 } => write!(f, "{num}"),
            Repr::Small { num, den } => write!(f, "{num}/{den}"),
            Repr::Big(big) => fmt::Display::fmt(big, f),
        }
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
