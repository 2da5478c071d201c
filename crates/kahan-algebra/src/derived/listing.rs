//! Prints the plan of a step as text.

use crate::plan::{Node, Operation, Plan, StepPlan};
use crate::symbols::Symbols;

use super::names::{constant_names, listed_constants, listed_kernel};

/// The plan of a step as lines `name = left + right`. A line such as `a = b*c + d` is one
/// multiply-add.
///
/// The name `eps` means half the time step. Names `reciprocal_1`, `reciprocal_2` and so on mean a
/// power of two divided by a denominator.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StepListing {
    /// The names and formulas of prepared constants. A name without a formula is ε or a parameter.
    pub constants: Vec<String>,
    /// The operations that compute numerators and reciprocals.
    pub kernel: Vec<String>,
    /// The name of the reciprocal that multiplies each numerator; `None` without a reciprocal.
    pub reciprocals: Vec<Option<String>>,
    /// The formulas of x̃ by component.
    pub next: Vec<String>,
    /// The largest tested ‖εf′‖∞ at which the step is accurate; 0 if no tested one is.
    pub holds_to: u32,
}

impl StepListing {
    /// Prints the plan of a step of a field with these symbols.
    #[must_use]
    pub fn of(step: &StepPlan, symbols: &Symbols) -> Self {
        let plan = &step.kernel.plan;
        let prepared = constant_names(&step.constants, symbols);
        let fixed = listed_constants(&step.constants, symbols, &prepared);
        let named = listed_kernel(plan, symbols, &prepared, &fixed);
        let name = |node: Node| named[node.0].as_str();
        let mut hidden = vec![false; plan.operations.len()];
        let (mut reciprocals, mut next) = (Vec::new(), Vec::new());
        let uses = plan.uses();
        for (state, (&numerator, reciprocal)) in symbols.states.iter().zip(step.kernel.factors(&plan.outputs))
        {
            let reciprocal = reciprocal.map(|node| name(*node).to_owned());
            let (sign, numerator) = match plan.operations[numerator.0] {
                Operation::Negate(inner) => {
                    // If only the formula of x̃ uses a negation, the formula subtracts instead.
                    hidden[numerator.0] = uses[numerator.0] == 1;
                    ('-', inner)
                }
                _ => ('+', numerator),
            };
            let is_still =
                matches!(&plan.operations[numerator.0], Operation::Constant(value) if value.is_zero());
            let numerator = name(numerator);
            next.push(match &reciprocal {
                Some(reciprocal) => format!("{state}~ = {state} {sign} {numerator}*{reciprocal}"),
                None if is_still => format!("{state}~ = {state}"),
                None => format!("{state}~ = {state} {sign} {numerator}"),
            });
            reciprocals.push(reciprocal);
        }
        // Prepared constants that equal ε or a parameter are listed by name only.
        let is_kept = |output: &&Node| matches!(step.constants.operations[output.0], Operation::Input(_));
        let kept = step.constants.outputs.iter().filter(is_kept).map(|output| fixed[output.0].clone());
        let constants = kept.chain(lines(&step.constants, &fixed, |_| false)).collect();
        let kernel = lines(plan, &named, |index| hidden[index]);
        StepListing { constants, kernel, reciprocals, next, holds_to: step.holds_to }
    }
}

fn lines(plan: &Plan, names: &[String], hidden: impl Fn(usize) -> bool) -> Vec<String> {
    let is_literal = |node: Node| matches!(plan.operations[node.0], Operation::Constant(_));
    let lines = plan.operations.iter().zip(names).enumerate().filter_map(|(index, (operation, result))| {
        if hidden(index) {
            return None;
        }
        if matches!(*operation, Operation::Negate(a) if is_literal(a)) {
            return None;
        }
        let right = operation.text(|node| &names[node.0])?;
        Some(format!("{result} = {right}"))
    });
    lines.collect()
}
