//! The inputs and constants of plans.

use kahan_program::Program;
pub use kahan_program::{Cost, Node};
use kahan_syntax::rational::Rational;
use kahan_syntax::table::distinct;

use crate::poly::Variable;

/// An input of a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Input {
    /// A variable, which is a state, a parameter or ε.
    Variable(Variable),
    /// The prepared constant with this index, in the kernel of a [`StepPlan`](super::StepPlan).
    Prepared(usize),
}

impl Input {
    /// Returns the variable. Returns `None` for a prepared constant.
    #[must_use]
    pub fn variable(&self) -> Option<Variable> {
        match *self {
            Input::Variable(variable) => Some(variable),
            Input::Prepared(_) => None,
        }
    }

    /// Returns the value of the input from the prepared constants or from the function `variable`.
    pub fn value<V: Clone>(
        &self,
        prepared: &[Option<V>],
        variable: impl FnOnce(Variable) -> Option<V>,
    ) -> Option<V> {
        match *self {
            Input::Variable(name) => variable(name),
            Input::Prepared(k) => prepared[k].clone(),
        }
    }
}

/// An operation of a plan.
pub type Operation = kahan_program::Operation<Input, Rational>;

/// A straight-line program with exact constants.
pub type Plan = Program<Vec<Operation>>;

/// Returns the states, parameters and ε that a plan reads, in ascending order.
#[must_use]
pub fn variables(plan: &Plan) -> Vec<Variable> {
    distinct(plan.inputs().iter().filter_map(Input::variable))
}
