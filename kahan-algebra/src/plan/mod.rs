//! Straight-line steps: what is computed, in which order, with every common subexpression once.
//!
//! A plan is data. The emitter turns it into Rust, [`Plan::evaluate`] runs it in any [`Arithmetic`]: rationals, a prime
//! field, dual numbers, degree bounds, rational functions, floats. Both see the same operations in the same order.

mod builder;

pub use builder::PlanBuilder;

use crate::arithmetic::Arithmetic;
use crate::poly::{Polynomial, Variable};
use crate::rational::Rational;

/// The result of an operation: its index in the plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Node(pub usize);

/// One step of a plan; its operands are earlier steps.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// A state, a parameter or ε.
    Input(Variable),
    /// An exact constant.
    Constant(Rational),
    /// a + b
    Add(Node, Node),
    /// a − b
    Subtract(Node, Node),
    /// a · b
    Multiply(Node, Node),
    /// a / b
    Divide(Node, Node),
    /// −a
    Negate(Node),
}

impl Operation {
    /// The operands, at most two.
    #[must_use]
    pub fn operands(&self) -> [Option<Node>; 2] {
        match *self {
            Operation::Input(_) | Operation::Constant(_) => [None, None],
            Operation::Negate(a) => [Some(a), None],
            Operation::Add(a, b)
            | Operation::Subtract(a, b)
            | Operation::Multiply(a, b)
            | Operation::Divide(a, b) => [Some(a), Some(b)],
        }
    }
}

/// A straight-line program with several results.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Plan {
    /// The steps, operands before their uses, no step twice.
    pub operations: Vec<Operation>,
    /// The results.
    pub outputs: Vec<Node>,
}

impl Plan {
    /// The plan that computes these polynomials, one result each.
    #[must_use]
    pub fn of<'a>(polynomials: impl IntoIterator<Item = &'a Polynomial>) -> Self {
        let mut builder = PlanBuilder::default();
        let nodes: Vec<Node> =
            polynomials.into_iter().map(|polynomial| builder.polynomial(polynomial)).collect();
        builder.finish(&nodes)
    }

    /// Runs the plan; `input` gives the value of each variable. A result that divides by zero on its way is `None`;
    /// the others are not touched by that. Cost: one arithmetic operation a step.
    pub fn evaluate<A: Arithmetic>(
        &self,
        arithmetic: &A,
        mut input: impl FnMut(Variable) -> A::Value,
    ) -> Vec<Option<A::Value>> {
        let mut values: Vec<Option<A::Value>> = Vec::with_capacity(self.operations.len());
        for operation in &self.operations {
            let [a, b] = operation.operands();
            let value = match (operation, a.map(|a| &values[a.0]), b.map(|b| &values[b.0])) {
                (Operation::Input(variable), ..) => Some(input(*variable)),
                (Operation::Constant(value), ..) => arithmetic.constant(value),
                (Operation::Negate(_), Some(Some(a)), _) => Some(arithmetic.negate(a)),
                (Operation::Add(..), Some(Some(a)), Some(Some(b))) => Some(arithmetic.add(a, b)),
                (Operation::Subtract(..), Some(Some(a)), Some(Some(b))) => Some(arithmetic.subtract(a, b)),
                (Operation::Multiply(..), Some(Some(a)), Some(Some(b))) => Some(arithmetic.multiply(a, b)),
                (Operation::Divide(..), Some(Some(a)), Some(Some(b))) => arithmetic.divide(a, b),
                _ => None,
            };
            values.push(value);
        }
        self.outputs.iter().map(|output| values[output.0].clone()).collect()
    }

    /// The inputs that the results depend on, in order.
    #[must_use]
    pub fn inputs(&self) -> Vec<Variable> {
        let mut inputs: Vec<Variable> = self
            .operations
            .iter()
            .filter_map(|operation| match operation {
                Operation::Input(variable) => Some(*variable),
                _ => None,
            })
            .collect();
        inputs.sort_unstable();
        inputs
    }

    /// How many times each step is used, as an operand or as a result.
    #[must_use]
    pub fn uses(&self) -> Vec<usize> {
        let mut uses = vec![0; self.operations.len()];
        for node in
            self.operations.iter().flat_map(Operation::operands).flatten().chain(self.outputs.iter().copied())
        {
            uses[node.0] += 1;
        }
        uses
    }
}
