//! Writes formulas as products of factors in the language of `kahan!`.
//!
//! A long factor may have a shorter text Σ dₖ Fᵏ in powers of another polynomial F. F is linear in
//! a variable v, and the coefficients dₖ do not contain v.

mod grouped;
mod powers;
#[cfg(test)]
mod tests;

use kahan_algebra::poly::{Budget, Monomial, Polynomial};
use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Text};
use kahan_algebra::symbols::Symbols;
use kahan_factor::{Factors, factors};

use crate::claims::proved::Formula;

use grouped::grouped;
pub(crate) use powers::in_powers;
use powers::{Scale, by_powers};

const MOST_TERMS: usize = 20_000;
const MOST_WORK: u64 = 20_000_000;

/// The least number of terms of a polynomial that is written in powers of another polynomial.
const FEW_TERMS: usize = 12;

/// The factors 1 + F and 1 − F are multiplied only if each has at least this number of terms.
const LONG_CONJUGATE: usize = 3;

pub(crate) fn state_factors(symbols: &Symbols, polynomial: &Polynomial) -> Vec<Polynomial> {
    let found = factors(polynomial, &mut Budget::new(MOST_TERMS, MOST_WORK)).factors.into_iter();
    found.map(|(factor, _)| factor).filter(|factor| symbols.has_state(factor)).collect()
}

pub(crate) fn factors_of(formulas: &[Formula]) -> Vec<Polynomial> {
    let mut factors: Vec<Polynomial> = Vec::new();
    for factor in formulas.iter().flat_map(|formula| &formula.factors) {
        if !factors.contains(factor) {
            factors.push(factor.clone());
        }
    }
    factors
}

/// Writes the quotient of the products of `above` and `below`. A long factor is written as a
/// polynomial in p if this is shorter, where p is one of `by` or a short factor of `below`.
pub(crate) fn quotient(
    symbols: &Symbols,
    above: &[Polynomial],
    below: &[Polynomial],
    by: &[Polynomial],
) -> String {
    let (mut above, mut below) = (Product::of(above), Product::of(below));
    let own = below.sums.iter().filter_map(|(sum, _)| match sum {
        Sum::Plain(polynomial) if polynomial.len() < FEW_TERMS => Some(polynomial.clone()),
        _ => None,
    });
    let by: Vec<Polynomial> = by.iter().cloned().chain(own).collect();
    above.join_conjugates(symbols);
    below.join_conjugates(symbols);
    above.shorten(symbols, &by);
    below.shorten(symbols, &by);
    let content = above.content.checked_div(&below.content).expect("a denominator is not zero");
    let (front_above, front_below) =
        (above.front.mul(&below.front_below), above.front_below.mul(&below.front));
    let common = front_above.gcd(&front_below);
    let lowest = |monomial: &Monomial| monomial.div(&common).unwrap_or_default();
    let above = product_text(symbols, &content.numerator().into(), &lowest(&front_above), &above.sums);
    let below = product_text(symbols, &content.denominator().into(), &lowest(&front_below), &below.sums);
    if below == "1" {
        return above;
    }
    let above = if is_product(&above) { above } else { format!("({above})") };
    let is_atom = below.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '^') || is_group(&below);
    if is_atom { format!("{above}/{below}") } else { format!("{above}/({below})") }
}

/// A number, times a quotient of monomials `front`/`front_below`, times powers of polynomials.
#[derive(Clone, Debug)]
struct Product {
    content: Rational,
    front: Monomial,
    front_below: Monomial,
    sums: Vec<(Sum, u32)>,
}

#[derive(Clone, Debug, PartialEq)]
enum Sum {
    Plain(Polynomial),
    Written(String),
}

impl Product {
    fn of(polynomials: &[Polynomial]) -> Self {
        let each = || Budget::new(MOST_TERMS, MOST_WORK);
        Self::factored(polynomials, |polynomial| factors(polynomial, &mut each()))
    }

    fn within(polynomials: &[Polynomial], budget: &mut Budget) -> Self {
        Self::factored(polynomials, |polynomial| factors(polynomial, budget))
    }

    fn factored(polynomials: &[Polynomial], mut factored: impl FnMut(&Polynomial) -> Factors) -> Self {
        let mut product = Product {
            content: Rational::one(),
            front: Monomial::one(),
            front_below: Monomial::one(),
            sums: Vec::new(),
        };
        for polynomial in polynomials {
            let found = factored(polynomial);
            product.content = &product.content * &found.content;
            for (factor, exponent) in found.factors {
                product.add_factor(factor, exponent);
            }
        }
        product
    }

    fn add_factor(&mut self, factor: Polynomial, exponent: u32) {
        if let (1, Some((monomial, _))) = (factor.len(), factor.leading_term()) {
            self.front = self.front.mul(&monomial.pow(exponent));
            return;
        }
        let is_negative = begins_negative(&factor);
        let factor = Sum::Plain(if is_negative { -&factor } else { factor });
        if is_negative && exponent % 2 == 1 {
            self.content = -&self.content;
        }
        match self.sums.iter_mut().find(|(known, _)| *known == factor) {
            Some((_, known)) => *known += exponent,
            None => self.sums.push((factor, exponent)),
        }
    }

