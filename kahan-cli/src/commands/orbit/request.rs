//! What an orbit starts from, and the sentences that say where it cannot go on.

use kahan_algebra::arithmetic::Exact;
use kahan_algebra::kahan::TERM_BUDGET;
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;

use crate::numbers::Printable;
use crate::printing::{Refusal, shorten};

/// The orbit that is asked for, exactly.
pub(super) struct Request<'a> {
    pub(super) name: &'a str,
    pub(super) system: &'a System,
    pub(super) start: Vec<Rational>,
    pub(super) parameters: Vec<Rational>,
    pub(super) eps: Rational,
}

impl Request<'_> {
    /// Parameters and ε in the scalar; numbers that it cannot hold are refused, those of the first
    /// point too.
    pub(super) fn rounded<A: Printable>(&self) -> Result<(Vec<A::Value>, A::Value), Refusal> {
        let symbols = &self.system.field.symbols;
        let given =
            symbols.states.iter().zip(&self.start).map(|(name, value)| ("--at", name.as_str(), value));
        let given = given
            .chain(
                symbols
                    .parameters
                    .iter()
                    .zip(&self.parameters)
                    .map(|(name, value)| ("--param", name.as_str(), value)),
            )
            .chain([("--eps", "eps", &self.eps)]);
        for (option, name, value) in given {
            if !A::is_finite(&A::round(value)) {
                return Err(Refusal::new(format!(
                    "{option}: {name} is beyond the range of {}; use --scalar exact",
                    A::NAME
                )));
            }
        }
        Ok((self.parameters.iter().map(A::round).collect(), A::round(&self.eps)))
    }

    pub(super) fn undefined_field(&self) -> Refusal {
        let values = assignments::<Exact>(&self.system.field.symbols.parameters, &self.parameters);
        Refusal::new(format!("the field of {} divides by zero at {values}; choose other values", self.name))
    }

    pub(super) fn pole<A: Printable>(&self, n: i64, state: &[A::Value], is_reduced: bool) -> String {
        let (name, place, next) = (self.name, self.place::<A>(state), n + 1);
        let by_convention = if is_reduced {
            String::new()
        } else {
            format!(
                " (its closed form is beyond the budget of {TERM_BUDGET} terms, so every such point counts as a pole)"
            )
        };
        format!(
            "the orbit of {name} ends at a pole: at n = {n} det A = 0{by_convention}, so step {next} has no value. The point is \
             {place}; the rows up to it are kept"
        )
    }

    pub(super) fn stage_pole<A: Printable>(&self, n: i64, state: &[A::Value]) -> String {
        let (name, place, next) = (self.name, self.place::<A>(state), n + 1);
        format!(
            "the orbit of {name} ends at a pole: det A = 0 at a stage of step {next}, so the step has no value. The point before it \
             is {place}; the rows up to it are kept; try --order 2, which takes no step back"
        )
    }

    pub(super) fn overflow<A: Printable>(&self, n: i64, state: &[A::Value]) -> String {
        let (name, place, next, scalar) = (self.name, self.place::<A>(state), n + 1, A::NAME);
        format!(
            "the orbit of {name} leaves the range of {scalar} at step {next}: at n = {n} det A = 0 nearly or the numbers are too \
             large. The point is {place}; the rows up to it are kept; try --scalar exact"
        )
    }

    fn place<A: Printable>(&self, state: &[A::Value]) -> String {
        let symbols = &self.system.field.symbols;
        let parts = [
            assignments::<A>(&symbols.states, state),
            assignments::<Exact>(&symbols.parameters, &self.parameters),
            assignments::<Exact>(&["eps".to_owned()], std::slice::from_ref(&self.eps)),
        ];
        parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
    }
}

/// `x = 1, y = 2`, long numbers cut.
fn assignments<A: Printable>(names: &[String], values: &[A::Value]) -> String {
    const DIGITS: usize = 40;
    let parts = names.iter().zip(values).map(|(name, value)| {
        let mut text = String::new();
        A::append(value, &mut text);
        format!("{name} = {}", shorten(&text, DIGITS))
    });
    parts.collect::<Vec<_>>().join(", ")
}
