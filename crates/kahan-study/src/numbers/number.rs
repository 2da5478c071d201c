//! Numbers in answers, each in the scalar type in which it was computed.

use std::fmt;

use kahan_algebra::rational::Rational;
use kahan_core::Dd;
use serde::{Serialize, Serializer};

/// A number in the scalar of its computation.
///
/// The text of a number reads back as an equal number. In JSON, exact numbers are strings, finite
/// floats are numbers, and other floats are `null`.
#[derive(Clone, Debug, PartialEq)]
pub enum Number {
    /// A rational number.
    Exact(Rational),
    /// A number in single precision.
    F32(f32),
    /// A number in double precision.
    F64(f64),
    /// A double-double number.
    Dd(Dd),
}

impl Number {
    /// Returns the nearest double.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        match self {
            Self::Exact(value) => value.to_f64(),
            Self::F32(value) => (*value).into(),
            Self::F64(value) => *value,
            Self::Dd(value) => value.high(),
        }
    }

    /// Returns whether the number is finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        matches!(self, Self::Exact(_)) || self.to_f64().is_finite()
    }

    /// Returns whether the number is NaN.
    #[must_use]
    pub fn is_nan(&self) -> bool {
        self.to_f64().is_nan()
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exact(value) => write!(f, "{value}"),
            Self::F32(value) => write!(f, "{value:?}"),
            Self::F64(value) => write!(f, "{value:?}"),
            Self::Dd(value) => {
                let text = value.to_string();
                // Whole numbers are written with `.0`, as `{:?}` writes `f32` and `f64`.
                let end = if value.is_finite() && !text.contains(['.', 'e']) { ".0" } else { "" };
                write!(f, "{text}{end}")
            }
        }
    }
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        // In JSON, an `f32` is written as its shortest decimal, and a `Dd` with all its digits.
        let written = |text: String| text.parse::<serde_json::Number>().ok();
        match self {
            Self::Exact(value) => serializer.collect_str(value),
            Self::F64(value) => Some(value).filter(|value| value.is_finite()).serialize(serializer),
            Self::F32(value) => {
                written(value.to_string()).and_then(|number| number.as_f64()).serialize(serializer)
            }
            Self::Dd(_) => written(self.to_string()).serialize(serializer),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_digits_in_json() {
        let third = Rational::new(1, 3);
        let dd = Dd::from(1.0) / Dd::from(3.0);
        for (number, json) in [
            (Number::Exact(third.clone()), "\"1/3\""),
            (Number::F64(third.to_f64()), "0.3333333333333333"),
            (Number::F32(0.1), "0.1"),
            (Number::F64(f64::INFINITY), "null"),
            (Number::F32(f32::NAN), "null"),
            (Number::Dd(dd), "0.33333333333333333333333333333333"),
            (Number::Dd(Dd::from(2.0)), "2.0"),
        ] {
            assert_eq!(serde_json::to_string(&number).expect("a number"), json);
        }
        assert!(!Number::F64(f64::NAN).is_finite() && Number::Exact(third).is_finite());
    }
}
