//! Claims as written, and as statements.

use crate::rational::Rational;
use crate::syntax::{ClaimBody, ClaimKind, Expr, ExprKind, Factor, Reference};
use crate::system::{Claim, System};

use super::notation::Notation;

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
    expr_text(expr, Notation::Text)
}

/// An expression in a notation, with the parentheses it needs.
fn expr_text(expr: &Expr, notation: Notation) -> String {
    write(expr, notation).0
}

fn write(expr: &Expr, notation: Notation) -> (String, Level) {
    match &expr.kind {
        ExprKind::Number(value) => {
            let level = if value.is_integer() { Level::Atom } else { Level::Product };
            (notation.number(value), level)
        }
        ExprKind::Name(name) => (notation.name(name), Level::Atom),
        ExprKind::Site { array, offset } => {
            (notation.name(&Reference::Site { array, offset: *offset }.to_string()), Level::Atom)
        }
        ExprKind::Negation(inner) => {
            // −(a·b) is read back as it was written; in LaTeX nothing reads back.
            let level = if notation == Notation::Text { Level::Power } else { Level::Product };
            (format!("-{}", at_least(inner, level, notation)), Level::Sum)
        }
        ExprKind::Sum(terms) => {
            let mut text = String::new();
            for (index, term) in terms.iter().enumerate() {
                text.push_str(match (index, term.negative) {
                    (0, false) => "",
                    (0, true) => "-",
                    (_, false) => " + ",
                    (_, true) => " - ",
                });
                let level = if index == 0 && !term.negative { Level::Sum } else { Level::Product };
                text.push_str(&at_least(&term.expr, level, notation));
            }
            (text, Level::Sum)
        }
        ExprKind::Product(factors) if notation == Notation::Latex => latex_product(factors),
        ExprKind::Product(factors) => {
            let mut text = String::new();
            for (index, factor) in factors.iter().enumerate() {
                if index > 0 {
                    text.push(if factor.divides { '/' } else { '*' });
                }
                // A sign at the front needs no parentheses: −a·b is (−a)·b.
                let signed = index == 0 && matches!(factor.expr.kind, ExprKind::Negation(_));
                let level = if signed { Level::Sum } else { Level::Power };
                text.push_str(&at_least(&factor.expr, level, notation));
            }
            (text, Level::Product)
        }
        ExprKind::OverSites(inner) => {
            let sum = if notation == Notation::Latex { "\\sum_i " } else { "sum" };
            (format!("{sum}({})", at_least(inner, Level::Sum, notation)), Level::Atom)
        }
        ExprKind::Power(base, exponent) => {
            (notation.power(&at_least(base, Level::Atom, notation), *exponent), Level::Power)
        }
    }
}

/// A product in LaTeX: its numbers as one, what divides below a line, no factor of 1.
fn latex_product(factors: &[Factor]) -> (String, Level) {
    let notation = Notation::Latex;
    let mut coefficient = Rational::from(1);
    let mut sides: [Vec<&Expr>; 2] = [Vec::new(), Vec::new()];
    for factor in factors {
        let mut expr = &factor.expr;
        // A sign at the front is the sign of all: −a·b is (−a)·b.
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
        (notation.quotient(&above, &below), Level::Power)
    };
    match coefficient.is_negative() {
        true if level < Level::Product => (format!("-{}", parenthesized(&text, notation)), Level::Sum),
        true => (format!("-{text}"), Level::Sum),
        false => (text, level),
    }
}

/// A whole number, unless it is 1, and factors behind it.
fn number_times(number: &Rational, factors: &[&Expr]) -> (String, Level) {
    let notation = Notation::Latex;
    match factors {
        [] => (notation.number(number), Level::Atom),
        [single] if number.is_one() => write(single, notation),
        _ => {
            let number = (!number.is_one()).then(|| notation.number(number));
            let written = factors.iter().map(|factor| at_least(factor, Level::Power, notation));
            (notation.product(&number.into_iter().chain(written).collect::<Vec<_>>()), Level::Product)
        }
    }
}

