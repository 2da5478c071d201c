//! Exact numbers, counts and times behind options; what is wrong with them becomes a
//! [`Refusal`].

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use kahan_algebra::rational::Rational;
use kahan_study::Observable;
pub(crate) use kahan_study::numbers::whole;

use crate::printing::Refusal;

/// An exact number; `what` names it in the refusal.
pub(crate) fn number(text: &str, what: &str) -> Result<Rational, Refusal> {
    kahan_study::numbers::number(text).map_err(|why| Refusal::new(format!("{what}: {why}")))
}

/// A time bound in seconds.
pub(crate) fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.trim().parse().ok().filter(|seconds: &f64| seconds.is_finite() && *seconds > 0.0);
    seconds.ok_or_else(|| "write a number of seconds above 0, such as 60 or 0.5".to_owned())
}

/// The name of one of these as an option has it.
pub(crate) fn observable(known: &'static [Observable]) -> impl TypedValueParser<Value = Observable> {
    let value = |of: &Observable| PossibleValue::new(of.name()).help(of.meaning().trim_end_matches('.'));
    let named = move |name: String| *known.iter().find(|of| of.name() == name).expect("it is one of them");
    PossibleValuesParser::new(known.iter().map(value)).map(named)
}
