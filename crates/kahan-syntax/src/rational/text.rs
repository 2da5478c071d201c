//! Rationals as text: `p`, `p/q` and decimals in, `p` or `p/q` out.
//!
//! A decimal means exactly what its digits say: 0.1 is one tenth. Nothing here passes through a
//! float.

use std::fmt;

use num_bigint::BigInt;

use super::{Rational, Repr};

/// The largest size of a decimal exponent: larger ones are refused, so that no short text makes a
/// long number.
pub(crate) const LARGEST_EXPONENT: i64 = 4096;

impl Rational {
    /// Reads `p`, `p/q` or a decimal such as `0.25`, `1e-3`, `-1.5E3`, with an optional sign in
    /// front.
    ///
    /// `None` for anything else: spaces, `.5`, `1.`, a zero denominator, a decimal exponent beyond
    /// 4096 in size.
    pub fn parse(text: &str) -> Option<Self> {
        let (negative, unsigned) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text.strip_prefix('+').unwrap_or(text)),
        };
        let magnitude = match unsigned.split_once('/') {
            Some((num, den)) => natural(num)?.checked_div(&natural(den)?)?,
            None => decimal(unsigned)?,
        };
        Some(if negative { -magnitude } else { magnitude })
    }
}

/// A non-empty string of digits.
fn natural(digits: &str) -> Option<Rational> {
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    match digits.parse::<i64>() {
        Ok(small) => Some(Rational::from(small)),
        Err(_) => digits.parse::<BigInt>().ok().map(Rational::from),
    }
}

/// `digits[.digits][e[sign]digits]`
fn decimal(text: &str) -> Option<Rational> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, decimal_exponent(exponent)?),
        None => (text, 0),
    };
    let Some((whole, fraction)) = mantissa.split_once('.') else {
        return scale_by_ten(&natural(mantissa)?, exponent);
    };
    if whole.is_empty() || fraction.is_empty() {
        return None;
    }
    let shift = i64::try_from(fraction.len()).ok()?;
    scale_by_ten(&natural(&format!("{whole}{fraction}"))?, exponent - shift)
}

fn decimal_exponent(text: &str) -> Option<i64> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    let size = natural(digits)?.as_i64().filter(|size| *size <= LARGEST_EXPONENT)?;
    Some(if text.starts_with('-') { -size } else { size })
}

fn scale_by_ten(value: &Rational, exponent: i64) -> Option<Rational> {
    let power = Rational::from(10).pow(i32::try_from(exponent).ok()?)?;
    Some(value * &power)
}

/// `p`, or `p/q` where q is not 1.
impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Repr::Small { num, den: 1 } => write!(f, "{num}"),
            Repr::Small { num, den } => write!(f, "{num}/{den}"),
            Repr::Big(big) => fmt::Display::fmt(big, f),
        }
    }
}

/// The same text as `Display`: the representation is nobody's concern.
impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
