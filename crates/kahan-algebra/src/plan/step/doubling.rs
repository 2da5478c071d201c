//! (2ε)·x as εx + εx, where εx is there anyway and nothing waits for it.
//!
//! Both are the same number. But machines have two ports for multiplications and a third one for
//! additions, and in lanes the ports are what a step is bound by.

use crate::plan::cost::ADD;
use crate::plan::{Node, Operation, Plan, PlanBuilder};

impl Plan {
    /// The kernel with such products as sums; `constants` are its prepared constants.
    #[must_use]
    pub(in crate::plan) fn doubled(&self, constants: &Plan) -> Self {
        let (ready, required) = (self.ready(), self.required());
        let mut builder = PlanBuilder::default();
        let renamed = builder.include_with(self, |builder, index, renamed| {
            let operation = &self.operations[index];
            // The sum is ready one addition after the product that it doubles.
            let single = self
                .half(operation, constants)
                .filter(|single| ready[single.0] + ADD <= required[index])
                .map(|single| self.early(single, renamed, builder));
            builder.intern(match single {
                Some(single) => Operation::Add(single, single),
                None => operation.with_operands(|operand| renamed[operand.0]),
            })
        });
        let outputs: Vec<Node> = self.outputs.iter().map(|output| renamed[output.0]).collect();
        builder.finish(&outputs)
    }

    /// A product of a prepared constant, which may come later in this plan than where it is wanted.
    fn early(&self, single: Node, renamed: &[Node], builder: &mut PlanBuilder) -> Node {
        let operation = self.operations[single.0].with_operands(|operand| {
            let known = renamed.get(operand.0).copied();
            known.unwrap_or_else(|| builder.intern(self.operations[operand.0].clone()))
        });
        builder.intern(operation)
    }

    /// For a product 2c·x, the operation c·x, if there is one.
    fn half(&self, operation: &Operation, constants: &Plan) -> Option<Node> {
        let Operation::Multiply(a, b) = *operation else { return None };
        let (factor, value) = match (&self.operations[a.0], &self.operations[b.0]) {
            (Operation::Prepared(factor), _) => (*factor, b),
            (_, Operation::Prepared(factor)) => (*factor, a),
            _ => return None,
        };
        let half = constants.half_of(constants.outputs[factor])?;
        let half = constants.outputs.iter().position(|&output| output == half)?;
        let is_prepared = |node: Node| self.operations[node.0] == Operation::Prepared(half);
        let single = self.operations.iter().position(|step| match *step {
            Operation::Multiply(x, y) => (x == value && is_prepared(y)) || (y == value && is_prepared(x)),
            _ => false,
        })?;
        Some(Node(single))
    }

    /// c for an operation 2·c.
    fn half_of(&self, node: Node) -> Option<Node> {
        let is_two = |node: Node| match &self.operations[node.0] {
            Operation::Constant(value) => value.as_i64() == Some(2),
            _ => false,
        };
        match self.operations[node.0] {
            Operation::Multiply(a, b) if is_two(a) => Some(b),
            Operation::Multiply(a, b) if is_two(b) => Some(a),
            _ => None,
        }
    }
}
