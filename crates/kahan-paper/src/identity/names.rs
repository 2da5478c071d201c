//! The names that a relation needs values for.

use std::collections::BTreeSet;

use super::super::evaluate::Models;
use super::super::formula::Formula;
use super::Identity;

impl Identity<'_> {
    /// Every name that needs a value, in order.
    pub(super) fn names(&self, sides: [&Formula; 2]) -> Vec<String> {
        let mut names = BTreeSet::new();
        sides.iter().for_each(|side| collect_names(side, self.models, &mut names));
        names.extend(self.model.names());
        names.into_iter().filter(|name| !matches!(name.as_str(), "detA" | "detJ" | "pi")).collect()
    }
}

pub(super) fn uses_map(formula: &Formula) -> bool {
    match formula {
        Formula::Number(_) => false,
        Formula::Name(name) => name == "detJ",
        Formula::Negation(inner) => uses_map(inner),
        Formula::Sum(parts) | Formula::Product(parts) => parts.iter().any(|(_, part)| uses_map(part)),
        Formula::Power(base, exponent) => uses_map(base) || uses_map(exponent),
        Formula::Call(name, arguments) => {
            matches!(name.as_str(), "next" | "back" | "J") || arguments.iter().any(uses_map)
        }
    }
}

fn collect_names(formula: &Formula, models: &Models, names: &mut BTreeSet<String>) {
    match formula {
        Formula::Number(_) => {}
        Formula::Name(name) => {
            names.insert(name.clone());
        }
        Formula::Negation(inner) => collect_names(inner, models, names),
        Formula::Sum(parts) | Formula::Product(parts) => {
            parts.iter().for_each(|(_, part)| collect_names(part, models, names));
        }
        Formula::Power(base, exponent) => {
            collect_names(base, models, names);
            collect_names(exponent, models, names);
        }
        Formula::Call(_, arguments) => {
            // A first argument that names a system stands for all its variables.
            let system = match arguments.first() {
                Some(Formula::Name(first)) => models.get(first.as_str()),
                _ => None,
            };
            names.extend(system.iter().flat_map(|model| model.names()));
            let rest = &arguments[usize::from(system.is_some())..];
            rest.iter().for_each(|argument| collect_names(argument, models, names));
        }
    }
}
