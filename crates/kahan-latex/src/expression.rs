//! Writes products of expressions in LaTeX. Numbers are combined, and divisors stand below a
//! fraction bar.

use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Precedence, at_least, written};
use kahan_algebra::syntax::{Expr, ExprKind, Factor};

use crate::notation::Latex;

/// Writes a product, with numbers combined and divisors below a fraction bar.
pub(crate) fn product(factors: &[Factor]) -> (String, Precedence) {
    let mut coefficient = Rational::from(1);
    let mut sides: [Vec<&Expr>; 2] = [Vec::new(), Vec::new()];
    for factor in factors {
        let mut expr = &factor.expr;
        // The parser reads −a·b as (−a)·b. The sign moves to the front of the product.
        if let ExprKind::Negation(inner) = &expr.kind
            && std::ptr::eq(factor, &factors[0])
        {
            coefficient = -coefficient;
            expr = inner;
        }
        let combined = match &expr.kind {
            ExprKind::Number(value) if factor.divides => coefficient.checked_div(value),
            ExprKind::Number(value) => Some(&coefficient * value),
            _ => None,
        };
        match combined {
            Some(combined) => coefficient = combined,
            None => sides[usize::from(factor.divides)].push(expr),
        }
    }
    let size = if coefficient.is_negative() { -&coefficient } else { coefficient.clone() };
    let (text, level) = if sides[1].is_empty() && size.is_integer() {
        number_times(&size, &sides[0])
    } else {
        let above = number_times(&Rational::from(size.numerator()), &sides[0]).0;
        let below = number_times(&Rational::from(size.denominator()), &sides[1]).0;
        (Latex.quotient(&above, &below), Precedence::Power)
    };
    match coefficient.is_negative() {
        true if level < Precedence::Product => (format!("-{}", parenthesized(&text)), Precedence::Sum),
        true => (format!("-{text}"), Precedence::Sum),
        false => (text, level),
    }
}

/// Writes a number followed by factors; a number 1 is omitted.
fn number_times(number: &Rational, factors: &[&Expr]) -> (String, Precedence) {
    match factors {
        [] => (Latex.number(number), Precedence::Atom),
        [single] if number.is_one() => written(&Latex, single),
        _ => {
            let number = (!number.is_one()).then(|| Latex.number(number));
            let others = factors.iter().map(|factor| at_least(&Latex, factor, Precedence::Power));
            (Latex.product(&number.into_iter().chain(others).collect::<Vec<_>>()), Precedence::Product)
        }
    }
}

pub(crate) fn parenthesized(text: &str) -> String {
    format!("\\left({text}\\right)")
}
