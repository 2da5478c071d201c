//! Writes polynomials in nested (Horner) form, for most plans. Most steps and claims are written by
//! other code.
//!
//! After every choice of a variable, the remaining terms are examined again. A budget limits the
//! number of examined terms in a plan. Beyond the budget, all variables are factored out at once.

use std::cmp::Reverse;

use kahan_syntax::rational::Rational;
use kahan_syntax::table::sorted_by_key;

use crate::poly::{Monomial, Polynomial, Variable};

use super::{Node, PlanBuilder};

/// Beyond this number of examined terms, variables are not factored out one at a time.
pub(super) const MOST_LOOKED_AT: usize = 1_000_000;

impl PlanBuilder {
    /// Returns the node of a polynomial in nested form. Common factors come first, then v·q + r for
    /// the most frequent variable v. Beyond the budget, the form is Σ vᵢ·qᵢ + r over all variables.
    pub fn polynomial(&mut self, polynomial: &Polynomial) -> Node {
        self.nested(polynomial.clone())
    }

    fn nested(&mut self, polynomial: Polynomial) -> Node {
        if let (1, Some((monomial, coefficient))) = (polynomial.len(), polynomial.leading_term()) {
            return self.term(monomial, coefficient);
        }
        self.looked_at += polynomial.len();
        if polynomial.is_zero() {
            return self.constant(&Rational::ZERO);
        }
        let common = polynomial.monomial_content();
        if !common.is_one() {
            let quotient = polynomial.div_monomial(&common).expect("all terms have it in common");
            let inner = self.nested(quotient);
            return self.times_monomial(inner, &common);
        }
        let content = polynomial.content();
        if !content.is_one() {
            let inverse = content.recip().expect("a content is not zero");
            let inner = self.nested(polynomial.scale(&inverse));
            let factor = self.constant(&content);
            return self.multiply(factor, inner);
        }
        let Some(variable) = most_frequent_variable(&polynomial) else {
            return self.sum_of_terms(&polynomial);
        };
        if self.looked_at > MOST_LOOKED_AT {
            return self.sum_of_products(&polynomial);
        }
        let (quotient, rest) = polynomial.split_at(variable);
        let quotient = self.nested(quotient);
        let input = self.input(variable);
        let product = self.multiply(input, quotient);
        let rest = self.nested(rest);
        self.add(rest, product)
    }

    /// Returns the node of a quotient of two polynomials, each in nested form.
    pub fn quotient(&mut self, above: &Polynomial, below: &Polynomial) -> Node {
        let above = self.polynomial(above);
        let below = self.polynomial(below);
        self.divide(above, below)
    }

    fn term(&mut self, monomial: &Monomial, coefficient: &Rational) -> Node {
        self.looked_at += if monomial.is_one() { 1 } else { 2 };
        let coefficient = self.constant(coefficient);
        self.times_monomial(coefficient, monomial)
    }

    fn times_monomial(&mut self, inner: Node, common: &Monomial) -> Node {
        let mut product: Option<Node> = None;
        for &(variable, exponent) in common.powers() {
            let input = self.input(variable);
            for _ in 0..exponent {
                product = Some(product.map_or(input, |product| self.multiply(product, input)));
            }
        }
        product.map_or(inner, |product| self.multiply(inner, product))
    }

    fn sum_of_products(&mut self, polynomial: &Polynomial) -> Node {
        let (products, rest) = by_frequency(polynomial, |_| true);
        let rest = self.nested(rest);
        products.into_iter().rev().fold(rest, |sum, (variable, quotient)| {
            let quotient = self.nested(quotient);
            let input = self.input(variable);
            let product = self.multiply(input, quotient);
            self.add(sum, product)
        })
    }

    fn sum_of_terms(&mut self, polynomial: &Polynomial) -> Node {
        let mut sum: Option<Node> = None;
        for (monomial, coefficient) in polynomial.terms() {
            let term = self.term(monomial, coefficient);
            sum = Some(sum.map_or(term, |sum| self.add(sum, term)));
        }
        sum.unwrap_or_else(|| self.constant(&Rational::zero()))
    }
}

/// Returns the variable that occurs in the most terms, the last one if there are several. Returns
/// `None` if no variable occurs in two terms.
fn most_frequent_variable(polynomial: &Polynomial) -> Option<Variable> {
    let counts = polynomial.frequencies().into_iter().filter(|&(_, count)| count > 1);
    counts.max_by_key(|&(variable, count)| (count, variable)).map(|(variable, _)| variable)
}

/// Splits the polynomial into products v·q and a remainder. A term with several of the variables v
/// goes to the one that occurs in the most terms.
pub(super) fn by_frequency(
    polynomial: &Polynomial,
    may_be_out: impl Fn(Variable) -> bool,
) -> (Vec<(Variable, Polynomial)>, Polynomial) {
    let counts = polynomial.frequencies().into_iter();
    let counts = counts.filter(|&(variable, count)| count > 1 && may_be_out(variable));
    let counts = sorted_by_key(counts, |&(variable, count)| Reverse((count, variable)));
    let variables: Vec<Variable> = counts.into_iter().map(|(variable, _)| variable).collect();
    let (quotients, rest) = polynomial.split_among(&variables);
    let products = variables.into_iter().zip(quotients).filter(|(_, quotient)| !quotient.is_zero());
    (products.collect(), rest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arithmetic::Exact;

    fn long() -> Polynomial {
        let product =
            |k: u16| Monomial::variable(Variable(k % 3000)).mul(&Monomial::variable(Variable(k / 7)));
        Polynomial::from_terms((0..20_000).map(|k| (product(k), Rational::from(i64::from(k) + 1))))
    }

    #[test]
    fn a_long_polynomial_is_nested_within_the_budget_and_has_its_values() {
        let polynomial = long();
        let mut builder = PlanBuilder::default();
        let node = builder.polynomial(&polynomial);
        assert!(builder.looked_at > MOST_LOOKED_AT, "{}", builder.looked_at);
        assert!(builder.looked_at <= MOST_LOOKED_AT + 5 * polynomial.len(), "{}", builder.looked_at);

        let plan = builder.finish(&[node]);
        assert!(plan.operations.len() <= 4 * polynomial.len(), "{}", plan.operations.len());
        let at = |variable: Variable| Rational::from(i64::from(variable.0 % 11) - 5);
        let value = polynomial.terms().fold(Rational::zero(), |sum, (monomial, coefficient)| {
            let powers = monomial.powers().iter();
            let factors =
                powers.flat_map(|&(variable, power)| std::iter::repeat_n(at(variable), power as usize));
            &sum + &factors.fold(coefficient.clone(), |product, factor| &product * &factor)
        });
        assert_eq!(plan.evaluate(&Exact, |input| input.variable().map(at)), [Some(value)]);
    }
}
