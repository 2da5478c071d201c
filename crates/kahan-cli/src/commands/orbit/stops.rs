//! The sentences that say where an orbit cannot begin, or cannot go on.

use kahan_algebra::interpret::Point;
use kahan_algebra::kahan::TERM_BUDGET;
use kahan_algebra::rational::Rational;
use kahan_core::SingularStep;

use crate::numbers::Printable;
use crate::printing::Refusal;
use crate::reading::Request;

impl Request {
    /// Parameters and ε in the scalar; numbers that it cannot hold are refused, those of the first
    /// points too.
    pub(super) fn rounded<A: Printable>(
        &self,
        starts: &[Vec<Rational>],
    ) -> Result<(Vec<A::Value>, A::Value), Refusal> {
        let symbols = &self.system.field.symbols;
        let Point { parameters, eps, .. } = &self.point;
        let names = symbols.states.iter().cycle();
        let states = names.zip(starts.iter().flatten()).map(|(name, value)| ("--at", name.as_str(), value));
        let parameters_given = symbols.parameters.iter().zip(parameters);
        let given = states
            .chain(parameters_given.map(|(name, value)| ("--param", name.as_str(), value)))
            .chain([("--eps", "eps", eps)]);
        for (option, name, value) in given {
            if !A::is_finite(&A::round(value)) {
                return Err(Refusal::new(format!(
                    "{option}: {name} is beyond the range of {}; use --scalar exact",
                    A::KIND.name()
                )));
            }
        }
        Ok((parameters.iter().map(A::round).collect(), A::round(eps)))
    }

    pub(super) fn pole<A: Printable>(&self, n: i64, state: &[A::Value], is_reduced: bool) -> String {
        let (name, place, next) = (&self.name, self.place::<A>(state), n + 1);
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
        let (name, place, next) = (&self.name, self.place::<A>(state), n + 1);
        format!(
            "the orbit of {name} ends at a pole: det A = 0 at a stage of step {next}, so the step has no value. The point before it \
             is {place}; the rows up to it are kept; try --order 2, which takes no step back"
        )
    }

    /// Of an orbit that goes through poles.
    pub(super) fn end(&self, n: i64, why: Option<SingularStep>) -> String {
        let why = why.map_or_else(String::new, |why| format!(": {why}"));
        format!("the orbit of {} ends at n = {n}{why}; the rows up to it are kept", self.name)
    }

    pub(super) fn overflow<A: Printable>(&self, n: i64, state: &[A::Value]) -> String {
        let (name, place, next, scalar) = (&self.name, self.place::<A>(state), n + 1, A::KIND.name());
        format!(
            "the orbit of {name} leaves the range of {scalar} at step {next}: at n = {n} det A = 0 nearly or the numbers are too \
             large. The point is {place}; the rows up to it are kept; try --scalar exact"
        )
    }
}
