//! Prepares the systems of the catalog and the fields with generic coefficients for evaluation.

use kahan_algebra::arithmetic::{Arithmetic, Dual, solve};
use kahan_algebra::lexer::lex;
use kahan_algebra::plan::Plan;
use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Text};
use kahan_algebra::system::System;
use kahan_algebra::{Derived, derive, read_unproved};

use kahan_systems::entry::Entry;

#[derive(Debug)]
pub(super) struct Model {
    derived: Derived,
}

/// The values of a system's states, parameters and ε, in this order.
pub(super) type Values<'a, V> = &'a [V];

impl Model {
    pub(super) fn of_catalog(entry: &'static Entry) -> Self {
        Model::new(entry.command, entry.text())
    }

    /// Makes the model from the text of a block. Panics if the text has a mistake.
    pub(super) fn new(name: &'static str, text: &str) -> Self {
        let system = read_unproved(&lex(text).tokens).system();
        let system = system.unwrap_or_else(|mistakes| panic!("the block of {name}: {mistakes:?}"));
        Model { derived: derive(&system) }
    }

    pub(super) fn system(&self) -> &System {
        &self.derived.system
    }

    pub(super) fn dimension(&self) -> usize {
        self.system().field.dimension()
    }

    /// Returns whether the map is available as a formula in lowest terms.
    pub(super) fn is_expanded(&self) -> bool {
        self.derived.map.is_some()
    }

    pub(super) fn names(&self) -> Vec<String> {
        let symbols = &self.system().field.symbols;
        let all = symbols.states.iter().chain(&symbols.parameters).cloned();
        all.chain(["eps".to_owned()]).collect()
    }

    /// Returns the components of the field as definitions `f1 := …; f2 := …;`.
    pub(super) fn field_definitions(&self) -> String {
        let symbols = &self.system().field.symbols;
        let text = |polynomial: &Polynomial| Text.polynomial(symbols, polynomial);
        let components = self.system().field.components.iter().enumerate();
        components
            .map(|(index, component)| {
                format!(
                    "f{} := ({})/({});\n",
                    index + 1,
                    text(component.numerator()),
                    text(component.denominator())
                )
            })
            .collect()
    }

    /// Evaluates the entries, row by row, of the field `f`, its Jacobian matrix `Df`, `A` or `b` of
    /// Kahan's system A x̃ = b, or the map's Jacobian matrix `J`.
    pub(super) fn entries<A: Arithmetic<Constant = Rational>>(
        &self,
        object: &str,
        arithmetic: &A,
        here: Values<'_, A::Value>,
    ) -> Option<Vec<A::Value>> {
        let plan = match object {
            "f" => self.derived.field(),
            "Df" => self.derived.field_jacobian(),
            "A" => self.derived.matrix(),
            "b" => self.derived.rhs(),
            _ => return self.jacobian(arithmetic, here),
        };
        run(arithmetic, plan, here)
    }

    pub(super) fn rows<V: Clone>(&self, entries: &[V]) -> Vec<Vec<V>> {
        entries.chunks(self.dimension()).map(<[V]>::to_vec).collect()
    }

    /// Computes the next point by the map's formula, or by elimination if no formula was derived.
    pub(super) fn next<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        here: Values<'_, A::Value>,
    ) -> Option<Vec<A::Value>> {
        let Some(plan) = self.derived.reduced_map.as_ref().or(self.derived.rational_map.as_ref()) else {
            let right = run(arithmetic, self.derived.rhs(), here)?.into_iter().map(|value| vec![value]);
            let matrix = self.rows(&run(arithmetic, self.derived.matrix(), here)?);
            let solved = solve(arithmetic, &matrix, &right.collect::<Vec<_>>())?;
            return Some(solved.solution.into_iter().flatten().collect());
        };
        let mut numerators = run(arithmetic, plan, here)?;
        let denominator = numerators.pop()?;
        numerators.iter().map(|numerator| arithmetic.divide(numerator, &denominator)).collect()
    }

    /// Computes ∂x̃/∂x by dual numbers.
    fn jacobian<A: Arithmetic<Constant = Rational>>(
        &self,
        arithmetic: &A,
        here: Values<'_, A::Value>,
    ) -> Option<Vec<A::Value>> {
        let n = self.dimension();
        let dual = Dual { base: arithmetic, directions: n };
        let extended = here.iter().enumerate().map(|(index, value)| {
            if index < n { dual.coordinate(value.clone(), index) } else { Some(dual.fixed(value.clone())) }
        });
        let zero = arithmetic.constant(&Rational::ZERO)?;
        let gradient = |slopes: Vec<A::Value>| if slopes.is_empty() { vec![zero.clone(); n] } else { slopes };
        let next = self.next(&dual, &extended.collect::<Option<Vec<_>>>()?)?;
        Some(next.into_iter().flat_map(|value| gradient(value.gradient)).collect())
    }
}

fn run<A: Arithmetic<Constant = Rational>>(
    arithmetic: &A,
    plan: &Plan,
    here: Values<'_, A::Value>,
) -> Option<Vec<A::Value>> {
    plan.evaluate(arithmetic, |input| input.variable().map(|Variable(k)| here[usize::from(k)].clone()))
        .into_iter()
        .collect()
}
