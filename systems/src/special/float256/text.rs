//! Reads and writes [`Float256`] as decimals, with one rounding. Reading also accepts fractions
//! such as `3/7`. It refuses a decimal if the exponent of its last digit exceeds 100 000 in
//! absolute value.

use core::fmt;
use core::str::FromStr;

use dashu_float::round::mode::HalfEven;
use dashu_float::{Context, DBig, FBig};
use dashu_int::IBig;

use super::{Float256, quotient};

/// The error that a text is neither a decimal nor a fraction of integers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParsePreciseError(String);

impl fmt::Display for ParsePreciseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` is not a number: write a decimal like `-1.5e-3` or a fraction like `3/7`", self.0)
    }
}

impl core::error::Error for ParsePreciseError {}

/// The largest decimal exponent that is accepted. Numbers with larger exponents exhaust the memory.
const EXPONENT_LIMIT: isize = 100_000;

impl FromStr for Float256 {
    type Err = ParsePreciseError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let error = || ParsePreciseError(text.to_owned());
        let integer = |part: &str| IBig::from_str(part.trim()).map_err(|_| error());
        if let Some((p, q)) = text.split_once('/') {
            let value = quotient(&integer(p)?, &integer(q)?);
            return if value.is_defined() { Ok(value) } else { Err(error()) };
        }
        let decimal = DBig::from_str(text.trim()).map_err(|_| error())?;
        let (significand, exponent) = decimal.into_repr().into_parts();
        if exponent.abs() > EXPONENT_LIMIT {
            return Err(error());
        }
        let power = IBig::from(10).pow(exponent.unsigned_abs());
        Ok(if exponent < 0 {
            quotient(&significand, &power)
        } else {
            quotient(&(significand * power), &IBig::ONE)
        })
    }
}

impl Float256 {
    /// Writes `digits` significant decimal digits (at least one), rounded to nearest. Numbers below
    /// 10⁻⁵, and numbers with more than `digits` digits before the point, get an exponent.
    pub fn to_digits(&self, digits: usize) -> String {
        let Some(repr) = self.repr() else { return "undefined".to_owned() };
        if repr.significand().is_zero() {
            return "0".to_owned();
        }
        let digits = digits.max(1);
        let exact = FBig::<HalfEven, 2>::from_repr(repr, Context::new(0));
        let decimal = exact.with_base_and_precision::<10>(digits).value();
        let (significand, exponent) = decimal.into_repr().into_parts();
        let text = significand.to_string();
        let (sign, figures) = text.strip_prefix('-').map_or(("", text.as_str()), |rest| ("-", rest));
        // The number is d.ddd × 10^scale. Trailing zeros, dropped by the conversion, are appended.
        let scale = exponent + figures.len() as isize - 1;
        let figures = format!("{figures:0<digits$}");
        if !(-5..digits as isize).contains(&scale) {
            let (first, rest) = figures.split_at(1);
            let point = if rest.is_empty() { "" } else { "." };
            return format!("{sign}{first}{point}{rest}e{scale}");
        }
        if scale < 0 {
            let zeros = "0".repeat((-scale - 1) as usize);
            return format!("{sign}0.{zeros}{figures}");
        }
        let (whole, fraction) = figures.split_at(scale as usize + 1);
        let point = if fraction.is_empty() { "" } else { "." };
        format!("{sign}{whole}{point}{fraction}")
    }
}

/// The format's precision is the number of significant digits, by default 60.
impl fmt::Display for Float256 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.to_digits(f.precision().unwrap_or(60)))
    }
}

impl fmt::Debug for Float256 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
