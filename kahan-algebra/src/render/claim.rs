//! Claims as written, and as statements.

use crate::syntax::{ClaimBody, ClaimKind, Expr, ExprKind};
use crate::system::{Claim, System};

use super::notation::Notation;

/// How tightly an expression binds, for parentheses.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    Sum,
    Product,
    Power,
    Atom,
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
        ExprKind::Negation(inner) => (format!("-{}", at_least(inner, Level::Power, notation)), Level::Sum),
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
        ExprKind::Product(factors)
            if notation == Notation::Latex && factors.iter().any(|factor| factor.divides) =>
        {
            let side = |divides: bool| -> String {
                let mut chosen: Vec<String> = Vec::new();
                let count = factors.iter().filter(|factor| factor.divides == divides).count();
                for factor in factors.iter().filter(|factor| factor.divides == divides) {
                    let level = if count > 1 { Level::Power } else { Level::Sum };
                    chosen.push(at_least(&factor.expr, level, notation));
                }
                if chosen.is_empty() { "1".to_owned() } else { notation.product(&chosen) }
            };
            (notation.quotient(&side(false), &side(true)), Level::Power)
        }
        ExprKind::Product(factors) => {
            let mut text = String::new();
            for (index, factor) in factors.iter().enumerate() {
                match (index, factor.divides, notation) {
                    (0, ..) => {}
                    (_, true, _) => text.push('/'),
                    (_, false, Notation::Text) => text.push('*'),
                    (_, false, Notation::Latex) => text.push(' '),
                }
                // A sign at the front needs no parentheses: −a·b is (−a)·b.
                let signed = index == 0 && matches!(factor.expr.kind, ExprKind::Negation(_));
                let level = if signed { Level::Sum } else { Level::Power };
                text.push_str(&at_least(&factor.expr, level, notation));
            }
            (text, Level::Product)
        }
        ExprKind::Power(base, exponent) => {
            (notation.power(&at_least(base, Level::Atom, notation), *exponent), Level::Power)
        }
    }
}

fn at_least(expr: &Expr, level: Level, notation: Notation) -> String {
    let (text, own) = write(expr, notation);
    match notation {
        _ if own >= level => text,
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