    /// Multiplies conjugate factors: (1 + εF)(1 − εF) = 1 − ε²F². A long polynomial F is then
    /// written once.
    fn join_conjugates(&mut self, symbols: &Symbols) {
        let conjugate = |polynomial: &Polynomial| {
            let (odd, even): (Vec<_>, Vec<_>) = (polynomial.terms().map(|(m, c)| (m.clone(), c.clone())))
                .partition(|(monomial, _)| monomial.exponent(symbols.epsilon()) % 2 == 1);
            Polynomial::from_terms(even) - Polynomial::from_terms(odd)
        };
        let mut index = 0;
        while index < self.sums.len() {
            let (Sum::Plain(sum), exponent) = &self.sums[index] else { break };
            let (exponent, other) = (*exponent, conjugate(sum));
            let is_other =
                |(known, own): &(Sum, u32)| *known == Sum::Plain(other.clone()) && *own == exponent;
            let place = self.sums[index + 1..].iter().position(is_other).map(|place| place + index + 1);
            if let Some(place) = place.filter(|_| other.len() >= LONG_CONJUGATE) {
                let product = sum * &other;
                self.sums.remove(place);
                self.sums[index].0 = Sum::Plain(product);
            }
            index += 1;
        }
    }

    /// Chooses the shortest text of each factor, which may use powers of a polynomial in `by`.
    fn shorten(&mut self, symbols: &Symbols, by: &[Polynomial]) {
        for (sum, exponent) in &mut self.sums {
            let Sum::Plain(polynomial) = &*sum else { continue };
            let mut best = grouped(symbols, polynomial);
            let mut shortest = best.len();
            let mut scale = None;
            let by = if polynomial.len() < FEW_TERMS { &[] } else { by };
            for base in by.iter().filter(|base| base.len() < polynomial.len()) {
                for variable in base.variables().into_iter().filter(|&v| symbols.is_state(v)) {
                    if let Some((text, own)) = by_powers(symbols, polynomial, base, variable) {
                        // A monomial `front_below` must be written elsewhere in the text, so the
                        // length counts 3/2 times.
                        let len = if own.front_below.is_one() { text.len() } else { text.len() * 3 / 2 };
                        if len < shortest {
                            (best, shortest, scale) = (text, len, Some(own));
                        }
                    }
                }
            }
            if let Some(Scale { content, front, front_below }) = scale {
                self.content =
                    &self.content * &content.pow(*exponent as i32).expect("the exponent is not negative");
                self.front = self.front.mul(&front.pow(*exponent));
                self.front_below = self.front_below.mul(&front_below.pow(*exponent));
            }
            *sum = Sum::Written(best);
        }
    }
}

fn product_text(symbols: &Symbols, content: &Rational, front: &Monomial, sums: &[(Sum, u32)]) -> String {
    let text = |sum: &Sum| match sum {
        Sum::Plain(polynomial) => Text.polynomial(symbols, polynomial),
        Sum::Written(text) => text.clone(),
    };
    if let ([(sum, 1)], true, true) = (sums, front.is_one(), content.is_one()) {
        return text(sum);
    }
    let in_parentheses = |(sum, exponent): &(Sum, u32)| {
        let own = text(sum);
        let is_atom = is_group(&own) || !own.contains([' ', '*', '/', '-']);
        let own = if is_atom { own } else { format!("({own})") };
        Text.power(&own, i64::from(*exponent))
    };
    let mut parts: Vec<String> = sums.iter().map(in_parentheses).collect();
    let front = Text.polynomial(symbols, &Polynomial::term(front.clone(), content.clone()));
    match front.as_str() {
        "1" if !parts.is_empty() => {}
        "-1" if !parts.is_empty() => parts[0].insert(0, '-'),
        _ => parts.insert(0, front),
    }
    parts.join("*")
}

/// Tells whether the first written term is negative. Terms are written by ascending degree.
pub(crate) fn begins_negative(polynomial: &Polynomial) -> bool {
    let lowest = polynomial.terms().map(|(monomial, _)| monomial.degree()).min();
    let first = polynomial.terms().find(|(monomial, _)| Some(monomial.degree()) == lowest);
    first.is_some_and(|(_, coefficient)| coefficient.is_negative())
}

/// Tells whether the text is a product, in which every sum is in parentheses.
pub(crate) fn is_product(text: &str) -> bool {
    let mut depth = 0;
    text.chars().all(|c| {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            ' ' if depth == 0 => return false,
            _ => {}
        }
        true
    })
}

/// Tells whether the text is one sum in parentheses, perhaps with an exponent.
fn is_group(text: &str) -> bool {
    let inner = text.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('^');
    let mut depth = 0;
    let closes_early = |(place, c): (usize, char)| {
        depth += match c {
            '(' => 1,
            ')' => -1,
            _ => 0,
        };
        depth == 0 && place + 1 < inner.len()
    };
    inner.starts_with('(') && inner.ends_with(')') && !inner.char_indices().any(closes_early)
}
