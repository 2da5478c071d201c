//! A system as a block of `kahan!`, in one canonical layout.

use crate::field::Component;
use crate::system::{Claim, Condition, System};

use super::claim::claim_text;
use super::formula::Formulas;
use super::notation::Notation;

/// The parameters that something still depends on once the equations are expanded.
fn used_parameters(system: &System) -> Vec<String> {
    let symbols = &system.field.symbols;
    let is_used = |k: usize| {
        let variable = symbols.parameter(k);
        let in_field = |c: &Component| c.numerator.contains(variable) || c.denominator.contains(variable);
        let in_claim = |claim: &Claim| {
            claim.plan.inputs().contains(&variable)
                || claim.conditions.iter().any(|condition| mentions(condition, &symbols.name(variable)))
        };
        system.field.components.iter().any(in_field) || system.claims.iter().any(in_claim)
    };
    let names = symbols.parameters.iter().enumerate();
    names.filter(|(k, _)| is_used(*k)).map(|(_, name)| name.clone()).collect()
}

/// Whether a name stands in a relation, or is what it was solved for.
fn mentions(condition: &Condition, name: &str) -> bool {
    let mut found = false;
    condition.written.visit_names(&mut |text, _| found |= text == name);
    found
}

/// The block: header, equations as expanded (constants folded in), claims as written.
#[must_use]
pub fn macro_block(system: &System) -> String {
    let mut lines = vec!["kahan! {".to_owned()];
    let parameters = used_parameters(system);
    if let Some(header) = &system.header {
        let name = &header.name.text;
        lines.push(if parameters.is_empty() {
            format!("    pub struct {name};")
        } else {
            format!("    pub struct {name} {{ {} }}", parameters.join(", "))
        });
    }
    let names = system.constants.iter();
    let in_claims = |name: &str| system.claims.iter().any(|claim| claim_text(system, claim).contains(name));
    for (name, value) in names.filter(|(name, _)| in_claims(name)) {
        lines.push(format!("    const {name} = {value};"));
    }
    let field = Formulas { field: &system.field, map: None, notation: Notation::Text }.field();
    for (state, value) in system.field.symbols.states.iter().zip(field) {
        lines.push(format!("    {state}dot = {value};"));
    }
    lines.extend(system.claims.iter().map(|claim| format!("    {}", claim_text(system, claim))));
    lines.push("}".to_owned());
    lines.join("\n")
}
