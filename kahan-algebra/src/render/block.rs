//! A system as a block of `kahan!`, in one canonical layout.

use crate::system::System;

use super::claim::claim_text;
use super::formula::Formulas;
use super::notation::Notation;

/// The block: header, equations as expanded (constants folded in), claims as written.
#[must_use]
pub fn macro_block(system: &System) -> String {
    let mut lines = vec!["kahan! {".to_owned()];
    let parameters = &system.field.symbols.parameters;
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
