//! One form of a step, with its price.

use std::collections::BTreeSet;

use super::nesting::Goal;
use super::writer::Writer;
use super::{Node, Operation, PlanBuilder};

/// What a prepared constant that was rounded more than once costs, in operations.
const DERIVED: usize = 3;

/// A finished form: x̃ᵢ − xᵢ = numeratorᵢ · reciprocalᵢ.
pub(super) struct Candidate {
    pub(super) builder: PlanBuilder,
    pub(super) numerators: Vec<Node>,
    pub(super) reciprocals: Vec<Option<Node>>,
    price: u64,
}

impl Candidate {
    pub(super) fn new(mut writer: Writer, numerators: Vec<Node>, reciprocals: Vec<Option<Node>>) -> Self {
        let mut distinct: Vec<Node> = reciprocals.iter().copied().flatten().collect();
        distinct.sort_unstable();
        distinct.dedup();
        let price = price_of(&mut writer, &numerators, &distinct);
        Candidate { builder: writer.draft.builder, numerators, reciprocals, price }
    }

    /// What is compared.
    pub(super) fn price(&self) -> u64 {
        self.price
    }
}

/// Operations and cycles to the next state, and a fine for prepared constants that were rounded more than once.
fn price_of(writer: &mut Writer, numerators: &[Node], reciprocals: &[Node]) -> u64 {
    let mut outputs = numerators.to_vec();
    outputs.extend(reciprocals);
    let plan = writer.draft.builder.finish(&outputs);
    let states = writer.scaling.states();
    let (constants, kernel) = plan.split(|variable| variable.0 < states);
    let derived = constants.derived_constants(writer.scaling.epsilon());
    let is_negation = |node: &Node| matches!(kernel.operations[node.0], Operation::Negate(_));
    let negated: BTreeSet<Node> =
        kernel.outputs[..numerators.len()].iter().copied().filter(is_negation).collect();
    let cost = kernel.cost();
    // A negated numerator becomes a subtraction at the end.
    let fine = if writer.scaling.folds { 0 } else { DERIVED * derived };
    let operations = cost.operations() - negated.len() + fine;
    Goal::Early.price(operations, cost.chain)
}
