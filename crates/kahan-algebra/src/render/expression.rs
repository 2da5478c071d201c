//! Prints expressions as written.

use kahan_syntax::syntax::{Expr, ExprKind, FamilySyntax, Reference};

use super::notation::{Notation, Text};

/// The precedence of the outermost operation of an expression. An operand of lower precedence than
/// its operator needs parentheses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Precedence {
    /// A sum or a negation.
    Sum,
    /// A product or a quotient.
    Product,
    /// A power or a function call.
    Power,
    /// A name or an integer.
    Atom,
}

/// Returns the text of an expression as written.
#[must_use]
pub fn expression_text(expr: &Expr) -> String {
    Text.expression(expr)
}

/// Writes an expression in a notation. Returns the text and its precedence.
pub fn written<N: Notation + ?Sized>(notation: &N, expr: &Expr) -> (String, Precedence) {
    match &expr.kind {
        ExprKind::Number(value) => {
            let level = if value.is_integer() { Precedence::Atom } else { Precedence::Product };
            (notation.number(value), level)
        }
        ExprKind::Name(name) => (notation.name(name), Precedence::Atom),
        ExprKind::Special(FamilySyntax::Site { array, offset }) => {
            (notation.name(&Reference::Site { array, offset: *offset }.to_string()), Precedence::Atom)
        }
        ExprKind::Negation(inner) => {
            (format!("-{}", at_least(notation, inner, notation.behind_sign())), Precedence::Sum)
        }
        ExprKind::Sum(terms) => {
            let mut text = String::new();
            for (index, term) in terms.iter().enumerate() {
                let level = if index == 0 && !term.negative { Precedence::Sum } else { Precedence::Product };
                push_term(&mut text, term.negative, &at_least(notation, &term.expr, level));
            }
            (text, Precedence::Sum)
        }
        ExprKind::Product(factors) => notation.written_product(factors),
        ExprKind::Special(FamilySyntax::OverSites(inner)) => {
            (notation.over_sites(&written(notation, inner).0), Precedence::Atom)
        }
        ExprKind::Power(base, exponent) => {
            (notation.power(&at_least(notation, base, Precedence::Atom), *exponent), Precedence::Power)
        }
    }
}

/// Returns an expression in a notation, in parentheses if its precedence is lower than `level`.
pub fn at_least<N: Notation + ?Sized>(notation: &N, expr: &Expr, level: Precedence) -> String {
    let (text, own) = written(notation, expr);
    if own >= level { text } else { notation.parenthesized(&text) }
}

/// Appends a term and its sign to a sum.
pub fn push_term(sum: &mut String, is_negative: bool, term: &str) {
    sum.push_str(match (sum.is_empty(), is_negative) {
        (true, false) => "",
        (true, true) => "-",
        (false, false) => " + ",
        (false, true) => " - ",
    });
    sum.push_str(term);
}
