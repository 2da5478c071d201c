//! Names for the steps of a plan, by what they compute: `two_eps`, `eps_a1`, `one_plus_eps_x`.
//!
//! They are the names of generated code without its prefixes; what has no short description is numbered.

use std::collections::{BTreeMap, BTreeSet};

use crate::plan::{Node, Operation, Plan};
use crate::rational::Rational;
use crate::symbols::Symbols;

/// Longer descriptions name nothing.
const LONGEST: usize = 24;

/// What a description is to be joined as.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Number,
    Product,
    Sum,
}

/// A step in words.
#[derive(Clone)]
struct Description {
    text: String,
    kind: Kind,
}

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
                let text = description
                    .filter(|_| !matches!(operation, Operation::Divide(..)))
                    .filter(|text| taken.insert(text.clone()));
                text.unwrap_or_else(|| {
                    let what = match operation {
                        _ if prepares && plan.outputs.contains(&Node(index)) => "constant",
                        Operation::Multiply(..) => "product",
                        Operation::Divide(..) => "reciprocal",
                        Operation::Negate(_) => "negative",
                        _ => "sum",
                    };
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

fn descriptions(plan: &Plan, symbols: &Symbols, prepared: &[String]) -> Vec<Option<String>> {
    let mut known: Vec<Option<Description>> = Vec::with_capacity(plan.operations.len());
    for operation in &plan.operations {
        let description = describe(operation, symbols, prepared, |node: Node| known[node.0].as_ref());
        known.push(description.filter(|description| description.text.len() <= LONGEST));
    }
    known.into_iter().map(|description| Some(description?.text)).collect()
}

/// A step in words, from the words for its operands.
fn describe<'a>(
    operation: &Operation,
    symbols: &Symbols,
    prepared: &[String],
    known: impl Fn(Node) -> Option<&'a Description>,
) -> Option<Description> {
    let text = |node: Node| Some(known(node)?.text.as_str());
    let product = |a: Node, b: Node| Some(product(known(a)?, known(b)?));
    let sum = |text: String| Some(Description { text, kind: Kind::Sum });
    let atom = |text: String| Some(Description { text, kind: Kind::Product });
    match *operation {
        Operation::Input(variable) => atom(symbols.name(variable).replace('\'', "_second")),
        Operation::Prepared(index) => atom(prepared.get(index)?.clone()),
        Operation::Constant(ref value) => Some(Description { text: number(value)?, kind: Kind::Number }),
        Operation::Negate(a) => sum(format!("minus_{}", text(a)?)),
        Operation::Add(a, b) if a == b => atom(format!("two_{}", text(a)?)),
        Operation::Add(a, b) => sum(format!("{}_plus_{}", text(a)?, text(b)?)),
        Operation::Subtract(a, b) => sum(format!("{}_minus_{}", text(a)?, text(b)?)),
        Operation::Multiply(a, b) => product(a, b),
        Operation::Divide(a, b) => sum(format!("{}_over_{}", text(a)?, text(b)?)),
        Operation::MultiplyAdd(a, b, c) => sum(format!("{}_plus_{}", product(a, b)?.text, text(c)?)),
        Operation::MultiplySubtract(a, b, c) => sum(format!("{}_minus_{}", product(a, b)?.text, text(c)?)),
        Operation::SubtractProduct(a, b, c) => sum(format!("{}_minus_{}", text(a)?, product(b, c)?.text)),
    }
}

/// `two_eps` for 2·ε and ε·2, `x_squared`, `eps_x`, `eps_times_one_plus_x`.
fn product(a: &Description, b: &Description) -> Description {
    let (first, second) = if b.kind == Kind::Number { (b, a) } else { (a, b) };
    let text = if a.kind == Kind::Sum || b.kind == Kind::Sum {
        format!("{}_times_{}", first.text, second.text)
    } else if a.text == b.text {
        format!("{}_squared", a.text)
    } else {
        format!("{}_{}", first.text, second.text)
    };
    Description { text, kind: Kind::Product }
}

fn number(value: &Rational) -> Option<String> {
    const WORDS: [&str; 11] =
        ["zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"];
    match value.as_small_ratio()? {
        (1, 2) => Some("half".to_owned()),
        (size, 1) => {
            let word = usize::try_from(size).ok().and_then(|size| WORDS.get(size));
            Some(word.map_or_else(|| format!("n{size}"), |word| (*word).to_owned()))
        }
        (numerator, denominator) => Some(format!("n{numerator}_{denominator}")),
    }
}
