//! Describes operations by names such as `two_eps` or `one_plus_eps_x`.

use kahan_syntax::rational::Rational;

use crate::plan::Input;
use crate::plan::step::reciprocals::is_reciprocal;
use crate::symbols::Symbols;

use super::{Node, Operation, Plan};

const MAX_NAME_LENGTH: usize = 24;

/// The kind of the outermost operation in a description.
#[derive(Clone, Copy, PartialEq, Eq)]
enum DescriptionKind {
    Number,
    Product,
    Sum,
}

#[derive(Clone)]
struct Description {
    text: String,
    kind: DescriptionKind,
}

/// Returns a description of each operation that can serve as a name. A description is `None` if it
/// is long, begins with a digit, or describes a quotient other than constant/ε.
#[must_use]
pub(crate) fn descriptions(plan: &Plan, symbols: &Symbols, prepared: &[String]) -> Vec<Option<String>> {
    let mut known: Vec<Option<Description>> = Vec::with_capacity(plan.operations.len());
    for operation in &plan.operations {
        let description = describe(operation, symbols, prepared, |node: Node| known[node.0].as_ref());
        known.push(description.filter(|description| description.text.len() <= MAX_NAME_LENGTH));
    }
    let eps = Operation::Input(Input::Variable(symbols.epsilon()));
    let has_name = |operation: &Operation| match *operation {
        Operation::Divide(_, divisor) => plan.operations[divisor.0] == eps,
        _ => true,
    };
    let named = |(operation, known): (&Operation, Option<Description>)| {
        let text = known.filter(|_| has_name(operation))?.text;
        (!text.starts_with(|first: char| first.is_ascii_digit())).then_some(text)
    };
    plan.operations.iter().zip(known).map(named).collect()
}

/// Returns the kind of an operation without a description. Names of such operations are a kind and
/// a number.
#[must_use]
pub(crate) fn kind(plan: &Plan, node: Node) -> &'static str {
    match plan.operations[node.0] {
        Operation::Multiply(..) => "product",
        Operation::Divide(..) if is_reciprocal(plan, node) => "reciprocal",
        Operation::Divide(..) => "quotient",
        Operation::Negate(_) => "negative",
        Operation::Constant(_) => "constant",
        _ => "sum",
    }
}

fn describe<'a>(
    operation: &Operation,
    symbols: &Symbols,
    prepared: &[String],
    known: impl Fn(Node) -> Option<&'a Description>,
) -> Option<Description> {
    let text = |node: Node| Some(known(node)?.text.as_str());
    let product = |a: Node, b: Node| Some(product(known(a)?, known(b)?));
    let sum = |text: String| Some(Description { text, kind: DescriptionKind::Sum });
    let atom = |text: String| Some(Description { text, kind: DescriptionKind::Product });
    match *operation {
        Operation::Input(Input::Variable(variable)) => atom(symbols.name(variable).replace('\'', "_second")),
        Operation::Input(Input::Prepared(index)) => atom(prepared.get(index)?.clone()),
        Operation::Constant(ref value) => {
            Some(Description { text: number(value)?, kind: DescriptionKind::Number })
        }
        Operation::Negate(a) => sum(format!("minus_{}", text(a)?)),
        Operation::Add(a, b) if a == b => atom(format!("two_{}", text(a)?)),
        Operation::Add(a, b) => sum(format!("{}_plus_{}", text(a)?, text(b)?)),
        Operation::Subtract(a, b) => sum(format!("{}_minus_{}", text(a)?, text(b)?)),
        Operation::Multiply(a, b) => product(a, b),
        Operation::Divide(a, b) => sum(format!("{}_over_{}", text(a)?, text(b)?)),
        Operation::MultiplyAdd(a, b, c) => sum(format!("{}_plus_{}", product(a, b)?.text, text(c)?)),
        Operation::MultiplySubtract(a, b, c) => sum(format!("{}_minus_{}", product(a, b)?.text, text(c)?)),
        Operation::SubtractProduct(a, b, c) => sum(format!("{}_minus_{}", text(a)?, product(b, c)?.text)),
        Operation::Call(function, ..) => match function {},
    }
}

/// Describes a product, such as `two_eps`, `y_times_100`, `x_squared` or `eps_times_one_plus_x`.
fn product(a: &Description, b: &Description) -> Description {
    let (first, second) = if b.kind == DescriptionKind::Number { (b, a) } else { (a, b) };
    let text = if first.kind == DescriptionKind::Number && first.text.contains(|c: char| c.is_ascii_digit()) {
        format!("{}_times_{}", second.text, first.text)
    } else if a.kind == DescriptionKind::Sum || b.kind == DescriptionKind::Sum {
        format!("{}_times_{}", first.text, second.text)
    } else if a.text == b.text {
        format!("{}_squared", a.text)
    } else {
        format!("{}_{}", first.text, second.text)
    };
    Description { text, kind: DescriptionKind::Product }
}

/// Describes a number, such as `half`, `minus_two` or `981_over_100`.
fn number(value: &Rational) -> Option<String> {
    const WORDS: [&str; 11] =
        ["zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"];
    let (numerator, denominator) = value.as_small_ratio()?;
    let size = match (numerator.unsigned_abs(), denominator) {
        (1, 2) => "half".to_owned(),
        (size, 1) => {
            let word = usize::try_from(size).ok().and_then(|size| WORDS.get(size));
            word.map_or_else(|| size.to_string(), |word| (*word).to_owned())
        }
        (size, denominator) => format!("{size}_over_{denominator}"),
    };
    Some(if numerator < 0 { format!("minus_{size}") } else { size })
}
