//! Names for the steps of a plan, by what they compute: `two_eps`, `eps_a1`, `one_plus_eps_x`.

use std::collections::{BTreeMap, BTreeSet};

use kahan_algebra::plan::{Node, Operation, Plan, descriptions, kind};
use kahan_algebra::symbols::Symbols;
use proc_macro2::Ident;
use quote::format_ident;

/// The names given so far in one function, and what each step could be called.
pub(super) struct Names {
    descriptions: Vec<Option<String>>,
    /// The kind of each step.
    kinds: Vec<&'static str>,
    taken: BTreeSet<String>,
    /// How many steps of each kind have been numbered.
    numbered: BTreeMap<&'static str, usize>,
}

impl Names {
    /// For the steps of a plan; `constants` are the names of its prepared constants.
    pub(super) fn of(plan: &Plan, symbols: &Symbols, constants: &[String]) -> Self {
        let descriptions = descriptions(plan, symbols, constants);
        let kinds = (0..plan.operations.len()).map(|index| kind(plan, Node(index))).collect();
        Names { descriptions, kinds, taken: BTreeSet::new(), numbered: BTreeMap::new() }
    }

    /// `__t_eps_x` for ε·x, `__c_3` for a constant, `__reciprocal_1`, `__sum_1` for what has no short description.
    pub(super) fn binding(&mut self, node: Node, operation: &Operation) -> Ident {
        let prefix = match operation {
            Operation::Constant(_) => "c",
            _ => "t",
        };
        let described = match operation {
            Operation::Constant(value) => value.as_small_ratio().map(|(numerator, denominator)| {
                if denominator == 1 { numerator.to_string() } else { format!("{numerator}_{denominator}") }
            }),
            _ => self.descriptions[node.0].clone(),
        };
        // States `x_y`, `z` and `x`, `y_z` have the same product name: the second one is numbered.
        match described
            .map(|text| format!("__{prefix}_{text}"))
            .filter(|name| self.taken.insert(name.clone()))
        {
            Some(name) => format_ident!("{name}"),
            None => {
                let what = self.kinds[node.0];
                let number = self.numbered.entry(what).or_default();
                *number += 1;
                format_ident!("__{what}_{number}")
            }
        }
    }
}

/// A name for each result of a plan of prepared constants, no two alike.
pub(super) fn constant_names(constants: &Plan, symbols: &Symbols) -> Vec<String> {
    let names = Names::of(constants, symbols, &[]);
    let mut taken = BTreeSet::new();
    let mut number = 0;
    let mut name = |output: &Node| {
        if let Some(text) = names.descriptions[output.0].clone().filter(|text| taken.insert(text.clone())) {
            return text;
        }
        loop {
            number += 1;
            let text = format!("constant_{number}");
            if taken.insert(text.clone()) {
                return text;
            }
        }
    };
    constants.outputs.iter().map(&mut name).collect()
}
