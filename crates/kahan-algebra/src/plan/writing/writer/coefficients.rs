//! Replaces sums of constants that multiply a product of states by prepared constants.

use kahan_syntax::rational::Rational;

use crate::poly::{Monomial, Polynomial, Variable};

use super::Writer;
use crate::plan::writing::plan_draft::Signed;

/// At most this many coefficients are gathered, because each new one is compared with all others.
const MOST_GATHERED: usize = 1024;

impl Writer {
    /// Replaces each sum of constants that multiplies a product of states by one prepared constant.
    /// Returns `None` if no sum can be replaced.
    pub(super) fn gather_coefficients(&mut self, polynomial: &Polynomial) -> Option<Polynomial> {
        if !polynomial.terms().any(|(monomial, _)| self.mixes(monomial)) {
            return None;
        }
        let groups = polynomial.group(|variable| self.scaling.ready(variable).is_some());
        let folds = self.scaling.folds;
        let is_sum = |states: &Monomial, coefficient: &Polynomial| {
            coefficient.len() > 1 && !states.is_one() && (folds || coefficient.degree() < 2)
        };
        let sums = groups.iter().filter(|(states, coefficient)| is_sum(states, coefficient)).count();
        if sums == 0 || self.coefficients.len() + sums > MOST_GATHERED {
            return None;
        }
        let mut terms = Vec::new();
        for (states, coefficient) in groups {
            if !is_sum(&states, &coefficient) {
                terms.extend(
                    coefficient.terms().map(|(monomial, value)| (states.mul(monomial), value.clone())),
                );
                continue;
            }
            let (content, sum) = (coefficient.content(), coefficient.primitive_part());
            let variable = self.coefficient(&sum);
            terms.push((states.mul(&Monomial::variable(variable)), content));
        }
        Some(Polynomial::from_terms(terms))
    }

    fn mixes(&self, monomial: &Monomial) -> bool {
        let (mut has_state, mut has_constant) = (false, false);
        for (variable, _) in monomial.powers() {
            let is_state = self.scaling.ready(*variable).is_some();
            has_state |= is_state;
            has_constant |= !is_state;
        }
        has_state && has_constant
    }

    pub(in crate::plan) fn coefficient(&mut self, sum: &Polynomial) -> Variable {
        if let Some(k) = self.coefficients.iter().position(|known| known == sum) {
            return self.scaling.coefficient(k);
        }
        let variable = self.scaling.coefficient(self.coefficients.len());
        let terms = sum.terms().map(|(monomial, value)| (monomial.clone(), value.clone())).collect();
        let written = self.fixed_sum(terms);
        let node = self.draft.node(written);
        self.coefficients.push(sum.clone());
        self.put(variable, node);
        variable
    }

    pub(super) fn fixed_sum(&mut self, terms: Vec<(Monomial, Rational)>) -> Signed {
        let nodes: Vec<Signed> =
            terms.iter().map(|(monomial, coefficient)| self.term(monomial, coefficient, None)).collect();
        self.draft.signed_sum(&nodes)
    }
}
