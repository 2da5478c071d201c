//! Prints claims as written, and as formulas.

use kahan_syntax::syntax::{ClaimBody, TensorEntry};

use crate::system::{Claim, System};

use super::expression::expression_text;
use super::notation::{Notation, Text};

/// Returns the claim in the language of `kahan!`.
#[must_use]
pub fn claim_text(system: &System, claim: &Claim) -> String {
    let condition = condition_text(system, claim);
    let when = if condition.is_empty() { String::new() } else { format!(" when {condition}") };
    let head = format!("{} {}", claim.kind.keyword(), claim.name.text);
    match &claim.body {
        ClaimBody::Function(expr) => format!("{head} = {}{when};", expression_text(expr)),
        ClaimBody::Recurrence { function, next } => {
            format!("{head} = {} by {}{when};", expression_text(function), expression_text(next))
        }
        ClaimBody::Tensor(entries) => {
            let mut text = format!("{head} {{");
            for entry in entries {
                let value = expression_text(&entry.value);
                text.push_str(&format!(" {{{},{}}} = {value};", entry.row.text, entry.column.text));
            }
            let end = if when.is_empty() { "" } else { ";" };
            format!("{text} }}{when}{end}")
        }
    }
}

/// Returns pairs of a name and a formula: one for a claim, and one for each entry of a bracket. A
/// drift F has a second pair for F(x̃).
#[must_use]
pub fn claim_statement(claim: &Claim, notation: &dyn Notation) -> Vec<(String, String)> {
    match &claim.body {
        ClaimBody::Function(expr) => vec![(notation.name(&claim.name.text), notation.expression(expr))],
        ClaimBody::Recurrence { function, next } => vec![
            (notation.name(&claim.name.text), notation.expression(function)),
            (notation.image(&claim.name.text), notation.expression(next)),
        ],
        ClaimBody::Tensor(entries) => {
            let place = |entry: &TensorEntry| notation.entry(&entry.row.text, &entry.column.text);
            entries.iter().map(|entry| (place(entry), notation.expression(&entry.value))).collect()
        }
    }
}

/// Returns the conditions as text such as `eps = 1, c = -a - b`. The text is empty if there are
/// none.
#[must_use]
pub fn condition_text(system: &System, claim: &Claim) -> String {
    condition_statement(system, claim, &Text)
}

/// Returns the relations after `when`. If one fixes a name to a number, prints `name = number`.
#[must_use]
pub fn condition_statement(system: &System, claim: &Claim, notation: &dyn Notation) -> String {
    let symbols = &system.field.symbols;
    let parts = claim.conditions.iter().map(|condition| {
        let (left, right) = match condition.number() {
            Some(number) => (notation.variable(symbols, condition.variable), notation.number(&number)),
            None => {
                let written = &condition.written;
                (notation.expression(&written.left), notation.expression(&written.right))
            }
        };
        format!("{left} = {right}")
    });
    parts.collect::<Vec<_>>().join(", ")
}

/// Returns the conditions on divisors, such as `a2 != 0`. The text is empty if all divisors are
/// numbers.
#[must_use]
pub fn condition_note(system: &System, claim: &Claim) -> String {
    let nonzero = claim.conditions.iter().flat_map(|condition| &condition.nonzero);
    let texts = nonzero.map(|factor| format!("{} != 0", Text.polynomial(&system.field.symbols, factor)));
    texts.collect::<Vec<_>>().join(", ")
}
