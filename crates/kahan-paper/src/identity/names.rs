//! Collects the names in a relation that need values.

use std::collections::BTreeSet;

use super::super::evaluate::Models;
use super::super::formula::Formula;
use super::Identity;

impl Identity<'_> {
    pub(super) fn names(&self, sides: [&Formula; 2]) -> Vec<String> {
        let mut names = BTreeSet::new();
        sides.iter().for_each(|side| collect_names(side, self.models, &mut names));
        names.extend(self.model.names());
        names.into_iter().filter(|name| !matches!(name.as_str(), "detA" | "detJ" | "pi")).collect()
    }
}

pub(super) fn uses_map(formula: &Formula) -> bool {
    match formula {
        Formula::Name(name) => name == "detJ",
        Formula::Call(name, _) if matches!(name.as_str(), "next" | "back" | "J") => true,
        _ => formula.parts().into_iter().any(uses_map),
    }
}

fn collect_names(formula: &Formula, models: &Models, names: &mut BTreeSet<String>) {
    let mut parts = formula.parts();
    match (formula, parts.first()) {
        (Formula::Name(name), _) => {
            names.insert(name.clone());
        }
        // If the first argument names a system, that system's variables are used.
        (Formula::Call(..), Some(Formula::Name(first))) if models.contains_key(first.as_str()) => {
            names.extend(models[first.as_str()].names());
            parts.remove(0);
        }
        _ => {}
    }
    parts.into_iter().for_each(|part| collect_names(part, models, names));
}
