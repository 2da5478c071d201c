//! Steps of other plans in a plan under construction.

use crate::poly::Variable;

use super::{Node, Operation, Plan, PlanBuilder};

impl PlanBuilder {
    /// Adds the operations of another plan and returns its results here.
    pub fn include(&mut self, plan: &Plan) -> Vec<Node> {
        self.include_mapped(plan, Self::input)
    }

    /// Adds the operations of another plan, `input` standing for its variables, and returns its
    /// results here.
    pub fn include_mapped(
        &mut self,
        plan: &Plan,
        mut input: impl FnMut(&mut Self, Variable) -> Node,
    ) -> Vec<Node> {
        let steps = self.include_with(plan, |builder, index, renamed| match plan.operations[index] {
            Operation::Input(variable) => input(builder, variable),
            ref operation => builder.intern(operation.with_operands(|node| renamed[node.0])),
        });
        plan.outputs.iter().map(|output| steps[output.0]).collect()
    }

    /// Every operation of another plan, by its index there.
    pub(super) fn include_all(&mut self, plan: &Plan) -> Vec<Node> {
        self.include_with(plan, |builder, index, renamed| {
            builder.intern(plan.operations[index].with_operands(|node| renamed[node.0]))
        })
    }

    /// A step for every step of another plan, by its index there: `step` makes it, given those
    /// before it.
    pub(super) fn include_with(
        &mut self,
        plan: &Plan,
        mut step: impl FnMut(&mut Self, usize, &[Node]) -> Node,
    ) -> Vec<Node> {
        let mut renamed: Vec<Node> = Vec::with_capacity(plan.operations.len());
        for index in 0..plan.operations.len() {
            let node = step(self, index, &renamed);
            renamed.push(node);
        }
        renamed
    }

    /// A literal of another plan: a constant, or the negation of one.
    pub(super) fn include_node(&mut self, plan: &Plan, node: Node) -> Node {
        let operation = &plan.operations[node.0];
        let mut renamed = Vec::new();
        for operand in operation.operands() {
            renamed.push(self.include_node(plan, operand));
        }
        let mut renamed = renamed.into_iter();
        self.intern(operation.with_operands(|_| renamed.next().expect("one for each operand")))
    }
}
