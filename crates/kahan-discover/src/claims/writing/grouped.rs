//! Writes sums as sums of products, for example 1 − ε²(b² − ac)(gy + hz)² instead of its seven
//! expanded terms.
//!
//! A sum is split into groups by powers of ε or by a common factor. Each group is written
//! recursively, and the shortest text is chosen.

use std::slice::from_ref;

use kahan_algebra::poly::{Budget, Monomial, Polynomial, Variable};
use kahan_algebra::render::{Notation, Text, push_term};
use kahan_algebra::symbols::Symbols;

use super::{MOST_TERMS, MOST_WORK, Product, Sum, begins_negative, product_text};

const MOST_GROUPED: usize = 400;

const MAX_DEPTH: usize = 4;

pub(super) fn grouped(symbols: &Symbols, polynomial: &Polynomial) -> String {
    let writer = Writer { symbols };
    writer.sum(polynomial, MAX_DEPTH, &mut Budget::new(MOST_TERMS, MOST_WORK / 10))
}

struct Writer<'a> {
    symbols: &'a Symbols,
}

impl Writer<'_> {
    /// Returns the shortest text of a sum in which products are nested at most `depth` deep.
    fn sum(&self, polynomial: &Polynomial, depth: usize, budget: &mut Budget) -> String {
        let expanded = Text.polynomial(self.symbols, polynomial);
        let is_worth_it = depth > 0 && (3..=MOST_GROUPED).contains(&polynomial.len());
        if !is_worth_it || budget.work_left() == 0 {
            return expanded;
        }
        let texts = self
            .groupings(polynomial, budget)
            .into_iter()
            .map(|parts| self.parts(polynomial, parts, depth, budget));
        let texts: Vec<String> = texts.collect();
        [expanded].into_iter().chain(texts).min_by_key(String::len).expect("there is one at least")
    }

    fn groupings(&self, polynomial: &Polynomial, budget: &mut Budget) -> Vec<Vec<Polynomial>> {
        let epsilon = self.symbols.epsilon();
        let powers = polynomial.coefficients_in(epsilon).into_iter().map(|(exponent, part)| {
            (0..exponent).fold(part, |part, _| &part * &Polynomial::variable(epsilon))
        });
        let mut found = vec![powers.collect::<Vec<_>>()];
        found.extend(self.by_factor(polynomial, |variable| self.symbols.is_state(variable), budget));
        found.retain(|parts| parts.len() > 1);
        found
    }

    fn by_factor(
        &self,
        polynomial: &Polynomial,
        belongs: impl Fn(Variable) -> bool,
        budget: &mut Budget,
    ) -> Option<Vec<Polynomial>> {
        let groups: Vec<_> = polynomial.group(belongs).into_iter().collect();
        if groups.len() < 2 {
            return None;
        }
        // Each entry holds a factor, the total number of terms of the coefficients with this
        // factor, and the indices of these coefficients in `groups`.
        let mut factors: Vec<(Polynomial, usize, Vec<usize>)> = Vec::new();
        for (index, (_, coefficient)) in groups.iter().enumerate().filter(|(_, (_, own))| own.len() > 1) {
            if budget.work_left() == 0 {
                return None;
            }
            let found = kahan_factor::factors(coefficient, budget).factors;
            for (factor, _) in found.into_iter().filter(|(factor, _)| factor.len() > 1) {
                match factors.iter_mut().find(|(known, ..)| *known == factor) {
                    Some((_, terms, places)) => {
                        *terms += coefficient.len();
                        places.push(index);
                    }
                    None => factors.push((factor, coefficient.len(), vec![index])),
                }
            }
        }
        let (_, _, places) =
            factors.into_iter().filter(|(.., places)| places.len() > 1).max_by_key(|f| f.1)?;
        let part = |has_it: bool| {
            let own = (0..groups.len()).filter(|index| places.contains(index) == has_it);
            let own = own.map(|index| groups[index].1.mul_monomial(&groups[index].0));
            own.fold(Polynomial::zero(), |sum, term| sum + term)
        };
        Some([part(true), part(false)].into_iter().filter(|part| !part.is_zero()).collect())
    }

    fn parts(
        &self,
        polynomial: &Polynomial,
        mut parts: Vec<Polynomial>,
        depth: usize,
        budget: &mut Budget,
    ) -> String {
        let mut order: Vec<&Monomial> = polynomial.terms().map(|(monomial, _)| monomial).collect();
        order.sort_by_key(|monomial| monomial.degree());
        parts.sort_by_key(|part| {
            order.iter().position(|monomial| part.terms().any(|(own, _)| own == *monomial))
        });
        let mut text = String::new();
        for part in parts {
            let mut product = Product::within(from_ref(&part), budget);
            if let ([], [(Sum::Plain(sum), 1)]) = (product.front.powers(), &product.sums[..])
                && product.content.abs().is_one()
            {
                let sum = if product.content.is_negative() { -sum } else { sum.clone() };
                let own = self.sum(&sum, depth - 1, budget);
                match own.strip_prefix('-') {
                    Some(rest) => push_term(&mut text, true, rest),
                    None => push_term(&mut text, false, &own),
                }
                continue;
            }
            let is_negative = product.content.is_negative();
            for (sum, _) in &mut product.sums {
                if let Sum::Plain(polynomial) = &*sum {
                    debug_assert!(!begins_negative(polynomial));
                    *sum = Sum::Written(self.sum(polynomial, depth - 1, budget));
                }
            }
            let term = product_text(self.symbols, &product.content.abs(), &product.front, &product.sums);
            push_term(&mut text, is_negative, &term);
        }
        text
    }
}
