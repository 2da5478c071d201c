//! Fields whose coefficients are quotients of polynomials in the parameters and ε.

use kahan_algebra::field::Field;
use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::{Symbol, Symbols};

use crate::maps::map::{ModularMap, Term};
use crate::modular::modulus::Modulus;

/// A field whose terms are grouped by the monomials of the states.
#[derive(Clone, Debug)]
pub struct ParametricField {
    dimension: usize,
    symbols: Symbols,
    divisors: Vec<Polynomial>,
    terms: Vec<FamilyTerm>,
}

#[derive(Clone, Debug)]
struct FamilyTerm {
    component: usize,
    states: Vec<usize>,
    coefficient: Polynomial,
}

impl ParametricField {
    /// Groups the terms of a field by the monomials of its states.
    #[must_use]
    pub fn of(field: &Field) -> Self {
        let mut terms = Vec::new();
        for (component, quotient) in field.components.iter().enumerate() {
            for (monomial, coefficient) in
                quotient.numerator().group(|variable| field.symbols.is_state(variable))
            {
                terms.push(FamilyTerm { component, states: field.states_of(&monomial), coefficient });
            }
        }
        ParametricField {
            dimension: field.dimension(),
            symbols: field.symbols.clone(),
            divisors: field.denominators().cloned().collect(),
            terms,
        }
    }

    /// Returns the number of states n.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Returns the names of the states and parameters.
    #[must_use]
    pub fn symbols(&self) -> &Symbols {
        &self.symbols
    }

    pub(crate) fn depends_on_eps(&self) -> bool {
        let coefficients = self.terms.iter().map(|term| &term.coefficient);
        coefficients.chain(&self.divisors).any(|of| of.contains(self.symbols.epsilon()))
    }

    /// Returns whether the field is defined at ε = 0 for generic parameters.
    pub(crate) fn has_limit_at_eps_zero(&self) -> bool {
        let epsilon = self.symbols.epsilon();
        self.divisors.iter().all(|divisor| !divisor.substitute(epsilon, &Rational::zero()).is_zero())
    }

    /// Returns the map at these parameters and ε, half the time step. Returns `None` if a divisor
    /// vanishes.
    ///
    /// # Panics
    /// If there are fewer values than parameters.
    #[must_use]
    pub fn at(&self, modulus: Modulus, parameters: &[u64], eps: u64) -> Option<ModularMap> {
        let value = |variable: Variable| match self.symbols.symbol(variable) {
            Symbol::Parameter(k) => parameters[k],
            Symbol::Epsilon => eps,
            _ => 0,
        };
        let mut inverses = Vec::with_capacity(self.dimension);
        for divisor in &self.divisors {
            inverses.push(modulus.inverse(evaluate(&modulus, divisor, value)?)?);
        }
        let mut terms = Vec::with_capacity(self.terms.len());
        for term in &self.terms {
            let coefficient = evaluate(&modulus, &term.coefficient, value)?;
            terms.push(Term {
                component: term.component,
                coefficient: modulus.times(coefficient, inverses[term.component]),
                first: term.states.first().copied(),
                second: term.states.get(1).copied(),
            });
        }
        terms.retain(|term| term.coefficient != 0);
        Some(ModularMap::new(modulus, self.dimension, eps, terms))
    }
}

/// Evaluates a polynomial. Returns `None` if the prime divides a denominator of the coefficients.
pub(crate) fn evaluate(
    modulus: &Modulus,
    polynomial: &Polynomial,
    value: impl Fn(Variable) -> u64,
) -> Option<u64> {
    let mut sum = 0;
    for (monomial, coefficient) in polynomial.terms() {
        let mut product = modulus.rational(coefficient)?;
        for &(variable, exponent) in monomial.powers() {
            product = modulus.times(product, modulus.power(value(variable), exponent));
        }
        sum = modulus.plus(sum, product);
    }
    Some(sum)
}
