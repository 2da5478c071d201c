//! Puts definitions in and carries derivatives out, so that only names, numbers, operators and
//! primitive calls remain.

use std::collections::BTreeMap;

use super::derivative::derivative;
use super::{Definition, Formula};

/// Definitions nest at most this deep; deeper ones go round in a circle.
const DEEPEST: usize = 64;

/// The formula with every definition put in and every `d(E, v)` carried out.
///
/// # Errors
/// A definition that uses itself, a wrong number of arguments, a derivative that cannot be taken.
pub(crate) fn inline(
    formula: &Formula,
    definitions: &BTreeMap<String, Definition>,
) -> Result<Formula, String> {
    Scope { definitions, locals: BTreeMap::new(), depth: 0 }.inline(formula)
}

struct Scope<'a> {
    definitions: &'a BTreeMap<String, Definition>,
    /// The parameters of the definition whose body this is, with what is put in for them (inlined
    /// already).
    locals: BTreeMap<String, Formula>,
    depth: usize,
}

impl Scope<'_> {
    fn inline(&self, formula: &Formula) -> Result<Formula, String> {
        if self.depth > DEEPEST {
            return Err("a definition uses itself".to_owned());
        }
        let each = |parts: &[(bool, Formula)]| {
            parts
                .iter()
                .map(|(mark, part)| Ok((*mark, self.inline(part)?)))
                .collect::<Result<Vec<_>, String>>()
        };
        match formula {
            Formula::Number(_) => Ok(formula.clone()),
            Formula::Name(name) => match (self.locals.get(name), self.definitions.get(name)) {
                (Some(value), _) => Ok(value.clone()),
                (None, Some(definition)) => self.body(definition, Vec::new()),
                (None, None) => Ok(formula.clone()),
            },
            Formula::Sum(terms) => Ok(Formula::Sum(each(terms)?)),
            Formula::Product(factors) => Ok(Formula::Product(each(factors)?)),
            Formula::Negation(inner) => Ok(Formula::Negation(Box::new(self.inline(inner)?))),
            Formula::Power(base, exponent) => {
                Ok(Formula::Power(Box::new(self.inline(base)?), Box::new(self.inline(exponent)?)))
            }
            Formula::Call(name, arguments) => {
                let arguments: Vec<Formula> =
                    arguments.iter().map(|argument| self.inline(argument)).collect::<Result<_, _>>()?;
                if let Some(definition) = self.definitions.get(name) {
                    return self.body(definition, arguments);
                }
                match (name.as_str(), arguments.as_slice()) {
                    ("d", [of, Formula::Name(variable)]) => derivative(of, variable),
                    ("d", _) => Err("`d` takes a formula and a free name".to_owned()),
                    _ => Ok(Formula::Call(name.clone(), arguments)),
                }
            }
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
