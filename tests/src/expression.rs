//! Reads formulas of the paper from text, and evaluates them or compares them as polynomials.

use kahan_algebra::arithmetic::{Exact, Function, Functions};
use kahan_algebra::lexer::lex;
use kahan_algebra::plan::Plan;
use kahan_algebra::poly::{Budget, Polynomial};
use kahan_algebra::rational::Rational;
use kahan_algebra::system::System;

use crate::exact::{Q, q};

/// A formula in given variables and `eps`.
#[derive(Clone, Debug)]
pub struct Expression {
    plan: Plan,
}

/// Reads a block without proving its claims. Panics if the block has mistakes.
#[must_use]
pub fn read_unproved(text: &str) -> System {
    let system = kahan_algebra::read_unproved(&lex(text).tokens).system();
    system.unwrap_or_else(|mistakes| panic!("{text}\n{mistakes:?}"))
}

impl Expression {
    /// Reads a formula in these names and `eps`. Panics if the formula is invalid.
    #[must_use]
    pub fn new(names: &[&str], formula: &str) -> Self {
        let equations: String = names.iter().map(|name| format!("{name}dot = 0;\n")).collect();
        let mut system = read_unproved(&format!("{equations}integral the_formula = {formula};"));
        let claim = system.claims.pop().expect("the block has one claim");
        Self { plan: claim.plan }
    }

    /// Evaluates the formula at values of the names and ε. `None` if a divisor is zero.
    #[must_use]
    pub fn at(&self, values: &[Q], eps: &Q) -> Option<Q> {
        let value = |index: usize| values.get(index).unwrap_or(eps).clone();
        let results =
            self.plan.evaluate(&Exact, |input| Some(value(usize::from(input.variable()?.0)).into()));
        results.into_iter().next().flatten().map(|value| value.to_big())
    }

    /// Expands the formula. Panics if it has a divisor.
    #[must_use]
    pub fn polynomial(&self) -> Polynomial {
        let functions = Functions::new(Budget::unlimited());
        let results = self
            .plan
            .evaluate(&functions, |input| Some(Some(Polynomial::variable(input.variable()?).into())));
        match results.into_iter().next().flatten().flatten() {
            Some(Function { numerator, denominator }) if denominator.is_empty() => numerator,
            other => panic!("not a polynomial: {other:?}"),
        }
    }
}

/// Evaluates a polynomial term by term.
#[must_use]
pub fn evaluate(polynomial: &Polynomial, values: &[Q]) -> Q {
    let term = |(monomial, coefficient): (&kahan_algebra::poly::Monomial, &Rational)| {
        monomial.powers().iter().fold(coefficient.to_big(), |product, (variable, exponent)| {
            (0..*exponent).fold(product, |product, _| product * &values[usize::from(variable.0)])
        })
    };
    polynomial.terms().map(term).fold(q(0, 1), |sum, term| sum + term)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_formula_has_the_value_that_it_says() {
        let formula = Expression::new(&["x", "T"], "x^2/(1 - eps*T) - 1/2");
        assert_eq!(formula.at(&[q(3, 1), q(1, 1)], &q(1, 4)), Some(q(23, 2)));
        assert_eq!(formula.at(&[q(3, 1), q(4, 1)], &q(1, 4)), None);
    }

    #[test]
    fn two_spellings_of_a_polynomial_are_one() {
        let names = ["x", "y"];
        let factored = Expression::new(&names, "(x + eps*y)*(x - eps*y)").polynomial();
        let expanded = Expression::new(&names, "x^2 - eps^2*y^2").polynomial();
        assert_eq!(factored, expanded);
        assert_eq!(evaluate(&factored, &[q(3, 1), q(2, 1), q(1, 2)]), q(8, 1));
    }
}
