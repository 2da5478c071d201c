//! Divides polynomials exactly, and finds factors that all terms of a polynomial share.
//!
//! The divisor and the dividend are compared first: their degrees and lowest terms rule out most
//! divisors. Long division then divides the leading terms one after another.

use kahan_syntax::rational::Rational;

use super::arithmetic::merge;
use super::{Budget, Monomial, Polynomial, WithinBudget};

impl Polynomial {
    /// Returns the quotient by `divisor`. Returns `None` if it is not a polynomial, or if `divisor`
    /// is zero.
    pub fn checked_div(&self, divisor: &Self) -> Option<Self> {
        self.div_within(divisor, &mut Budget::unlimited()).ok().flatten()
    }

    /// Divides like [`checked_div`](Self::checked_div), but charges the work to a budget.
    pub fn div_within(&self, divisor: &Self, budget: &mut Budget) -> WithinBudget<Option<Self>> {
        let Some((lead, lead_coefficient)) = divisor.leading_term() else { return Ok(None) };
        let Some(inverse) = lead_coefficient.recip() else { return Ok(None) };
        if lead.is_one() {
            return Ok(Some(self.scale(&inverse)));
        }
        if !self.may_be_divisible_by(divisor) {
            return Ok(None);
        }
        let tail = Self { terms: divisor.terms[1..].to_vec() };
        let mut quotient = Vec::new();
        let mut rest = self.terms.clone();
        while let Some((monomial, coefficient)) = rest.first() {
            let Some(monomial) = monomial.div(lead) else { return Ok(None) };
            let coefficient = coefficient * &inverse;
            budget.charge((rest.len() + tail.len()) as u64 * (coefficient.bits() / 64 + 1))?;
            rest.remove(0);
            rest = merge(rest, tail.mul_term(&monomial, &-&coefficient).terms);
            quotient.push((monomial, coefficient));
            budget.admit(quotient.len())?;
        }
        Ok(Some(Self::from_sorted(quotient)))
    }

    /// Compares degrees and lowest terms. Returns `false` only if `divisor` cannot divide `self`.
    fn may_be_divisible_by(&self, divisor: &Self) -> bool {
        let (Some(low), Some(divisor_low)) = (self.terms.last(), divisor.terms.last()) else { return true };
        divisor_low.0.divides(&low.0)
            && divisor.variables().into_iter().all(|v| divisor.degree_in(v) <= self.degree_in(v))
    }

    /// Returns the rational content c. The polynomial divided by c has coprime integer coefficients
    /// and a positive leading coefficient. The content of 0 is 1.
    pub fn content(&self) -> Rational {
        let Some((_, leading)) = self.leading_term() else { return Rational::ONE };
        let mut content = leading.abs();
        for (_, coefficient) in &self.terms {
            content = content.gcd(coefficient);
        }
        if leading.is_negative() { -content } else { content }
    }

    /// Returns the polynomial divided by its content. The polynomial 0 stays 0.
    pub fn primitive_part(&self) -> Self {
        let content = self.content();
        match content.recip() {
            Some(inverse) => self.scale(&inverse),
            None => self.clone(),
        }
    }

    /// Returns the greatest monomial that divides every term. Returns 1 for the polynomial 0.
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

    /// Returns the quotient by a monomial. Returns `None` unless the monomial divides every term.
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
