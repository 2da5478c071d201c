//! Names for the steps of a plan, by what they compute: `two_eps`, `eps_a1`, `one_plus_eps_x`.
//!
//! They are the names of generated code without its prefixes; what has no short description is numbered.

use std::collections::{BTreeMap, BTreeSet};

use crate::plan::{Node, Operation, Plan, descriptions, kind};
use crate::symbols::Symbols;

/// A name for each step of a plan of prepared constants; literals are their values.
pub(super) fn constant_names(plan: &Plan, symbols: &Symbols) -> Vec<String> {
    names(plan, symbols, &[], &[], true)
}

/// A name for each step of a kernel: none that `constant_names` gave, which `prepared` are among.
pub(super) fn kernel_names(
    plan: &Plan,
    symbols: &Symbols,
    prepared: &[String],
    constant_names: &[String],
) -> Vec<String> {
    names(plan, symbols, prepared, constant_names, false)
}

/// Unique names, none of them a variable's; where the plan `prepares` constants, a result that has no short description is
/// `constant_1`, ….
fn names(
    plan: &Plan,
    symbols: &Symbols,
    prepared: &[String],
    taken: &[String],
    prepares: bool,
) -> Vec<String> {
    let variables = symbols.states.iter().chain(&symbols.parameters).chain(taken);
    let mut taken: BTreeSet<String> = variables.cloned().collect();
    taken.insert("eps".to_owned());
    let mut numbered: BTreeMap<&'static str, usize> = BTreeMap::new();
    let mut names: Vec<String> = Vec::with_capacity(plan.operations.len());
    for (index, description) in descriptions(plan, symbols, prepared).into_iter().enumerate() {
        let operation = &plan.operations[index];
        let name = match *operation {
            Operation::Input(variable) => symbols.name(variable),
            Operation::Prepared(index) => prepared[index].clone(),
            Operation::Constant(ref value) if value.is_integer() => value.to_string(),
            Operation::Constant(ref value) => format!("({value})"),
            Operation::Negate(a) if matches!(plan.operations[a.0], Operation::Constant(_)) => {
                format!("(-{})", names[a.0])
            }
            _ => {
                let text = description.filter(|text| taken.insert(text.clone()));
                text.unwrap_or_else(|| {
                    let is_result = prepares && plan.outputs.contains(&Node(index));
                    let what = if is_result { "constant" } else { kind(plan, Node(index)) };
                    numbered_name(what, &mut numbered, &mut taken)
                })
            }
        };
        names.push(name);
    }
    names
}

fn numbered_name(
    what: &'static str,
    numbered: &mut BTreeMap<&'static str, usize>,
    taken: &mut BTreeSet<String>,
) -> String {
    loop {
        let number = numbered.entry(what).or_default();
        *number += 1;
        let name = format!("{what}_{number}");
        if taken.insert(name.clone()) {
            return name;
        }
    }
}
