//! What can be taken out of every term: a rational and a monomial.

use kahan_syntax::rational::Rational;

use super::{Monomial, Polynomial};

impl Polynomial {
    /// The rational c such that self/c is primitive: integer coefficients without a common factor,
    /// the leading one positive. Its sign is that of the leading coefficient; the content of 0 is
    /// 1.
    pub fn content(&self) -> Rational {
        let Some((_, leading)) = self.leading_term() else { return Rational::ONE };
        let mut content = leading.abs();
        for (_, coefficient) in &self.terms {
            content = content.gcd(coefficient);
        }
        if leading.is_negative() { -content } else { content }
    }

    /// self divided by its content: the primitive polynomial with the same zeros. 0 stays 0.
    pub fn primitive_part(&self) -> Self {
        let content = self.content();
        match content.recip() {
            Some(inverse) => self.scale(&inverse),
            None => self.clone(),
        }
    }

    /// The greatest monomial that divides every term; 1 for the zero polynomial.
    pub fn monomial_content(&self) -> Monomial {
        let Some((leading, _)) = self.leading_term() else { return Monomial::one() };
        let mut common = leading.clone();
        for (monomial, _) in &self.terms {
            if common.is_one() {
                break;
            }
            common = common.gcd(monomial);
        }
        common
    }

    /// The quotient by a monomial; `None` where it does not divide every term.
    pub fn div_monomial(&self, divisor: &Monomial) -> Option<Self> {
        if divisor.is_one() {
            return Some(self.clone());
        }
        let mut terms = Vec::with_capacity(self.terms.len());
        for (monomial, coefficient) in &self.terms {
            terms.push((monomial.div(divisor)?, coefficient.clone()));
        }
        Some(Self::from_sorted(terms))
    }
}
