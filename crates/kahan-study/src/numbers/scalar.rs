//! The scalar types of a computation.

use kahan_algebra::arithmetic::{Arithmetic, Exact, Float32, Float64};
use kahan_algebra::rational::Rational;
use serde::{Deserialize, Serialize};

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
    /// Double-double, with 32 digits.
    Dd,
}

impl ScalarKind {
    /// All scalar types.
    pub const ALL: [Self; 4] = [Self::Exact, Self::F32, Self::F64, Self::Dd];

    /// Returns the name as users write it in a question: `exact`, `f32`, `f64` or `dd`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::Dd => "dd",
        }
    }

    /// Returns a description of the scalar, such as `Single precision`.
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

/// An arithmetic whose values can be given in answers as a [`Number`].
pub trait Printable: Arithmetic<Constant = Rational> {
    /// The scalar type.
    const KIND: ScalarKind;

    /// Rounds an exact number to the nearest value.
    fn round(value: &Rational) -> Self::Value;

    /// Tags a value with its scalar type.
    fn number(value: &Self::Value) -> Number;

    /// Returns whether the value is finite.
    fn is_finite(value: &Self::Value) -> bool {
        Self::number(value).is_finite()
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
