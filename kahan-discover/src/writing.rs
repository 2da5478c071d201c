//! Formulas as text in the language of `kahan!`, in factors.

use kahan_algebra::poly::{Budget, Monomial, Polynomial};
use kahan_algebra::rational::Rational;
use kahan_algebra::render::Notation;
use kahan_algebra::symbols::Symbols;

/// What factoring one polynomial may cost: most take milliseconds, the worst a second.
const MOST_TERMS: usize = 20_000;
const MOST_WORK: u64 = 20_000_000;

/// A product in irreducible factors, as far as they were found.
#[derive(Clone, Debug)]
struct Product {
    content: Rational,
    monomial: Monomial,
    /// Polynomials with the exponents they have here, each with its first term in writing positive.
    factors: Vec<(Polynomial, u32)>,
}

/// The irreducible factors of a polynomial that contain states, each once, as far as they were found in reasonable work.
#[must_use]
pub(crate) fn state_factors(symbols: &Symbols, polynomial: &Polynomial) -> Vec<Polynomial> {
    let factors = polynomial.factors(&mut Budget::new(MOST_TERMS, MOST_WORK)).factors;
    let has_states = |factor: &Polynomial| factor.variables().iter().any(|&v| symbols.is_state(v));
    factors.into_iter().map(|(factor, _)| factor).filter(has_states).collect()
}

/// ∏ above / ∏ below, each in factors.
#[must_use]
pub(crate) fn quotient(symbols: &Symbols, above: &[Polynomial], below: &[Polynomial]) -> String {
    let (mut above, mut below) = (Product::of(above), Product::of(below));
    // One rational number for both, in front of the numerator's integers.
    let content = above.content.checked_div(&below.content).unwrap_or_else(Rational::zero);
    above.content = Rational::from(content.numerator());
    below.content = Rational::from(content.denominator());
    let above = above.text(symbols);
    if below.is_one() {
        return above;
    }
    let below = below.text(symbols);
    let above = if above.contains(' ') && !is_product(&above) { format!("({above})") } else { above };
    let is_atom = below.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '^') || is_group(&below);
    if is_atom { format!("{above}/{below}") } else { format!("{above}/({below})") }
}

/// The polynomial in factors; a sum stands alone, without parentheses.
#[must_use]
pub(crate) fn factored(symbols: &Symbols, polynomial: &Polynomial) -> String {
    Product::of(std::slice::from_ref(polynomial)).text(symbols)
}

/// Whether sums stand in parentheses only.
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

/// Whether the text is one sum in parentheses, perhaps with an exponent.
fn is_group(text: &str) -> bool {
    let inner = text.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('^');
    inner.starts_with('(') && inner.ends_with(')') && !inner[1..inner.len() - 1].contains(['(', ')'])
}

impl Product {
    fn of(polynomials: &[Polynomial]) -> Self {
        let mut product =
            Product { content: Rational::one(), monomial: Monomial::one(), factors: Vec::new() };
        for polynomial in polynomials {
            let found = polynomial.factors(&mut Budget::new(MOST_TERMS, MOST_WORK));
            product.content = &product.content * &found.content;
            for (factor, exponent) in found.factors {
                product.take(factor, exponent);
            }
        }
        product
    }

    fn take(&mut self, factor: Polynomial, exponent: u32) {
        if let [(monomial, _)] = &factor.terms().collect::<Vec<_>>()[..] {
            self.monomial = self.monomial.mul(&monomial.pow(exponent));
            return;
        }
        // Formulas are written with low degrees first, in the order of terms within a degree.
        let lowest = factor.terms().map(|(monomial, _)| monomial.degree()).min();
        let first = factor.terms().find(|(monomial, _)| Some(monomial.degree()) == lowest);
        let is_negative = first.is_some_and(|(_, coefficient)| coefficient.is_negative());
        let factor = if is_negative { -&factor } else { factor };
        if is_negative && exponent % 2 == 1 {
            self.content = -&self.content;
        }
        match self.factors.iter_mut().find(|(known, _)| *known == factor) {
            Some((_, known)) => *known += exponent,
            None => self.factors.push((factor, exponent)),
        }
    }

    fn is_one(&self) -> bool {
        self.content.is_one() && self.monomial.is_one() && self.factors.is_empty()
    }

    fn text(&self, symbols: &Symbols) -> String {
        let alone = self.monomial.is_one() && self.content.is_one();
        if let ([(sum, 1)], true) = (&self.factors[..], alone) {
            return Notation::Text.polynomial(symbols, sum);
        }
        let sums = self.factors.iter().map(|(sum, exponent)| {
            let text = format!("({})", Notation::Text.polynomial(symbols, sum));
            Notation::Text.power(&text, i64::from(*exponent))
        });
        let term = Polynomial::term(self.monomial.clone(), self.content.clone());
        let front = Notation::Text.polynomial(symbols, &term);
        let mut parts: Vec<String> = sums.collect();
        match front.as_str() {
            "1" if !parts.is_empty() => {}
            "-1" if !parts.is_empty() => parts[0].insert(0, '-'),
            _ => parts.insert(0, front),
        }
        parts.join("*")
    }
}
