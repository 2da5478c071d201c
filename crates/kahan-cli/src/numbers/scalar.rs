//! The numbers that `eval` and `orbit` compute with, and how they are read and printed.

use std::fmt::Write;

use clap::ValueEnum;
use kahan_algebra::arithmetic::{Arithmetic, Exact, Float32, Float64};
use kahan_algebra::rational::Rational;
use kahan_core::{Dd, Precision};
use serde_json::Value;

/// The scalar type of a computation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ScalarKind {
    /// Rational numbers.
    Exact,
    /// Single precision.
    F32,
    /// Double precision.
    F64,
    /// Double-double: 32 digits.
    Dd,
}

/// An arithmetic whose values can be printed.
pub(crate) trait Printable: Arithmetic {
    /// The scalar's name on the command line.
    const NAME: &'static str;
    /// The value nearest to an exact number.
    fn round(value: &Rational) -> Self::Value;
    /// Exact numbers as strings, floats as numbers, what is not finite as `null`.
    fn json(value: &Self::Value) -> Value;
    /// Appends the number as text that reads back as the same number: p/q, or the shortest decimal.
    fn append(value: &Self::Value, text: &mut String);
    /// Whether it is a number.
    fn is_finite(value: &Self::Value) -> bool;
}

/// An arithmetic whose values are rounded.
pub(crate) trait Rounded: Printable {
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
    const NAME: &'static str = "exact";

    fn round(value: &Rational) -> Rational {
        value.clone()
    }

    fn json(value: &Rational) -> Value {
        Value::String(value.to_string())
    }

    fn append(value: &Rational, text: &mut String) {
        append(format_args!("{value}"), text);
    }

    fn is_finite(_: &Rational) -> bool {
        true
    }
}

impl Printable for Float64 {
    const NAME: &'static str = "f64";

    fn round(value: &Rational) -> f64 {
        value.to_f64()
    }

    fn json(value: &f64) -> Value {
        Value::from(*value)
    }

    fn append(value: &f64, text: &mut String) {
        append(format_args!("{value:?}"), text);
    }

    fn is_finite(value: &f64) -> bool {
        value.is_finite()
    }
}

impl Printable for Float32 {
    const NAME: &'static str = "f32";

    fn round(value: &Rational) -> f32 {
        value.to_f32()
    }

    /// The shortest decimal that reads back as this `f32`: 0.1, not 0.10000000149011612.
    fn json(value: &f32) -> Value {
        value.to_string().parse::<f64>().map_or(Value::Null, Value::from)
    }

    fn append(value: &f32, text: &mut String) {
        append(format_args!("{value:?}"), text);
    }

    fn is_finite(value: &f32) -> bool {
        value.is_finite()
    }
}

pub(super) fn append(number: std::fmt::Arguments<'_>, text: &mut String) {
    // Writing to a string cannot fail.
    let _ = text.write_fmt(number);
}
