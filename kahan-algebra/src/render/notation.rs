//! The two notations, and how each writes names, numbers, products, powers and quotients.

use crate::poly::{Monomial, Polynomial, Variable};
use crate::rational::Rational;
use crate::symbols::{Symbol, Symbols};
use crate::table::sorted_by_key;

use super::name::latex_name;

/// How formulas are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notation {
    /// In the language of `kahan!`: `1/2*x^2`.
    Text,
    /// In LaTeX: `\frac{1}{2}x^{2}`.
    Latex,
}

impl Notation {
    /// A name; in LaTeX Greek names become Greek, digits and what stands behind `_` become indices:
    /// `\mu_{1}`, `x_{\mathrm{max}}`.
    #[must_use]
    pub fn name(self, name: &str) -> String {
        if self == Notation::Text {
            return name.to_owned();
        }
        latex_name(name)
    }

    /// The name of a variable; the second copy of a state with a prime.
    #[must_use]
    pub fn variable(self, symbols: &Symbols, variable: Variable) -> String {
        match symbols.symbol(variable) {
            Symbol::SecondState(i) => format!("{}'", self.name(&symbols.states[i])),
            _ => self.name(&symbols.name(variable)),
        }
    }

    /// A rational number.
    #[must_use]
    pub fn number(self, value: &Rational) -> String {
        if self == Notation::Text || value.is_integer() {
            return value.to_string();
        }
        let sign = if value.is_negative() { "-" } else { "" };
        format!("{sign}\\frac{{{}}}{{{}}}", value.numerator().magnitude(), value.denominator())
    }

    /// base^exponent.
    #[must_use]
    pub fn power(self, base: &str, exponent: i64) -> String {
        match (self, exponent) {
            (_, 1) => base.to_owned(),
            (Notation::Text, _) => format!("{base}^{exponent}"),
            (Notation::Latex, _) => format!("{base}^{{{exponent}}}"),
        }
    }

    /// A product of factors that are written already; in LaTeX a point stands before a number that
    /// is not the first.
    #[must_use]
    pub fn product(self, factors: &[String]) -> String {
        if self == Notation::Text {
            return factors.join("*");
        }
        let mut text = String::new();
        for (index, factor) in factors.iter().enumerate() {
            let is_number = factor.starts_with(|c: char| c.is_ascii_digit());
            text.push_str(if index == 0 {
                ""
            } else if is_number {
                " \\cdot "
            } else {
                " "
            });
            text.push_str(factor);
        }
        text
    }

    /// `above/below`, both sums at worst.
    #[must_use]
    pub fn quotient(self, above: &str, below: &str) -> String {
        match self {
            Notation::Text => format!("{}/{}", parenthesize_sum(above), parenthesize(below)),
            Notation::Latex => format!("\\frac{{{above}}}{{{below}}}"),
        }
    }

    /// A polynomial, low degrees first.
    #[must_use]
    pub fn polynomial(self, symbols: &Symbols, polynomial: &Polynomial) -> String {
        let mut terms: Vec<(&Monomial, &Rational)> = polynomial.terms().collect();
        terms.sort_by_key(|(monomial, _)| monomial.degree());
        let mut text = String::new();
        for (monomial, coefficient) in terms {
            let size = if coefficient.is_negative() { -coefficient } else { coefficient.clone() };
            let sign = match (coefficient.is_negative(), text.is_empty()) {
                (true, true) => "-",
                (true, false) => " - ",
                (false, true) => "",
                (false, false) => " + ",
            };
            text.push_str(sign);
            text.push_str(&self.term(symbols, monomial, &size));
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }

    /// A positive multiple of a monomial: numbers, parameters and ε before states.
    fn term(self, symbols: &Symbols, monomial: &Monomial, coefficient: &Rational) -> String {
        let mut factors = Vec::new();
        if !coefficient.is_one() || monomial.is_one() {
            factors.push(self.number(coefficient));
        }
        let powers = sorted_by_key(monomial.powers(), |&&(variable, _)| match symbols.symbol(variable) {
            Symbol::Epsilon => (0, variable),
            Symbol::Parameter(_) => (1, variable),
            Symbol::State(_) | Symbol::SecondState(_) => (2, variable),
        });
        for &(variable, exponent) in powers {
            factors.push(self.power(&self.variable(symbols, variable), i64::from(exponent)));
        }
        self.product(&factors)
    }
}

/// Parentheses around anything but a single name, number or power.
pub(super) fn parenthesize(text: &str) -> String {
    if text.contains([' ', '*', '/', '-']) { format!("({text})") } else { text.to_owned() }
}

/// Parentheses around sums.
pub(super) fn parenthesize_sum(text: &str) -> String {
    if text.contains(' ') { format!("({text})") } else { text.to_owned() }
}
