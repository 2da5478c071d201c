//! Derivatives, substitution, renaming, and a polynomial seen as one in a single variable.

use std::collections::BTreeMap;

use super::{Monomial, Polynomial, Term, Variable};
use crate::rational::Rational;

impl Polynomial {
    /// The partial derivative.
    pub fn derivative(&self, variable: Variable) -> Self {
        let factor = Monomial::variable(variable);
        let mut terms = Vec::new();
        for (monomial, coefficient) in &self.terms {
            // Dividing by the variable keeps the order of the terms that have it.
            if let Some(lowered) = monomial.div(&factor) {
                let exponent = Rational::from(i64::from(monomial.exponent(variable)));
                terms.push((lowered, coefficient * &exponent));
            }
        }
        Self::from_sorted(terms)
    }

    /// The polynomial with `variable` replaced by a number. Forms only the powers that occur.
    pub fn substitute(&self, variable: Variable, value: &Rational) -> Self {
        let mut powers: BTreeMap<u32, Rational> = BTreeMap::new();
        Self::from_terms(self.terms.iter().map(|(monomial, coefficient)| {
            let (power, rest) = monomial.split(|other| other == variable);
            let power =
                powers.entry(power.degree()).or_insert_with_key(|exponent| power_of(value, *exponent));
            (rest, coefficient * power)
        }))
    }

    /// The polynomial with each variable renamed. Variables that get the same name are identified.
    pub fn map_variables(&self, mut rename: impl FnMut(Variable) -> Variable) -> Self {
        Self::from_terms(self.terms.iter().map(|(monomial, coefficient)| {
            let powers = monomial.powers().iter().map(|&(variable, exponent)| (rename(variable), exponent));
            (powers.collect(), coefficient.clone())
        }))
    }

    /// The coefficients cₖ of Σ cₖ `variable`^k, by exponent; none is zero and none contains the variable.
    pub fn coefficients_in(&self, variable: Variable) -> BTreeMap<u32, Self> {
        self.group(|other| other == variable)
            .into_iter()
            .map(|(power, coefficient)| (power.degree(), coefficient))
            .collect()
    }

    /// The polynomial as one in the variables that `belongs` picks, its coefficients polynomials in the
    /// others.
    pub fn group(&self, mut belongs: impl FnMut(Variable) -> bool) -> BTreeMap<Monomial, Self> {
        let mut groups: BTreeMap<Monomial, Vec<Term>> = BTreeMap::new();
        for (monomial, coefficient) in &self.terms {
            let (key, rest) = monomial.split(&mut belongs);
            // Terms with the same key stay sorted when it is divided out.
            groups.entry(key).or_default().push((rest, coefficient.clone()));
        }
        groups.into_iter().map(|(key, terms)| (key, Self::from_sorted(terms))).collect()
    }
}

fn power_of(value: &Rational, exponent: u32) -> Rational {
    let exponent = i32::try_from(exponent).expect("degrees stay below 2^31");
    value.pow(exponent).expect("the exponent is not negative")
}
