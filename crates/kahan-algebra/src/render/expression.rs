//! Expressions as they were written.

use kahan_syntax::syntax::{Expr, ExprKind, InFamily, Reference, Term};

use super::notation::{Notation, Text};

/// How tightly an expression binds, for parentheses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// A sum, or a negation.
    Sum,
    /// A product or a quotient.
    Product,
    /// A power, or a call of a function.
    Power,
    /// A name, or an integer.
    Atom,
}

/// An expression as it was written.
#[must_use]
pub fn expression_text(expr: &Expr) -> String {
    write(expr).0
}

fn write(expr: &Expr) -> (String, Level) {
    match &expr.kind {
        ExprKind::Number(value) => {
            let level = if value.is_integer() { Level::Atom } else { Level::Product };
            (value.to_string(), level)
        }
        ExprKind::Name(name) => (name.clone(), Level::Atom),
        ExprKind::Special(InFamily::Site { array, offset }) => {
            (Reference::Site { array, offset: *offset }.to_string(), Level::Atom)
        }
        // −(a·b) is read back as it was written.
        ExprKind::Negation(inner) => (format!("-{}", at_least(inner, Level::Power)), Level::Sum),
        ExprKind::Sum(terms) => (sum_of(terms, at_least), Level::Sum),
        ExprKind::Product(factors) => {
            let mut text = String::new();
            for (index, factor) in factors.iter().enumerate() {
                if index > 0 {
                    text.push(if factor.divides { '/' } else { '*' });
                }
                // A sign at the front needs no parentheses: −a·b is (−a)·b.
                let signed = index == 0 && matches!(factor.expr.kind, ExprKind::Negation(_));
                let level = if signed { Level::Sum } else { Level::Power };
                text.push_str(&at_least(&factor.expr, level));
            }
            (text, Level::Product)
        }
        ExprKind::Special(InFamily::OverSites(inner)) => (format!("sum({})", write(inner).0), Level::Atom),
        ExprKind::Power(base, exponent) => {
            (Text.power(&at_least(base, Level::Atom), *exponent), Level::Power)
        }
    }
}

/// Terms with their signs; `at_least` writes one so that it binds as tightly as it must.
#[must_use]
pub fn sum_of(terms: &[Term], at_least: fn(&Expr, Level) -> String) -> String {
    let mut text = String::new();
    for (index, term) in terms.iter().enumerate() {
        let level = if index == 0 && !term.negative { Level::Sum } else { Level::Product };
        push_term(&mut text, term.negative, &at_least(&term.expr, level));
    }
    text
}

/// Adds a term to the sum that is being written, or subtracts it.
pub fn push_term(sum: &mut String, is_negative: bool, term: &str) {
    sum.push_str(match (sum.is_empty(), is_negative) {
        (true, false) => "",
        (true, true) => "-",
        (false, false) => " + ",
        (false, true) => " - ",
    });
    sum.push_str(term);
}

fn at_least(expr: &Expr, level: Level) -> String {
    let (text, own) = write(expr);
    if own >= level { text } else { format!("({text})") }
}
