//! Names the values of a plan after their formulas, such as `two_eps` and `one_plus_eps_x`. Values
//! with long formulas get numbers. Generated code and listings use the names.

use rustc_hash::FxHashSet;

use kahan_syntax::table::Table;

use crate::plan::{Input, Node, Operation, Plan, descriptions, kind};
use crate::symbols::Symbols;

/// The name of a value in a plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ValueName {
    /// A name that describes the formula.
    Described(String),
    /// A kind such as `sum` or `product`, and a number.
    Numbered(&'static str, usize),
}

/// The distinct names given so far in one plan.
#[derive(Clone, Debug)]
pub struct ValueNames {
    descriptions: Vec<Option<String>>,
    kinds: Vec<&'static str>,
    taken: FxHashSet<String>,
    numbered: Table<&'static str, usize>,
}

impl ValueNames {
    /// Prepares the names of a plan. The list `prepared` has the names of the prepared constants.
    #[must_use]
    pub fn of(plan: &Plan, symbols: &Symbols, prepared: &[String]) -> Self {
        ValueNames {
            descriptions: descriptions(plan, symbols, prepared),
            kinds: (0..plan.operations.len()).map(|index| kind(plan, Node(index))).collect(),
            taken: FxHashSet::default(),
            numbered: Table::new(),
        }
    }

    /// Reserves the names in `taken`, so that no value gets them.
    #[must_use]
    pub fn without(self, taken: impl IntoIterator<Item = String>) -> Self {
        ValueNames { taken: taken.into_iter().collect(), ..self }
    }

    /// Names a value. The value gets a number if its description is in use.
    pub fn name(&mut self, value: Node) -> ValueName {
        self.name_as(value, self.kinds[value.0])
    }

    fn name_as(&mut self, value: Node, what: &'static str) -> ValueName {
        if let Some(text) = self.descriptions[value.0].clone().filter(|text| self.taken.insert(text.clone()))
        {
            return ValueName::Described(text);
        }
        loop {
            let number = self.numbered.or_default(what);
            *number += 1;
            let name = ValueName::Numbered(what, *number);
            if self.taken.insert(name.to_string()) {
                return name;
            }
        }
    }
}

impl std::fmt::Display for ValueName {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            ValueName::Described(text) => f.write_str(text),
            ValueName::Numbered(what, number) => write!(f, "{what}_{number}"),
        }
    }
}

/// Returns distinct names for the prepared constants. ε and parameters keep their names.
#[must_use]
pub fn constant_names(constants: &Plan, symbols: &Symbols) -> Vec<String> {
    let mut names = ValueNames::of(constants, symbols, &[]).without(symbol_names(symbols));
    let name = |output: &Node| match constants.operations[output.0] {
        Operation::Input(Input::Variable(variable)) => symbols.name(variable),
        _ => names.name_as(*output, "constant").to_string(),
    };
    constants.outputs.iter().map(name).collect()
}

pub(super) fn listed_constants(plan: &Plan, symbols: &Symbols, prepared: &[String]) -> Vec<String> {
    let taken = symbol_names(symbols).chain(prepared.iter().cloned());
    let values = ValueNames::of(plan, symbols, &[]).without(taken);
    let place = |value: Node| plan.outputs.iter().position(|output| *output == value);
    listed(plan, symbols, values, |value| place(value).map(|place| prepared[place].clone()))
}

pub(super) fn listed_kernel(
    plan: &Plan,
    symbols: &Symbols,
    prepared: &[String],
    constants: &[String],
) -> Vec<String> {
    let taken = symbol_names(symbols).chain(constants.iter().cloned());
    let values = ValueNames::of(plan, symbols, prepared).without(taken);
    listed(plan, symbols, values, |value| match plan.operations[value.0] {
        Operation::Input(Input::Prepared(place)) => Some(prepared[place].clone()),
        _ => None,
    })
}

fn listed(
    plan: &Plan,
    symbols: &Symbols,
    mut values: ValueNames,
    known: impl Fn(Node) -> Option<String>,
) -> Vec<String> {
    let mut names: Vec<String> = Vec::with_capacity(plan.operations.len());
    for (index, operation) in plan.operations.iter().enumerate() {
        let name = known(Node(index)).unwrap_or_else(|| match *operation {
            Operation::Input(Input::Variable(variable)) => symbols.name(variable),
            Operation::Constant(ref value) if value.is_integer() => value.to_string(),
            Operation::Constant(ref value) => format!("({value})"),
            Operation::Negate(a) if matches!(plan.operations[a.0], Operation::Constant(_)) => {
                format!("(-{})", names[a.0])
            }
            _ => values.name(Node(index)).to_string(),
        });
        names.push(name);
    }
    names
}

fn symbol_names(symbols: &Symbols) -> impl Iterator<Item = String> {
    symbols.states.iter().chain(&symbols.parameters).cloned().chain(["eps".to_owned()])
}
