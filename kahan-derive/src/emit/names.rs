//! Names for the steps of a plan, by what they compute: `two_eps`, `eps_a1`, `one_plus_eps_x`.

use std::collections::{BTreeMap, BTreeSet};

use kahan_algebra::plan::{Node, Operation, Plan};
use kahan_algebra::rational::Rational;
use kahan_algebra::symbols::Symbols;
use proc_macro2::{Ident, Span};
use quote::format_ident;

use super::items::identifier;

/// Longer descriptions name nothing.
const LONGEST: usize = 24;

/// The names given so far in one function, and what each step could be called.
pub(super) struct Names {
    descriptions: Vec<Option<String>>,
    taken: BTreeSet<String>,
    /// How many steps of each kind have been numbered.
    numbered: BTreeMap<&'static str, usize>,
}

impl Names {
    /// For the steps of a plan; `constants` are the names of its prepared constants.
    pub(super) fn of(plan: &Plan, symbols: &Symbols, constants: &[Ident]) -> Self {
        let mut descriptions: Vec<Option<Description>> = Vec::with_capacity(plan.operations.len());
        for operation in &plan.operations {
            let description = describe(operation, symbols, constants, |node| descriptions[node.0].as_ref());
            descriptions.push(description.filter(|description| description.text.len() <= LONGEST));
        }
        let descriptions = descriptions.into_iter().map(|description| Some(description?.text)).collect();
        Names { descriptions, taken: BTreeSet::new(), numbered: BTreeMap::new() }
    }

    /// `__t_eps_x` for ε·x, `__c_3` for a constant, `__reciprocal_1`, `__sum_1` for what has no short description.
    pub(super) fn binding(&mut self, node: Node, operation: &Operation) -> Ident {
        let prefix = match operation {
            Operation::Constant(_) => "c",
            _ => "t",
        };
        let described = match operation {
            Operation::Divide(..) => None,
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
                let what = match operation {
                    Operation::Multiply(..) => "product",
                    Operation::Divide(..) => "reciprocal",
                    Operation::Negate(_) => "negative",
                    Operation::Constant(_) => "constant",
                    _ => "sum",
                };
                let number = self.numbered.entry(what).or_default();
                *number += 1;
                format_ident!("__{what}_{number}")
            }
        }
    }
}

/// A name for each result of a plan of prepared constants, no two alike.
pub(super) fn constant_names(constants: &Plan, symbols: &Symbols) -> Vec<Ident> {
    let names = Names::of(constants, symbols, &[]);
    let mut taken = BTreeSet::new();
    let mut number = 0;
    let mut name = |output: &Node| {
        if let Some(text) = names.descriptions[output.0].clone().filter(|text| taken.insert(text.clone())) {
            return identifier(&text, Span::call_site());
        }
        loop {
            number += 1;
            let text = format!("constant_{number}");
            if taken.insert(text.clone()) {
                return identifier(&text, Span::call_site());
            }
        }
    };
    constants.outputs.iter().map(&mut name).collect()
}

/// A step in words.
struct Description {
    text: String,
    kind: Kind,
}

/// What a description is to be joined as.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Number,
    Product,
    Sum,
}

/// A step in words, from the words for its operands.
fn describe<'a>(
    operation: &Operation,
    symbols: &Symbols,
    constants: &[Ident],
    known: impl Fn(Node) -> Option<&'a Description>,
) -> Option<Description> {
    let text = |node: Node| Some(known(node)?.text.as_str());
    let product = |a: Node, b: Node| Some(product(known(a)?, known(b)?));
    let sum = |text: String| Some(Description { text, kind: Kind::Sum });
    let atom = |text: String| Some(Description { text, kind: Kind::Product });
    match *operation {
        Operation::Input(variable) => atom(symbols.name(variable).replace('\'', "_second")),
        Operation::Prepared(index) => atom(constants.get(index)?.to_string()),
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
