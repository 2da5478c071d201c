//! Names for the steps of a plan as Rust's.

use kahan_algebra::derived::{self, StepName, StepNames};
use kahan_algebra::plan::{Node, Operation, Plan};
use kahan_algebra::symbols::Symbols;
use proc_macro2::{Ident, Span};

use super::items::identifier;

/// `__t_eps_x` for ε·x, `__c_3` for a constant, `__reciprocal_1`, `__sum_1` for what has no short description.
pub(super) fn binding(names: &mut StepNames, node: Node, operation: &Operation) -> Ident {
    let ratio = match operation {
        Operation::Constant(value) => value.as_small_ratio(),
        _ => None,
    };
    let name = match ratio {
        Some((numerator, 1)) => format!("__c_{numerator}"),
        Some((numerator, denominator)) => format!("__c_{numerator}_{denominator}"),
        None => match names.name(node) {
            StepName::Described(text) => format!("__t_{text}"),
            StepName::Numbered(what, number) => format!("__{what}_{number}"),
        },
    };
    Ident::new(&name, Span::call_site())
}

/// A name for each result of a plan of prepared constants, no two alike.
pub(super) fn constant_names(constants: &Plan, symbols: &Symbols) -> Vec<Ident> {
    let names = derived::constant_names(constants, symbols);
    names.iter().map(|name| identifier(name, Span::call_site())).collect()
}
