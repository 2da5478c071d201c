//! The interface of notations, and the notation of `kahan!`.

use std::fmt;

use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::{Expr, ExprKind, Factor};
use kahan_syntax::table::sorted_by_key;

use crate::poly::{Monomial, Polynomial, Variable};
use crate::rational_function::RationalFunction;
use crate::symbols::{Symbol, Symbols};

use super::expression::{Precedence, at_least, push_term, written};

/// A notation for formulas. [`Text`] and LaTeX in `kahan-latex` implement it.
pub trait Notation: fmt::Debug {
    /// Writes a name.
    fn name(&self, name: &str) -> String;

    /// Writes the image of a state under the map.
    fn image(&self, name: &str) -> String;

    /// Writes the name of a tensor's entry for two states.
    fn entry(&self, row: &str, column: &str) -> String;

    /// Writes a rational number.
    fn number(&self, value: &Rational) -> String;

    /// Writes a power base^exponent.
    fn power(&self, base: &str, exponent: i64) -> String;

    /// Writes a power base^exponent whose exponent is a formula.
    fn raised(&self, base: &str, exponent: &str) -> String {
        format!("{base}^({exponent})")
    }

    /// Writes a function call. If `function` is empty, writes the argument in parentheses.
    fn call(&self, function: &str, argument: &str) -> String {
        format!("{function}({argument})")
    }

    /// Writes the product of written factors.
    fn product(&self, factors: &[String]) -> String;

    /// Writes the quotient `above/below`. Both may be sums.
    fn quotient(&self, above: &str, below: &str) -> String;

    /// Writes x + 2ε·above/below for the state x called `name`. `above` must not be 0.
    fn moved(&self, symbols: &Symbols, name: &str, above: &Polynomial, below: &Polynomial) -> String;

    /// Writes an expression with the parentheses that it needs.
    fn expression(&self, expr: &Expr) -> String {
        written(self, expr).0
    }

    /// Returns a product with its precedence.
    fn written_product(&self, factors: &[Factor]) -> (String, Precedence) {
        let mut text = String::new();
        for (index, factor) in factors.iter().enumerate() {
            if index > 0 {
                text.push(if factor.divides { '/' } else { '*' });
            }
            // A sign before the first factor needs no parentheses, as in −a·b.
            let signed = index == 0 && matches!(factor.expr.kind, ExprKind::Negation(_));
            text.push_str(&at_least(
                self,
                &factor.expr,
                if signed { Precedence::Sum } else { Precedence::Power },
            ));
        }
        (text, Precedence::Product)
    }

    /// Returns the lowest precedence that needs no parentheses after a sign.
    fn behind_sign(&self) -> Precedence {
        Precedence::Power
    }

    /// Writes the sum of `summand` over all sites of a lattice.
    fn over_sites(&self, summand: &str) -> String {
        format!("sum({summand})")
    }

    /// Writes an expression in parentheses.
    fn parenthesized(&self, text: &str) -> String {
        format!("({text})")
    }

    /// Writes the fraction of two polynomials.
    fn fraction(&self, symbols: &Symbols, above: &Polynomial, below: &Polynomial) -> String {
        self.quotient(&self.polynomial(symbols, above), &self.polynomial(symbols, below))
    }

    /// Writes a rational function in lowest terms.
    fn function(&self, symbols: &Symbols, function: &RationalFunction) -> String {
        match function.as_polynomial() {
            Some(polynomial) => self.polynomial(symbols, polynomial),
            None => self.fraction(symbols, function.numerator(), function.denominator()),
        }
    }

    /// Writes the name of a variable. In a bilinear form Q(x,y), the components of y get a prime.
    fn variable(&self, symbols: &Symbols, variable: Variable) -> String {
        match symbols.symbol(variable) {
            Symbol::SecondState(i) => format!("{}'", self.name(&symbols.states[i])),
            _ => self.name(&symbols.name(variable)),
        }
    }

    /// Writes a polynomial. Terms of low degree come first.
    fn polynomial(&self, symbols: &Symbols, polynomial: &Polynomial) -> String {
        let mut terms: Vec<(&Monomial, &Rational)> = polynomial.terms().collect();
        terms.sort_by_key(|(monomial, _)| monomial.degree());
        let mut text = String::new();
        for (monomial, coefficient) in terms {
            let term = term(self, symbols, monomial, &coefficient.abs());
            push_term(&mut text, coefficient.is_negative(), &term);
        }
        if text.is_empty() { "0".to_owned() } else { text }
    }
}

/// Writes a monomial with a positive coefficient. Numbers, ε and parameters precede states.
fn term<N: Notation + ?Sized>(
    notation: &N,
    symbols: &Symbols,
    monomial: &Monomial,
    coefficient: &Rational,
) -> String {
    let mut factors = Vec::new();
    if !coefficient.is_one() || monomial.is_one() {
        factors.push(notation.number(coefficient));
    }
    let powers = sorted_by_key(monomial.powers(), |&&(variable, _)| match symbols.symbol(variable) {
        Symbol::Epsilon => (0, variable),
        Symbol::Parameter(_) => (1, variable),
        Symbol::State(_) | Symbol::SecondState(_) => (2, variable),
    });
    for &(variable, exponent) in powers {
        factors.push(notation.power(&notation.variable(symbols, variable), i64::from(exponent)));
    }
    notation.product(&factors)
}

/// The language of `kahan!`, with terms like `1/2*x^2`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Text;

impl Notation for Text {
    fn name(&self, name: &str) -> String {
        name.to_owned()
    }

    fn image(&self, name: &str) -> String {
        format!("{name}~")
    }

    fn entry(&self, row: &str, column: &str) -> String {
        format!("{{{row},{column}}}")
    }

    fn number(&self, value: &Rational) -> String {
        value.to_string()
    }

    fn power(&self, base: &str, exponent: i64) -> String {
        if exponent == 1 { base.to_owned() } else { format!("{base}^{exponent}") }
    }

    fn product(&self, factors: &[String]) -> String {
        factors.join("*")
    }

    fn quotient(&self, above: &str, below: &str) -> String {
        format!("{}/{}", parenthesize_sum(above), parenthesize(below))
    }

    fn moved(&self, symbols: &Symbols, name: &str, above: &Polynomial, below: &Polynomial) -> String {
        let increment = parenthesize(&self.polynomial(symbols, above));
        if below.is_one() {
            return format!("{name} + 2*eps*{increment}");
        }
        format!("{name} + 2*eps*{increment}/{}", parenthesize(&self.polynomial(symbols, below)))
    }
}

fn parenthesize(text: &str) -> String {
    if text.contains([' ', '*', '/', '-']) { format!("({text})") } else { text.to_owned() }
}

fn parenthesize_sum(text: &str) -> String {
    if text.contains(' ') { format!("({text})") } else { text.to_owned() }
}
