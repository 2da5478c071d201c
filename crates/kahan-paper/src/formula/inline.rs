//! Substitutes definitions in formulas, and computes symbolic derivatives.

use std::collections::BTreeMap;

use super::derivative::derivative;
use super::{Definition, Formula};

/// The greatest nesting of definitions. Deeper nesting means a cycle.
const MAX_NESTING: usize = 64;

/// Substitutes all definitions, and evaluates all derivatives `d(E, v)`.
pub(crate) fn inline(
    formula: &Formula,
    definitions: &BTreeMap<String, Definition>,
) -> Result<Formula, String> {
    Scope { definitions, locals: BTreeMap::new(), depth: 0 }.inline(formula)
}

struct Scope<'a> {
    definitions: &'a BTreeMap<String, Definition>,
    /// The formulas that replace the parameters of the current definition.
    locals: BTreeMap<String, Formula>,
    depth: usize,
}

impl Scope<'_> {
    fn inline(&self, formula: &Formula) -> Result<Formula, String> {
        if self.depth > MAX_NESTING {
            return Err("a definition uses itself".to_owned());
        }
        match formula.of_parts(&|part| self.inline(part))? {
            Formula::Name(name) => match (self.locals.get(&name), self.definitions.get(&name)) {
                (Some(value), _) => Ok(value.clone()),
                (None, Some(definition)) => self.body(definition, Vec::new()),
                (None, None) => Ok(Formula::Name(name)),
            },
            Formula::Call(name, arguments) => match (self.definitions.get(&name), name.as_str(), &*arguments)
            {
                (Some(definition), ..) => self.body(definition, arguments),
                (None, "d", [of, Formula::Name(variable)]) => derivative(of, variable),
                (None, "d", _) => Err("`d` takes a formula and a free name".to_owned()),
                (None, ..) => Ok(Formula::Call(name, arguments)),
            },
            other => Ok(other),
        }
    }

    fn body(&self, definition: &Definition, arguments: Vec<Formula>) -> Result<Formula, String> {
        let Definition { name, parameters, body } = definition;
        if parameters.len() != arguments.len() {
            return Err(format!(
                "`{name}` takes {} arguments, {} are given",
                parameters.len(),
                arguments.len()
            ));
        }
        let locals = parameters.iter().cloned().zip(arguments).collect();
        Scope { definitions: self.definitions, locals, depth: self.depth + 1 }.inline(body)
    }
}
