//! Reuse: a polynomial as multiples of sums that are steps already, and a rest.

use crate::poly::{Monomial, Polynomial};
use crate::rational::Rational;
use crate::table::Table;

use super::super::draft::Signed;
use super::super::nesting::Goal;
use super::Writer;

impl Writer {
    /// The polynomial as multiples of sums that exist already, and a rest; `None` where no multiple
    /// shortens it.
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
            let multiplier = self.write(&multiplier, Goal::Few);
            let node = self.draft.product(&[multiplier.node, sum.node]);
            terms.push(Signed { node, negative: multiplier.negative != sum.negative });
        }
        if !rest.is_zero() {
            terms.push(self.write(&rest, Goal::Few));
        }
        Some(self.draft.signed_sum(&terms))
    }

    /// The sum g and the term m for which P − m·g is shortest, if it is shorter by two terms, or
    /// nothing.
    pub(super) fn best_multiple(&self, polynomial: &Polynomial) -> Option<(usize, Polynomial, Polynomial)> {
        let mut best: Option<(usize, usize, Multiple)> = None;
        for (index, &number) in self.sums.iter().enumerate() {
            let sum = &self.made.items()[number];
            if sum.len() > polynomial.len() {
                continue;
            }
            let least = best.as_ref().map_or(polynomial.len() - 1, |(left, ..)| *left);
            // A multiple of a sum cancels no more terms than the sum has.
            if polynomial.len() - sum.len() >= least {
                continue;
            }
            if let Some((left, multiple)) = shortest_rest(polynomial, sum, least) {
                best = Some((left, index, multiple));
            }
        }
        let (_, index, Multiple { monomial, ratio, .. }) = best?;
        let multiplier = Polynomial::term(monomial, ratio);
        let left = polynomial - &(&multiplier * &self.made.items()[self.sums[index]]);
        Some((index, multiplier, left))
    }
}

/// A term m, and how m·g meets a polynomial.
struct Multiple {
    monomial: Monomial,
    ratio: Rational,
    /// How many terms of m·g the polynomial has.
    equal: usize,
    /// How many monomials of m·g the polynomial has with another coefficient.
    unequal: usize,
}

/// The term m that leaves the fewest terms of P − m·g, if that are fewer than `least`.
fn shortest_rest(polynomial: &Polynomial, sum: &Polynomial, least: usize) -> Option<(usize, Multiple)> {
    let mut multiples: Vec<Multiple> = Vec::new();
    for (monomial, coefficient) in polynomial.terms() {
        for (divisor, scale) in sum.terms() {
            let Some(quotient) = monomial.div(divisor) else { continue };
            let Some(ratio) = coefficient.checked_div(scale) else { continue };
            let mut is_known = false;
            for multiple in multiples.iter_mut().filter(|multiple| multiple.monomial == quotient) {
                if multiple.ratio == ratio {
                    multiple.equal += 1;
                    is_known = true;
                } else {
                    multiple.unequal += 1;
                }
            }
            if !is_known {
                let others = multiples.iter().filter(|multiple| multiple.monomial == quotient);
                let unequal = others.map(|multiple| multiple.equal).sum();
                multiples.push(Multiple { monomial: quotient, ratio, equal: 1, unequal });
            }
        }
    }
    let rest = |multiple: &Multiple| polynomial.len() + sum.len() - 2 * multiple.equal - multiple.unequal;
    let best = multiples.into_iter().filter(|multiple| multiple.equal > 1).min_by_key(rest)?;
    let left = rest(&best);
    (left < least).then_some((left, best))
}
