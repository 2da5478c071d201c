//! The scalars that a question may be answered in.

use std::fmt::Write;

use kahan_algebra::arithmetic::{Arithmetic, Exact, Float32, Float64};
use kahan_algebra::rational::Rational;
use kahan_core::{Dd, Precision};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::number::Number;

/// The scalar type of a computation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ScalarKind {
    /// Rational numbers.
    Exact,
    /// Single precision.
    F32,
    /// Double precision.
    #[default]
    F64,
    /// Double-double: 32 digits.
    Dd,
}

impl ScalarKind {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Exact, Self::F32, Self::F64, Self::Dd];

    /// Its name in questions and answers.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::Dd => "dd",
        }
    }

    /// What its numbers are.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Exact => "Rational numbers",
            Self::F32 => "Single precision",
            Self::F64 => "Double precision",
            Self::Dd => "Double-double: 32 digits",
        }
    }
}

/// An arithmetic over one of the scalars.
pub trait Printable: Arithmetic {
    /// Which one.
    const KIND: ScalarKind;

    /// The value nearest to an exact number.
    fn round(value: &Rational) -> Self::Value;

    /// The value as a number that knows its scalar.
    fn number(value: &Self::Value) -> Number;

    /// The number as JSON: see [`Number`].
    fn json(value: &Self::Value) -> Value {
        serde_json::to_value(Self::number(value)).unwrap_or_default()
    }

    /// Appends the number as [`Number`] displays it.
    fn append(value: &Self::Value, text: &mut String) {
        // Writing to a string cannot fail.
        let _ = write!(text, "{}", Self::number(value));
    }

    /// Whether it is a number.
    fn is_finite(value: &Self::Value) -> bool {
        Self::number(value).is_finite()
    }
}

/// An arithmetic whose values are rounded.
pub trait Rounded: Printable {
    /// Which one, for schemes.
    const PRECISION: Precision;
    /// The value that a double-double is, which holds all of them.
    fn narrow(value: Dd) -> Self::Value;
}

impl Rounded for Float64 {
    const PRECISION: Precision = Precision::Double;

    fn narrow(value: Dd) -> f64 {
        value.high()
    }
}

impl Rounded for Float32 {
    const PRECISION: Precision = Precision::Single;

    fn narrow(value: Dd) -> f32 {
        value.high() as f32
    }
}

impl Printable for Exact {
    const KIND: ScalarKind = ScalarKind::Exact;

    fn round(value: &Rational) -> Rational {
        value.clone()
    }

    fn number(value: &Rational) -> Number {
        Number::Exact(value.clone())
    }

    /// Without a copy, which may have a million digits.
    fn append(value: &Rational, text: &mut String) {
        let _ = write!(text, "{value}");
    }
}

impl Printable for Float64 {
    const KIND: ScalarKind = ScalarKind::F64;

    fn round(value: &Rational) -> f64 {
        value.to_f64()
    }

    fn number(value: &f64) -> Number {
        Number::F64(*value)
    }
}

impl Printable for Float32 {
    const KIND: ScalarKind = ScalarKind::F32;

    fn round(value: &Rational) -> f32 {
        value.to_f32()
    }

    fn number(value: &f32) -> Number {
        Number::F32(*value)
    }
}
