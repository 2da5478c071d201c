//! Writes a polynomial as multiples of existing sums plus a remainder.

use kahan_syntax::rational::Rational;
use kahan_syntax::table::Table;

use crate::poly::{Monomial, Polynomial, Term};

use super::Writer;
use crate::plan::writing::nesting::FormGoal;
use crate::plan::writing::plan_draft::Signed;

impl Writer {
    /// Writes the polynomial as multiples of existing sums plus a remainder. Returns `None` if no
    /// sum shortens it.
    pub(super) fn write_reusing(&mut self, polynomial: &Polynomial) -> Option<Signed> {
        let mut rest = polynomial.clone();
        let mut multipliers: Table<usize, Polynomial> = Table::new();
        while let Some((sum, multiplier, left)) = self.best_multiple(&rest) {
            let entry = multipliers.or_default(sum);
            *entry = &*entry + &multiplier;
            rest = left;
        }
        if multipliers.is_empty() {
            return None;
        }
        let mut terms = Vec::new();
        for (sum, multiplier) in multipliers {
            let sum = self.steps[self.sums[sum]];
            let multiplier = self.write(&multiplier, FormGoal::Few);
            let node = self.draft.product(&[multiplier.node, sum.node]);
            terms.push(Signed { node, negative: multiplier.negative != sum.negative });
        }
        if !rest.is_zero() {
            terms.push(self.write(&rest, FormGoal::Few));
        }
        Some(self.draft.signed_sum(&terms))
    }

    /// Finds the sum g and the term m with the shortest remainder P − m·g of the polynomial P.
    /// Returns the index of g, the term m and the remainder. The remainder must be shorter by at
    /// least two terms.
    pub(super) fn best_multiple(&self, polynomial: &Polynomial) -> Option<(usize, Polynomial, Polynomial)> {
        let mut best: Option<(usize, KnownMultiple)> = None;
        for (index, &number) in self.sums.iter().enumerate() {
            let sum = &self.made[number];
            if sum.len() > polynomial.len() {
                continue;
            }
            let least = best.as_ref().map_or(polynomial.len() - 1, |(_, best)| best.left);
            if let Some(multiple) = shortest_rest(polynomial, sum, least) {
                best = Some((index, multiple));
            }
        }
        let (index, KnownMultiple { monomial, ratio, .. }) = best?;
        let multiplier = Polynomial::term(monomial, ratio);
        let left = polynomial - &(&multiplier * &self.made[self.sums[index]]);
        Some((index, multiplier, left))
    }
}

struct KnownMultiple {
    monomial: Monomial,
    ratio: Rational,
    left: usize,
}

/// Returns the term m for which P − m·g has the fewest terms, where P = `polynomial` and g = `sum`.
/// Returns `None` if there are never fewer than `least` terms.
fn shortest_rest(polynomial: &Polynomial, sum: &Polynomial, least: usize) -> Option<KnownMultiple> {
    let mut best: Option<KnownMultiple> = None;
    for term in polynomial.as_terms() {
        let mut place = 0;
        loop {
            let below = best.as_ref().map_or(least, |best| best.left);
            let common = (polynomial.len() + sum.len() + 1).saturating_sub(below);
            if common + place > 2 * sum.len() {
                break;
            }
            if let Some(multiple) = multiple_at(polynomial, sum, [term, &sum.as_terms()[place]], common) {
                best = Some(multiple);
            }
            place += 1;
        }
    }
    best
}

/// Returns m, the quotient of a term of P = `polynomial` and a term of g = `sum`. Returns `None`
/// unless P and m·g have at least `common` equal terms.
fn multiple_at(
    polynomial: &Polynomial,
    sum: &Polynomial,
    [(dividend, coefficient), (divisor, scale)]: [&Term; 2],
    common: usize,
) -> Option<KnownMultiple> {
    let monomial = dividend.div(divisor)?;
    let ratio = coefficient.checked_div(scale)?;
    let mut may_miss = sum.len() - common.div_ceil(2);
    let mut terms = polynomial.as_terms();
    let (mut met, mut equal) = (0, 0);
    for (own, scale) in sum.as_terms() {
        let product = monomial.mul(own);
        while let [(first, _), later @ ..] = terms
            && *first > product
        {
            terms = later;
        }
        match terms {
            [(first, coefficient), ..] if *first == product => {
                met += 1;
                equal += usize::from(*coefficient == scale * &ratio);
            }
            _ if may_miss == 0 => return None,
            _ => may_miss -= 1,
        }
    }
    let left = polynomial.len() + sum.len() - met - equal;
    (met + equal >= common).then_some(KnownMultiple { monomial, ratio, left })
}
