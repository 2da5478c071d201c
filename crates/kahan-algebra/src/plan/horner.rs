//! Polynomials in nested (Horner) form, whatever it costs: for all plans but steps.

use kahan_syntax::rational::Rational;

use crate::poly::{Monomial, Polynomial, Variable};

use super::{Node, PlanBuilder};

impl PlanBuilder {
    /// A polynomial in nested form: content and common monomial first, then v·q + r in the variable
    /// v of most terms.
    pub fn polynomial(&mut self, polynomial: &Polynomial) -> Node {
        if let Some(value) = polynomial.as_constant() {
            return self.constant(&value);
        }
        let common = polynomial.monomial_content();
        if !common.is_one() || polynomial.len() == 1 {
            return self.scaled_by_monomial(polynomial, &common);
        }
        let content = polynomial.content();
        if !content.is_one() {
            let inner = self.polynomial(&polynomial.primitive_part());
            let factor = self.constant(&content);
            return self.multiply(factor, inner);
        }
        let Some(variable) = most_frequent_variable(polynomial) else {
            return self.sum_of_terms(polynomial);
        };
        let (quotient, rest) = polynomial.split_at(variable);
        let quotient = self.polynomial(&quotient);
        let input = self.input(variable);
        let product = self.multiply(input, quotient);
        let rest = self.polynomial(&rest);
        self.add(rest, product)
    }

    /// A quotient of two polynomials, each in nested form.
    pub fn quotient(&mut self, above: &Polynomial, below: &Polynomial) -> Node {
        let above = self.polynomial(above);
        let below = self.polynomial(below);
        self.divide(above, below)
    }

    fn scaled_by_monomial(&mut self, polynomial: &Polynomial, common: &Monomial) -> Node {
        let quotient = polynomial.div_monomial(common).expect("all terms have it in common");
        let inner = self.polynomial(&quotient);
        let mut product: Option<Node> = None;
        for &(variable, exponent) in common.powers() {
            let input = self.input(variable);
            for _ in 0..exponent {
                product = Some(product.map_or(input, |product| self.multiply(product, input)));
            }
        }
        product.map_or(inner, |product| self.multiply(inner, product))
    }

    fn sum_of_terms(&mut self, polynomial: &Polynomial) -> Node {
        let mut sum: Option<Node> = None;
        for (monomial, coefficient) in polynomial.terms() {
            let term = self.polynomial(&Polynomial::from_terms([(monomial.clone(), coefficient.clone())]));
            sum = Some(match sum {
                Some(sum) => self.add(sum, term),
                None => term,
            });
        }
        sum.unwrap_or_else(|| self.constant(&Rational::zero()))
    }
}

/// The variable that most terms contain, the later one of equals; none where no variable is in two
/// terms.
fn most_frequent_variable(polynomial: &Polynomial) -> Option<Variable> {
    let mut counts: Vec<(Variable, usize)> = Vec::new();
    for (variable, _) in polynomial.terms().flat_map(|(monomial, _)| monomial.powers().iter().copied()) {
        match counts.iter_mut().find(|(known, _)| *known == variable) {
            Some((_, count)) => *count += 1,
            None => counts.push((variable, 1)),
        }
    }
    counts
        .into_iter()
        .filter(|&(_, count)| count > 1)
        .max_by_key(|&(variable, count)| (count, variable))
        .map(|(v, _)| v)
}
