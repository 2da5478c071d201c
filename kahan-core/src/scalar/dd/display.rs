//! Double-doubles as text, correctly rounded to 32 significant digits or to the requested digits.

use core::fmt::{self, Alignment, Formatter, Write};

use super::Dd;
use super::decimal::Decimal;
use super::fixed::Fixed;

const DIGITS: i64 = 32;

/// The decimal exponents of numbers that are written without an exponent.
const POSITIONAL: core::ops::Range<i64> = -5..32;

/// Writes numbers from 10⁻⁵ to below 10³² without an exponent. With a precision, no number gets an
/// exponent, and the precision counts decimals.
impl fmt::Display for Dd {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let precision = places(f);
        self.write_padded(f, |mut decimal, out| {
            decimal.round(precision.map_or(DIGITS, |places| decimal.exponent + places));
            if precision.is_some()
                || decimal.digits().is_empty()
                || POSITIONAL.contains(&(decimal.exponent - 1))
            {
                write_positional(&decimal, precision, out)
            } else {
                write_scientific(&decimal, precision, out)
            }
        })
    }
}

/// Writes one digit before the point. The precision counts the digits after the point.
impl fmt::LowerExp for Dd {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let precision = places(f);
        self.write_padded(f, |mut decimal, out| {
            decimal.round(precision.map_or(DIGITS, |places| 1 + places));
            write_scientific(&decimal, precision, out)
        })
    }
}

impl fmt::Debug for Dd {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

fn places(f: &Formatter<'_>) -> Option<i64> {
    f.precision().map(|places| places as i64)
}

impl Dd {
    fn write_padded(
        self,
        f: &mut Formatter<'_>,
        write: impl Fn(Decimal, &mut dyn Write) -> fmt::Result,
    ) -> fmt::Result {
        let body = |out: &mut dyn Write| match self.high {
            high if high.is_nan() => out.write_str("NaN"),
            high if high.is_infinite() => out.write_str("inf"),
            _ => write(Decimal::of(&Fixed::magnitude_of(self)), out),
        };
        let sign = match (self.is_nan(), self.high.is_sign_negative(), f.sign_plus()) {
            (true, ..) | (_, false, false) => "",
            (_, true, _) => "-",
            (_, false, true) => "+",
        };
        let Some(width) = f.width() else {
            f.write_str(sign)?;
            return body(f);
        };
        let mut length = Length(sign.len());
        body(&mut length)?;
        let missing = width.saturating_sub(length.0);
        if f.sign_aware_zero_pad() {
            f.write_str(sign)?;
            repeat(f, '0', missing)?;
            return body(f);
        }
        let before = match f.align() {
            Some(Alignment::Left) => 0,
            Some(Alignment::Center) => missing / 2,
            Some(Alignment::Right) | None => missing,
        };
        let fill = f.fill();
        repeat(f, fill, before)?;
        f.write_str(sign)?;
        body(f)?;
        repeat(f, fill, missing - before)
    }
}

struct Length(usize);

impl Write for Length {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0 += text.len();
        Ok(())
    }
}

fn repeat(out: &mut dyn Write, character: char, count: usize) -> fmt::Result {
    (0..count).try_for_each(|_| out.write_char(character))
}

/// Writes the digits at these positions, with zeros beyond the last digit.
fn write_digits(decimal: &Decimal, places: core::ops::Range<i64>, out: &mut dyn Write) -> fmt::Result {
    for place in places {
        let digit = usize::try_from(place).ok().and_then(|place| decimal.digits().get(place));
        out.write_char(char::from(b'0' + digit.copied().unwrap_or(0)))?;
    }
    Ok(())
}

fn write_positional(decimal: &Decimal, precision: Option<i64>, out: &mut dyn Write) -> fmt::Result {
    let point = decimal.exponent;
    if point > 0 {
        write_digits(decimal, 0..point, out)?;
    } else {
        out.write_char('0')?;
    }
    let end = precision.map_or(decimal.digits().len() as i64, |places| point + places);
    if end > point {
        out.write_char('.')?;
        write_digits(decimal, point..end, out)?;
    }
    Ok(())
}

fn write_scientific(decimal: &Decimal, precision: Option<i64>, out: &mut dyn Write) -> fmt::Result {
    write_digits(decimal, 0..1, out)?;
    let end = precision.map_or(decimal.digits().len() as i64, |places| 1 + places);
    if end > 1 {
        out.write_char('.')?;
        write_digits(decimal, 1..end, out)?;
    }
    let exponent = if decimal.digits().is_empty() { 0 } else { decimal.exponent - 1 };
    write!(out, "e{exponent}")
}
