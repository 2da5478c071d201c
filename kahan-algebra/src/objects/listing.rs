//! The plan of a step as text, one line a step: what is printed is what is computed, in that order.

use crate::plan::{Node, Operation, Plan, StepPlan};
use crate::symbols::Symbols;

use super::names::names;

/// A step's plan in lines `name = left + right`; a line with a product and a sum is one multiply-add.
///
/// ε stands as `eps`, half the time step; 2ε/D is `reciprocal_1` times a numerator.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StepListing {
    /// What ε and the parameters fix, computed once.
    pub constants: Vec<String>,
    /// From a state to the numerators and reciprocals.
    pub kernel: Vec<String>,
    /// For each component the name of its reciprocal; `None` where it does not divide.
    pub reciprocals: Vec<Option<String>>,
    /// x̃ from x, a line a component.
    pub next: Vec<String>,
}

impl StepListing {
    /// The listing of a step; `symbols` are those of its field.
    #[must_use]
    pub fn of(step: &StepPlan, symbols: &Symbols) -> Self {
        let fixed = names(&step.constants, symbols, &[]);
        let constants: Vec<String> = named(&step.constants, &fixed);
        let prepared: Vec<String> =
            step.constants.outputs.iter().map(|output| fixed[output.0].clone()).collect();
        let named_kernel = names(&step.kernel, symbols, &prepared);
        let name = |node: Node| named_kernel[node.0].as_str();
        let (numerators, quotients) = step.kernel.outputs.split_at(symbols.dimension());
        let reciprocals: Vec<Option<String>> = step
            .reciprocals
            .iter()
            .map(|place| place.map(|index| name(quotients[index]).to_owned()))
            .collect();
        let next = symbols.states.iter().zip(numerators).zip(&reciprocals);
        let next = next.map(|((state, &numerator), reciprocal)| match reciprocal {
            Some(reciprocal) => format!("{state}~ = {state} + {}*{reciprocal}", name(numerator)),
            None => format!("{state}~ = {state} + {}", name(numerator)),
        });
        let next = next.collect();
        StepListing { constants, kernel: named(&step.kernel, &named_kernel), reciprocals, next }
    }
}

/// A line for each step that is computed: inputs and literals stand where they are used.
fn named(plan: &Plan, names: &[String]) -> Vec<String> {
    let is_literal = |node: Node| matches!(plan.operations[node.0], Operation::Constant(_));
    let name = |node: Node| names[node.0].as_str();
    let lines = plan.operations.iter().zip(names).filter_map(|(operation, result)| {
        let right = match *operation {
            Operation::Input(_) | Operation::Constant(_) | Operation::Prepared(_) => return None,
            Operation::Negate(a) if is_literal(a) => return None,
            Operation::Negate(a) => format!("-{}", name(a)),
            Operation::Add(a, b) => format!("{} + {}", name(a), name(b)),
            Operation::Subtract(a, b) => format!("{} - {}", name(a), name(b)),
            Operation::Multiply(a, b) => format!("{}*{}", name(a), name(b)),
            Operation::Divide(a, b) => format!("{}/{}", name(a), name(b)),
            Operation::MultiplyAdd(a, b, c) => format!("{}*{} + {}", name(a), name(b), name(c)),
            Operation::MultiplySubtract(a, b, c) => format!("{}*{} - {}", name(a), name(b), name(c)),
            Operation::SubtractProduct(a, b, c) => format!("{} - {}*{}", name(a), name(b), name(c)),
        };
        Some(format!("{result} = {right}"))
    });
    lines.collect()
}
