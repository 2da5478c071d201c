//! Names for the steps of a plan as Rust's.

use kahan_algebra::derived::{StepName, StepNames};
use kahan_algebra::plan::{Node, Operation};
use proc_macro2::{Ident, Span};

/// `__t_eps_x` for ε·x, `__c_3` for a constant, `__reciprocal_1`, `__sum_1` for what has no short
/// description.
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
