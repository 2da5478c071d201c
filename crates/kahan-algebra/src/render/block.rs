//! Prints a system as a block of `kahan!`.

use kahan_syntax::syntax::{Header, Reference};

use crate::field::Field;
use crate::plan::Input;
use crate::rational_function::RationalFunction;
use crate::system::{Claim, Condition, System};

use super::claim::claim_text;
use super::formula::Formulas;
use super::notation::Text;

fn used_parameters(system: &System) -> Vec<String> {
    let symbols = &system.field.symbols;
    let is_used = |k: usize| {
        let variable = symbols.parameter(k);
        let in_field = |component: &RationalFunction| component.contains(variable);
        let in_claim = |claim: &Claim| {
            claim.plan.inputs().contains(&Input::Variable(variable))
                || claim.conditions.iter().any(|condition| mentions(condition, &symbols.name(variable)))
        };
        system.field.components.iter().any(in_field) || system.claims.iter().any(in_claim)
    };
    let names = symbols.parameters.iter().enumerate();
    names.filter(|(k, _)| is_used(*k)).map(|(_, name)| name.clone()).collect()
}

fn mentions(condition: &Condition, name: &str) -> bool {
    let mut found = false;
    condition.written.visit_names(&mut |written, _| found |= written == Reference::Name(name));
    found
}

fn claim_names(claim: &Claim, name: &str) -> bool {
    let mut found = claim.conditions.iter().any(|condition| mentions(condition, name));
    for expr in claim.body.expressions() {
        expr.visit_names(&mut |written, _| found |= written == Reference::Name(name));
    }
    found
}

fn header_lines(header: &Header, parameters: &[String]) -> Vec<String> {
    let mut lines = header.attributes.lines.clone();
    let visibility = header.visibility.lines.first().map_or("pub", String::as_str);
    let head = format!("{visibility} struct {}", header.name.text);
    let described = |name: &String| {
        let index = header.parameters.iter().position(|parameter| parameter.text == *name);
        index.map_or(&[][..], |index| &header.described[index].lines)
    };
    if parameters.is_empty() {
        lines.push(format!("{head};"));
    } else if parameters.iter().all(|name| described(name).is_empty()) {
        lines.push(format!("{head} {{ {} }}", parameters.join(", ")));
    } else {
        lines.push(format!("{head} {{"));
        for name in parameters {
            lines.extend(described(name).iter().map(|line| format!("    {line}")));
            lines.push(format!("    {name},"));
        }
        lines.push("}".to_owned());
    }
    lines
}

/// Returns the expanded equations of a field as lines of text.
pub fn equation_lines(field: &Field) -> impl Iterator<Item = String> {
    let right = Formulas { field, map: None, notation: &Text }.field();
    field.symbols.states.iter().zip(right).map(|(state, value)| format!("{state}dot = {value};"))
}

/// Returns the lines of a block. Equations are expanded, and claims are as written.
#[must_use]
pub fn block_lines(system: &System) -> Vec<String> {
    let header = system.header.as_ref();
    let mut lines = header.map_or_else(Vec::new, |header| header_lines(header, &used_parameters(system)));
    let names = system.constants.iter();
    let in_claims = |name: &str| system.claims.iter().any(|claim| claim_names(claim, name));
    for (name, value) in names.filter(|(name, _)| in_claims(name)) {
        lines.push(format!("const {name} = {value};"));
    }
    lines.extend(equation_lines(&system.field));
    lines.extend(system.claims.iter().map(|claim| claim_text(system, claim)));
    lines
}

/// Prints a system as a call of `kahan!`.
#[must_use]
pub fn macro_block(system: &System) -> String {
    let lines: String = block_lines(system).iter().map(|line| format!("    {line}\n")).collect();
    format!("kahan! {{\n{lines}}}")
}