fn at_least(expr: &Expr, level: Level, notation: Notation) -> String {
    let (text, own) = write(expr, notation);
    if own >= level { text } else { parenthesized(&text, notation) }
}

fn parenthesized(text: &str, notation: Notation) -> String {
    match notation {
        Notation::Text => format!("({text})"),
        Notation::Latex => format!("\\left({text}\\right)"),
    }
}

/// The claim in the language of `kahan!`, ready to paste.
#[must_use]
pub fn claim_text(system: &System, claim: &Claim) -> String {
    let condition = condition_text(system, claim);
    let when = if condition.is_empty() { String::new() } else { format!(" when {condition}") };
    let head = format!("{} {}", claim.kind.keyword(), claim.name.text);
    match &claim.body {
        Some(ClaimBody::Function(expr)) => format!("{head} = {}{when};", expr_text(expr, Notation::Text)),
        Some(ClaimBody::Tensor(entries)) => {
            let mut text = format!("{head} {{");
            for entry in entries {
                let value = expr_text(&entry.value, Notation::Text);
                text.push_str(&format!(" {{{},{}}} = {value};", entry.row.text, entry.column.text));
            }
            let end = if when.is_empty() { "" } else { ";" };
            format!("{text} }}{when}{end}")
        }
        None => head,
    }
}

/// The claim as formulas: name (or entry) and value.
#[must_use]
pub fn claim_statement(claim: &Claim, notation: Notation) -> Vec<(String, String)> {
    match &claim.body {
        Some(ClaimBody::Function(expr)) => vec![(notation.name(&claim.name.text), expr_text(expr, notation))],
        Some(ClaimBody::Tensor(entries)) => entries
            .iter()
            .map(|entry| {
                let pair = match notation {
                    Notation::Text => format!("{{{},{}}}", entry.row.text, entry.column.text),
                    Notation::Latex => {
                        format!(
                            "\\{{{},{}\\}}",
                            notation.name(&entry.row.text),
                            notation.name(&entry.column.text)
                        )
                    }
                };
                (pair, expr_text(&entry.value, notation))
            })
            .collect(),
        None => Vec::new(),
    }
}

/// `eps = 1, c = -a - b`; empty for a claim without `when`.
#[must_use]
pub fn condition_text(system: &System, claim: &Claim) -> String {
    condition_statement(system, claim, Notation::Text)
}

/// The relations behind `when`: a name that has a number with it, others as written; empty for a
/// claim without `when`.
#[must_use]
pub fn condition_statement(system: &System, claim: &Claim, notation: Notation) -> String {
    let symbols = &system.field.symbols;
    let parts = claim.conditions.iter().map(|condition| {
        let (left, right) = match condition.number() {
            Some(number) => (notation.variable(symbols, condition.variable), notation.number(&number)),
            None => {
                let written = &condition.written;
                (expr_text(&written.left, notation), expr_text(&written.right, notation))
            }
        };
        format!("{left} = {right}")
    });
    parts.collect::<Vec<_>>().join(", ")
}

/// What the relations of a claim were divided by to be solved, `a2 != 0`: not 0 where it is
/// claimed. Empty where that is numbers alone.
#[must_use]
pub fn condition_note(system: &System, claim: &Claim) -> String {
    let nonzero = claim.conditions.iter().flat_map(|condition| &condition.nonzero);
    let texts =
        nonzero.map(|factor| format!("{} != 0", Notation::Text.polynomial(&system.field.symbols, factor)));
    texts.collect::<Vec<_>>().join(", ")
}

impl ClaimKind {
    /// What such a claim says, in words.
    #[must_use]
    pub fn meaning(self) -> &'static str {
        match self {
            ClaimKind::Integral => "integral of motion: F(x~) = F(x)",
            ClaimKind::Density => "invariant density: rho(x~) det dx~/dx = rho(x)",
            ClaimKind::Bracket => "invariant Poisson tensor: J P(x) J^T = P(x~), Jacobi",
        }
    }
}
