//! A candidate for the form of a step, with its price.

use kahan_syntax::table::distinct;

use crate::plan::step::split::{derived_constants, split};
use crate::plan::writing::nesting::{DERIVED_CONSTANT_PRICE, FormGoal};
use crate::plan::writing::plan_draft::Signed;
use crate::plan::writing::writer::Writer;
use crate::plan::{Node, Operation, Plan, PlanBuilder};

/// A finished form with x̃ᵢ − xᵢ = numeratorᵢ · reciprocalᵢ.
pub(in crate::plan) struct Candidate {
    pub(in crate::plan) builder: PlanBuilder,
    pub(in crate::plan) numerators: Vec<Node>,
    pub(in crate::plan) reciprocals: Vec<Option<Node>>,
    pub(in crate::plan) price: u64,
    /// The number of operations of a step. This is the cost for many orbits in SIMD lanes.
    pub(in crate::plan) operations: usize,
    derived: usize,
}

impl Candidate {
    pub(super) fn new(writer: Writer, numerators: Vec<Node>, reciprocals: Vec<Option<Node>>) -> Self {
        let mut outputs = numerators.clone();
        outputs.extend(distinct(reciprocals.iter().copied().flatten()));
        let (kernel, derived) = writer.kernel(&outputs);
        let price = price_of(&kernel, numerators.len(), derived);
        let products = reciprocals.iter().flatten().count();
        let operations = kernel.cost().operations() + products + numerators.len();
        Candidate { builder: writer.draft.builder, numerators, reciprocals, price, operations, derived }
    }

    /// Builds a candidate from numerators, reciprocals and flags (`true` negates the numerator).
    pub(super) fn over(
        mut writer: Writer,
        numerators: impl IntoIterator<Item = (Signed, Node, bool)>,
    ) -> Self {
        let (mut nodes, mut reciprocals) = (Vec::new(), Vec::new());
        for (numerator, reciprocal, flips) in numerators {
            let is_still = writer.draft.is_zero(numerator);
            nodes.push(writer.draft.node(numerator.flipped(flips)));
            reciprocals.push((!is_still).then_some(reciprocal));
        }
        Candidate::new(writer, nodes, reciprocals)
    }

    /// Returns whether each prepared constant is rounded only once. Constants with two roundings
    /// make integrals drift. Dissipative fields have no integrals; for them the result is `true`.
    pub(in crate::plan) fn is_rounded_once(&self) -> bool {
        self.derived == 0
    }
}

impl Writer {
    fn kernel(&self, outputs: &[Node]) -> (Plan, usize) {
        let plan = self.draft.builder.finish(outputs);
        let epsilon = self.scaling.epsilon();
        let (constants, kernel) = split(&plan, epsilon, |variable| self.scaling.ready(variable).is_some());
        (kernel, if self.scaling.folds { 0 } else { derived_constants(&constants, epsilon) })
    }

    /// Returns whether no prepared constant of `step` is rounded twice, or the field is
    /// dissipative.
    pub(in crate::plan) fn is_rounded_once(&self, step: Node) -> bool {
        self.kernel(&[step]).1 == 0
    }
}

/// Returns the price of a kernel by its operations, latency, and constants rounded twice.
fn price_of(kernel: &Plan, components: usize, derived: usize) -> u64 {
    let is_negation = |node: &Node| matches!(kernel.operations[node.0], Operation::Negate(_));
    let negated = distinct(kernel.outputs[..components].iter().copied().filter(is_negation));
    let cost = kernel.cost();
    // A negated numerator costs nothing, because the last addition becomes a subtraction.
    let operations = cost.operations() - negated.len() + DERIVED_CONSTANT_PRICE * derived;
    FormGoal::Early.price(operations, cost.critical_path)
}
