//! Exact numbers, counts and times behind options; what is wrong with them becomes a
//! [`Refusal`].

use std::fmt::Display;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use kahan_algebra::rational::Rational;
use kahan_study::Observable;
use kahan_study::numbers::{self, ScalarKind};

use crate::printing::Refusal;

/// An exact number; `what` names it in the refusal.
pub(crate) fn number(text: &str, what: &str) -> Result<Rational, Refusal> {
    numbers::number(text).map_err(|why| Refusal::new(format!("{what}: {why}")))
}

/// Reads a count between these.
pub(crate) fn whole<T>(least: T, most: T) -> impl TypedValueParser<Value = T>
where
    T: Copy + Display + TryFrom<i128> + Send + Sync + 'static,
{
    move |text: &str| numbers::whole(text, least, most)
}

/// A time bound in seconds.
pub(crate) fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.trim().parse().ok().filter(|seconds: &f64| seconds.is_finite() && *seconds > 0.0);
    seconds.ok_or_else(|| "write a number of seconds above 0, such as 60 or 0.5".to_owned())
}

/// Reads the name of one of these; `value` says it, and what it means.
pub(crate) fn one_of<T: Copy + Send + Sync>(
    known: &'static [T],
    value: fn(T) -> PossibleValue,
) -> impl TypedValueParser<Value = T> {
    let named = move |name: String| {
        let is_it = |one: &&T| value(**one).get_name() == name;
        *known.iter().find(is_it).expect("clap takes no other names")
    };
    PossibleValuesParser::new(known.iter().map(move |one| value(*one))).map(named)
}

/// Reads what is observed.
pub(crate) fn observable(known: &'static [Observable]) -> impl TypedValueParser<Value = Observable> {
    one_of(known, |of| PossibleValue::new(of.name()).help(of.meaning().trim_end_matches('.')))
}

/// Reads the name of a scalar.
pub(crate) fn scalar() -> impl TypedValueParser<Value = ScalarKind> {
    one_of(&ScalarKind::ALL, |kind| PossibleValue::new(kind.name()).help(kind.meaning()))
}

/// Reads the order of a method.
pub(crate) fn order() -> impl TypedValueParser<Value = u32> {
    PossibleValuesParser::new(["2", "4", "6", "8"]).map(|order| order.parse().expect("clap takes no others"))
}
