//! Exact numbers, counts, times, ranges and formulas as values of options.

use std::fmt::Display;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use kahan_algebra::rational::Rational;
use kahan_study::formula::{self, Formula, NamedConstants, NoFormula};
use kahan_study::numbers::{self, ScalarKind};
use kahan_study::{Axis, Observable, Range};

use crate::printing::UsageError;

pub(crate) fn number(text: &str, what: &str) -> Result<Rational, UsageError> {
    numbers::number(text).map_err(|why| UsageError::new(format!("{what}: {why}")))
}

/// Splits NAME=VALUE. If the text has another form, the error message shows `example`.
pub(crate) fn named<'a>(
    given: &'a str,
    option: &str,
    example: &str,
) -> Result<(&'a str, &'a str), UsageError> {
    let parts = given.split_once('=').map(|(name, value)| (name.trim(), value.trim()));
    parts.ok_or_else(|| {
        UsageError::new(format!("{option}: `{given}` is not NAME=VALUE, as in {option} {example}"))
    })
}

pub(crate) fn whole<T>(least: T, most: T) -> impl TypedValueParser<Value = T>
where
    T: Copy + Display + TryFrom<i128> + Send + Sync + 'static,
{
    move |text: &str| numbers::whole(text, least, most)
}

pub(crate) fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.trim().parse().ok().filter(|seconds: &f64| seconds.is_finite() && *seconds > 0.0);
    seconds.ok_or_else(|| "write a number of seconds above 0, such as 60 or 0.5".to_owned())
}

/// Returns a parser that accepts the names of `known` items. `value` gives their names and help.
pub(crate) fn one_of<T: Copy + Send + Sync + 'static>(
    known: impl IntoIterator<Item = &'static T>,
    value: fn(T) -> PossibleValue,
) -> impl TypedValueParser<Value = T> {
    let known: Vec<T> = known.into_iter().copied().collect();
    let values: Vec<PossibleValue> = known.iter().map(|one| value(*one)).collect();
    let named = move |name: String| {
        let is_it = |one: &&T| value(**one).get_name() == name;
        *known.iter().find(is_it).expect("clap takes no other names")
    };
    PossibleValuesParser::new(values).map(named)
}

pub(crate) fn observable(
    known: impl IntoIterator<Item = &'static Observable>,
) -> impl TypedValueParser<Value = Observable> {
    one_of(known, |of| PossibleValue::new(of.name()).help(of.meaning().trim_end_matches('.')))
}

pub(crate) fn scalar() -> impl TypedValueParser<Value = ScalarKind> {
    one_of(&ScalarKind::ALL, |kind| PossibleValue::new(kind.name()).help(kind.meaning()))
}

pub(crate) fn order() -> impl TypedValueParser<Value = u32> {
    PossibleValuesParser::new(["2", "4", "6", "8"]).map(|order| order.parse().expect("clap takes no others"))
}

pub(crate) fn over(text: &str) -> Result<Axis, UsageError> {
    let (name, range) = text.split_once('=').ok_or_else(|| {
        UsageError::new(format!(
            "--over: `{text}` names no parameter or variable; write NAME=FROM:TO:COUNT, as in eps=1/10:1:400"
        ))
    })?;
    axis(name.trim(), range, &format!("--over {}", name.trim()))
}

/// Reads FROM:TO:… as the range of `name`; `option` is the option that gives it.
pub(crate) fn axis(name: &str, text: &str, option: &str) -> Result<Axis, UsageError> {
    let range = Range::read(text).map_err(|why| UsageError::new(format!("{option}: {why}")))?;
    Ok(Axis { name: name.to_owned(), range })
}

/// Reads a formula in the site index `i` of a chain. Errors name `option` as its source.
pub(super) fn formula(text: &str, known: &NamedConstants, option: &str) -> Result<Formula, UsageError> {
    formula::formula(text, known).map_err(|why| refused(&why, option))
}

/// Reads named formulas in the site index `i` of a chain, such as `a = 1; b = i/n`.
pub(super) fn formulas(
    text: &str,
    known: &NamedConstants,
    option: &str,
) -> Result<Vec<(String, Formula)>, UsageError> {
    formula::formulas(text, known).map_err(|why| refused(&why, option))
}

fn refused(why: &NoFormula, option: &str) -> UsageError {
    UsageError::reports(why.report(option))
}
