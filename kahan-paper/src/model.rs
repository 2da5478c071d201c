//! A system of the catalog made ready for the evaluation of formulas: its field and matrices as plans.

use kahan_algebra::arithmetic::{Arithmetic, Dual, solve};
use kahan_algebra::diagnostics::Diagnostics;
use kahan_algebra::kahan::{RationalMap, field_jacobian, scaled_matrix, scaled_rhs};
use kahan_algebra::lexer::lex;
use kahan_algebra::plan::Plan;
use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_algebra::render::Notation;
use kahan_algebra::system::System;
use kahan_algebra::{check, parse};

use kahan_systems::entry::Entry;

/// A system with plans for f, f′, Â, b̂ and the reduced map.
#[derive(Debug)]
pub(super) struct Model {
    pub(super) system: System,
    denominators: Plan,
    field: Plan,
    field_jacobian: Plan,
    matrix: Plan,
    rhs: Plan,
    /// Increments and denominator of x̃ = x + 2ε n/d, where they are small enough.
    reduced: Option<Plan>,
}

/// The values of all variables of a system: states, parameters, ε.
pub(super) type Values<'a, V> = &'a [V];

impl Model {
    /// The model of an entry of the catalog.
    pub(super) fn of_catalog(entry: &'static Entry) -> Self {
        Model::new(entry.command, entry.text())
    }

    /// The model of a block that is known to be right.
    ///
    /// # Panics
    /// If the text holds a mistake.
    pub(super) fn new(name: &'static str, text: &str) -> Self {
        let mut diagnostics = Diagnostics::default();
        let system = check::check(parse::parse(&lex(text).tokens, &mut diagnostics), &mut diagnostics);
        let mistakes = diagnostics.finish();
        assert!(mistakes.is_empty(), "the block of {name}: {mistakes:?}");
        let field = &system.field;
        let reduced = RationalMap::of(field)
            .map(|map| Plan::of(map.reduced.increments.iter().chain([&map.reduced.denominator])));
        Model {
            denominators: Plan::of(field.components.iter().map(|component| &component.denominator)),
            field: Plan::of(field.components.iter().map(|component| &component.numerator)),
            field_jacobian: Plan::of(field_jacobian(field).iter().flatten()),
            matrix: Plan::of(scaled_matrix(field).iter().flatten()),
            rhs: Plan::of(scaled_rhs(field).iter()),
            reduced,
            system,
        }
    }

    /// The number of states.
    pub(super) fn dimension(&self) -> usize {
        self.system.field.dimension()
    }

    /// Whether the map is small enough to be a closed formula.
    pub(super) fn is_expanded(&self) -> bool {
        self.reduced.is_some()
    }

    /// The names of all variables, in the order of [`Values`].
    pub(super) fn names(&self) -> Vec<String> {
        let symbols = &self.system.field.symbols;
        let all = symbols.states.iter().chain(&symbols.parameters).cloned();
        all.chain(["eps".to_owned()]).collect()
    }

    /// `f1 := …; f2 := …;`: the components of the field as definitions.
    pub(super) fn field_definitions(&self) -> String {
        let symbols = &self.system.field.symbols;
        let text = |polynomial: &Polynomial| Notation::Text.polynomial(symbols, polynomial);
        let components = self.system.field.components.iter().enumerate();
        components
            .map(|(index, component)| {
                format!(
                    "f{} := ({})/({});\n",
                    index + 1,
                    text(&component.numerator),
                    text(&component.denominator)
                )
            })
            .collect()
    }

    /// f(x)
    pub(super) fn field<A: Arithmetic>(
        &self,
        arithmetic: &A,
        here: Values<'_, A::Value>,
    ) -> Option<Vec<A::Value>> {
        self.divided(arithmetic, &self.field, here, 1)
    }

    /// f′(x)
    pub(super) fn field_jacobian<A: Arithmetic>(
        &self,
        arithmetic: &A,
        here: Values<'_, A::Value>,
    ) -> Option<Vec<Vec<A::Value>>> {
        Some(self.rows(self.divided(arithmetic, &self.field_jacobian, here, self.dimension())?))
    }

    /// A(x,ε)
    pub(super) fn matrix<A: Arithmetic>(
        &self,
        arithmetic: &A,
        here: Values<'_, A::Value>,
    ) -> Option<Vec<Vec<A::Value>>> {
        Some(self.rows(self.divided(arithmetic, &self.matrix, here, self.dimension())?))
    }

    /// b(x,ε)
    pub(super) fn rhs<A: Arithmetic>(
        &self,
        arithmetic: &A,
        here: Values<'_, A::Value>,
    ) -> Option<Vec<A::Value>> {
        self.divided(arithmetic, &self.rhs, here, 1)
    }

    /// x̃, by the reduced map where there is one, else by elimination.
    pub(super) fn next<A: Arithmetic>(
        &self,
        arithmetic: &A,
        here: Values<'_, A::Value>,
    ) -> Option<Vec<A::Value>> {
        let Some(plan) = &self.reduced else {
            let right: Vec<_> = self.rhs(arithmetic, here)?.into_iter().map(|value| vec![value]).collect();
            let solved = solve(arithmetic, &self.matrix(arithmetic, here)?, &right)?;
            return Some(solved.solution.into_iter().flatten().collect());
        };
        let mut increments = run(arithmetic, plan, here)?;
        let denominator = increments.pop()?;
        let eps = here.last()?;
        let two_eps = arithmetic.add(eps, eps);
        here.iter()
            .zip(&increments)
            .map(|(x, n)| {
                let increment = arithmetic.divide(&arithmetic.multiply(&two_eps, n), &denominator)?;
                Some(arithmetic.add(x, &increment))
            })
            .collect()
    }

    /// ∂x̃/∂x, by dual numbers: no formula for it is presupposed.
    pub(super) fn jacobian<A: Arithmetic>(
        &self,
        arithmetic: &A,
        here: Values<'_, A::Value>,
    ) -> Option<Vec<Vec<A::Value>>> {
        let n = self.dimension();
        let dual = Dual { base: arithmetic, directions: n };
        let lifted = here.iter().enumerate().map(|(index, value)| {
            if index < n { dual.coordinate(value.clone(), index) } else { Some(dual.fixed(value.clone())) }
        });
        let zero = arithmetic.constant(&Rational::ZERO)?;
        let gradient = |slopes: Vec<A::Value>| if slopes.is_empty() { vec![zero.clone(); n] } else { slopes };
        let next = self.next(&dual, &lifted.collect::<Option<Vec<_>>>()?)?;
        Some(next.into_iter().map(|value| gradient(value.gradient)).collect())
    }

    fn rows<V: Clone>(&self, entries: Vec<V>) -> Vec<Vec<V>> {
        entries.chunks(self.dimension()).map(<[V]>::to_vec).collect()
    }

    /// The results of a plan, each `width` of them over the divisor of one equation.
    fn divided<A: Arithmetic>(
        &self,
        arithmetic: &A,
        plan: &Plan,
        here: Values<'_, A::Value>,
        width: usize,
    ) -> Option<Vec<A::Value>> {
        let divisors = run(arithmetic, &self.denominators, here)?;
        let values = run(arithmetic, plan, here)?;
        values
            .iter()
            .enumerate()
            .map(|(index, value)| arithmetic.divide(value, &divisors[index / width]))
            .collect()
    }
}

fn run<A: Arithmetic>(arithmetic: &A, plan: &Plan, here: Values<'_, A::Value>) -> Option<Vec<A::Value>> {
    plan.evaluate(arithmetic, |variable: Variable| here[usize::from(variable.0)].clone())
        .into_iter()
        .collect()
}
