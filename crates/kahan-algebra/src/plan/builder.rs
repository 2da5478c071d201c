//! Builds plans from variables, polynomials and other plans.

use std::ops::{Deref, DerefMut};

use kahan_program::{Builder, Node};
use kahan_syntax::rational::Rational;

use crate::poly::{Polynomial, Variable};

use super::{Input, Operation, Plan};

/// A [`Builder`] of plans that also accepts polynomials.
#[derive(Clone, Debug, Default)]
pub struct PlanBuilder {
    builder: Builder<Input, Rational>,
    /// The number of polynomial terms examined so far, which `MOST_LOOKED_AT` limits.
    pub(super) looked_at: usize,
}

impl Deref for PlanBuilder {
    type Target = Builder<Input, Rational>;

    fn deref(&self) -> &Self::Target {
        &self.builder
    }
}

impl DerefMut for PlanBuilder {
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.builder
    }
}

/// Returns the plan that computes these polynomials.
#[must_use]
pub fn plan_of<'a>(polynomials: impl IntoIterator<Item = &'a Polynomial>) -> Plan {
    let mut builder = PlanBuilder::default();
    let nodes: Vec<Node> = polynomials.into_iter().map(|polynomial| builder.polynomial(polynomial)).collect();
    builder.finish(&nodes)
}

impl PlanBuilder {
    /// Returns the node of a variable.
    pub fn input(&mut self, variable: Variable) -> Node {
        self.push(Operation::Input(Input::Variable(variable)))
    }

    pub(super) fn prepared(&mut self, index: usize) -> Node {
        self.push(Operation::Input(Input::Prepared(index)))
    }

    /// Adds another plan with its variables replaced by the nodes from `input`. Returns the nodes
    /// of the outputs.
    pub fn include_mapped(
        &mut self,
        plan: &Plan,
        mut input: impl FnMut(&mut Self, Variable) -> Node,
    ) -> Vec<Node> {
        let nodes = self.include_with(plan, |builder, index, renamed| match plan.operations[index] {
            Operation::Input(Input::Variable(variable)) => input(builder, variable),
            ref operation => builder.push(operation.with_operands(|node| renamed[node.0])),
        });
        plan.outputs.iter().map(|output| nodes[output.0]).collect()
    }

    /// Copies another plan. The function `make` copies one operation, given its index and the
    /// copies of all earlier operations.
    pub(super) fn include_with(
        &mut self,
        plan: &Plan,
        mut make: impl FnMut(&mut Self, usize, &[Node]) -> Node,
    ) -> Vec<Node> {
        let mut renamed: Vec<Node> = Vec::with_capacity(plan.operations.len());
        for index in 0..plan.operations.len() {
            let node = make(self, index, &renamed);
            renamed.push(node);
        }
        renamed
    }

    pub(super) fn include_literal(&mut self, plan: &Plan, node: Node) -> Node {
        let operation = &plan.operations[node.0];
        let operand = operation.operands().next().map(|operand| self.include_literal(plan, operand));
        self.push(operation.with_operands(|node| operand.unwrap_or(node)))
    }
}
