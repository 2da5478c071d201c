//! A rational function as an expression of the language of `kahan!`: sign · number · monomial · sum, over the like.
//!
//! Sums stay expanded, low degrees first; what every term shares stands before them, as people write formulas.

use crate::poly::{Monomial, Polynomial, Variable};
use crate::rational::Rational;
use crate::rational_function::RationalFunction;
use crate::symbols::{Symbol, Symbols};
use crate::syntax::{Expr, ExprKind, Factor, Term};
use crate::token::Span;

/// The largest exponent that a claim may have.
const HIGHEST_POWER: u32 = 64;

/// The expression; reading it again gives the same function.
pub(super) fn expression(symbols: &Symbols, function: &RationalFunction) -> Expr {
    if function.is_zero() {
        return number(Rational::zero());
    }
    let above = Parts::of(function.numerator());
    let below = Parts::of(function.denominator());
    // The denominator of a reduced function is not zero, so its content is not.
    let content = above.content.checked_div(&below.content).unwrap_or_default();
    let mut factors = powers(symbols, &above.monomial, false);
    factors.extend(above.sum(symbols).map(|expr| Factor { divides: false, expr }));
    factors.extend(powers(symbols, &below.monomial, true));
    factors.extend(below.sum(symbols).map(|expr| Factor { divides: true, expr }));
    signed(&content, factors)
}

/// content · monomial · rest, where the lowest term of `rest` is positive.
struct Parts {
    content: Rational,
    monomial: Monomial,
    rest: Polynomial,
}

impl Parts {
    fn of(polynomial: &Polynomial) -> Self {
        let monomial = polynomial.monomial_content();
        let rest = polynomial.primitive_part().div_monomial(&monomial).unwrap_or_default();
        let content = polynomial.content();
        if rest.terms().next_back().is_some_and(|(_, coefficient)| coefficient.is_negative()) {
            return Parts { content: -content, monomial, rest: -&rest };
        }
        Parts { content, monomial, rest }
    }

    /// The rest, unless it is 1.
    fn sum(&self, symbols: &Symbols) -> Option<Expr> {
        if self.rest.is_one() {
            return None;
        }
        let mut terms: Vec<(&Monomial, &Rational)> = self.rest.terms().collect();
        terms.sort_by_key(|(monomial, _)| monomial.degree());
        let term = |(monomial, coefficient): (&Monomial, &Rational)| Term {
            negative: coefficient.is_negative(),
            expr: product(&coefficient.abs(), powers(symbols, monomial, false)),
        };
        Some(expr(ExprKind::Sum(terms.into_iter().map(term).collect())))
    }
}

/// The powers of a monomial: parameters and ε before states.
fn powers(symbols: &Symbols, monomial: &Monomial, divides: bool) -> Vec<Factor> {
    let mut powers: Vec<(Variable, u32)> = monomial.powers().to_vec();
    powers.sort_by_key(|&(variable, _)| match symbols.symbol(variable) {
        Symbol::Epsilon => (0, variable),
        Symbol::Parameter(_) => (1, variable),
        Symbol::State(_) | Symbol::SecondState(_) => (2, variable),
    });
    let mut factors = Vec::new();
    for (variable, mut exponent) in powers {
        while exponent > 0 {
            let part = exponent.min(HIGHEST_POWER);
            let base = expr(ExprKind::Name(symbols.name(variable)));
            let power = if part == 1 { base } else { expr(ExprKind::Power(Box::new(base), i64::from(part))) };
            factors.push(Factor { divides, expr: power });
            exponent -= part;
        }
    }
    factors
}

/// A number times factors, its sign in front of everything.
fn signed(content: &Rational, factors: Vec<Factor>) -> Expr {
    let value = product(&content.abs(), factors);
    if content.is_negative() {
        return expr(ExprKind::Sum(vec![Term { negative: true, expr: value }]));
    }
    value
}

/// A positive number times factors; 1 is left out where something else is there, and p/q is p · … / q.
fn product(content: &Rational, factors: Vec<Factor>) -> Expr {
    let mut all = Vec::with_capacity(factors.len() + 2);
    let (above, below) = (Rational::from(content.numerator()), Rational::from(content.denominator()));
    if !above.is_one() || !factors.iter().any(|factor| !factor.divides) {
        all.push(Factor { divides: false, expr: number(above) });
    }
    let (first, last): (Vec<Factor>, Vec<Factor>) = factors.into_iter().partition(|factor| !factor.divides);
    all.extend(first);
    if !below.is_one() {
        all.push(Factor { divides: true, expr: number(below) });
    }
    all.extend(last);
    match <[Factor; 1]>::try_from(all) {
        Ok([single]) => single.expr,
        Err(all) => expr(ExprKind::Product(all)),
    }
}

fn number(value: Rational) -> Expr {
    expr(ExprKind::Number(value))
}

/// An expression that was not written anywhere.
fn expr(kind: ExprKind) -> Expr {
    Expr { kind, span: Span::token(0) }
}
