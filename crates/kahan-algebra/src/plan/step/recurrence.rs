//! Estimates the time of a step in an orbit, where each step waits for the previous one.
//!
//! A loop of dependences leads from a state through n steps back to this state. If it takes the
//! time d, a step takes at least d/n. The largest d/n is the time of a step.

use crate::poly::Variable;

use crate::plan::{Input, Node, Operation, PlanBuilder, StepPlan};
use kahan_program::cost::{ADD, FUSED, MULTIPLY};

impl StepPlan {
    /// Returns the number of cycles of a step in a long orbit, rounded up.
    #[must_use]
    pub fn cycles(&self) -> u64 {
        self.recurrence().div_ceil(UNIT)
    }

    /// Returns the time of the slowest loop of dependences through at most n steps, divided by its
    /// number of steps, where n is the number of states. The unit is 1/60 processor cycle.
    pub(in crate::plan) fn recurrence(&self) -> u64 {
        let n = self.kernel.dimension();
        let mut longest = 0;
        let one = self.delays();
        let mut power = one.clone();
        for length in 1..=n as u64 {
            let back = (0..n).filter_map(|i| power[i][i]).max().unwrap_or(0);
            longest = longest.max(u64::from(back) * UNIT / length);
            power = composed(&power, &one);
        }
        longest
    }

    /// Returns the number of cycles from xⱼ to x̃ᵢ for all i and j. Independent pairs have `None`.
    fn delays(&self) -> Vec<Vec<Option<u32>>> {
        let n = self.kernel.dimension();
        let columns: Vec<Vec<Option<u32>>> = (0..n).map(|j| self.delays_from(j)).collect();
        (0..n).map(|i| columns.iter().map(|column| column[i]).collect()).collect()
    }

    fn delays_from(&self, j: usize) -> Vec<Option<u32>> {
        let plan = &self.kernel.plan;
        let mut arrival: Vec<Option<u32>> = Vec::with_capacity(plan.operations.len());
        for operation in &plan.operations {
            let operands = operation.operands().filter_map(|Node(index)| arrival[index]).max();
            arrival.push(match operation {
                Operation::Input(Input::Variable(Variable(index))) => (usize::from(*index) == j).then_some(0),
                _ => operands.map(|ready| ready + operation.latency()),
            });
        }
        let delay = |(i, (numerator, reciprocal)): (usize, (&Node, Option<&Node>))| {
            let numerator = arrival[numerator.0];
            let increment = match reciprocal {
                Some(reciprocal) => numerator.max(arrival[reciprocal.0]).map(|ready| ready + MULTIPLY),
                None => numerator,
            };
            let itself = (i == j).then_some(0);
            increment.max(itself).map(|ready| ready + ADD)
        };
        self.kernel.factors(&plan.outputs).enumerate().map(delay).collect()
    }
}

/// Returns a lower bound on the [recurrence](StepPlan::recurrence) of every step that uses this
/// reciprocal.
pub(in crate::plan) fn least_recurrence(builder: &PlanBuilder, reciprocal: Node, moving: &[Variable]) -> u64 {
    let through = |state: &Variable| earliest(builder.operations(), reciprocal, *state);
    // A single component is divided directly, without multiplication by a reciprocal.
    let product = if moving.len() > 1 { MULTIPLY } else { 0 };
    let back = moving.iter().filter_map(through).max().map_or(0, |ready| ready + product + ADD);
    u64::from(back) * UNIT
}

pub(super) fn earliest(operations: &[Operation], node: Node, variable: Variable) -> Option<u32> {
    let mut arrival: Vec<Option<u32>> = Vec::with_capacity(node.0 + 1);
    for operation in &operations[..=node.0] {
        let ready = match *operation {
            Operation::Input(Input::Variable(input)) => (input == variable).then_some(0),
            // A negation takes no time, because other operations absorb it.
            Operation::Negate(a) => arrival[a.0],
            Operation::Add(a, b) | Operation::Subtract(a, b) => {
                let summand = |summand: Node| match operations[summand.0] {
                    // The multiplication may be fused with the addition.
                    Operation::Multiply(c, d) => Some(arrival[c.0].max(arrival[d.0])? + FUSED),
                    _ => Some(arrival[summand.0]? + ADD),
                };
                summand(a).max(summand(b))
            }
            _ => {
                let operands = operation.operands().filter_map(|Node(index)| arrival[index]).max();
                operands.map(|ready| ready + operation.latency())
            }
        };
        arrival.push(ready);
    }
    arrival[node.0]
}

/// The units of time in a cycle. Times of loops divided by 1, 2, …, 6 steps are then integers.
const UNIT: u64 = 60;

/// Returns the longest paths through two consecutive steps.
fn composed(first: &[Vec<Option<u32>>], second: &[Vec<Option<u32>>]) -> Vec<Vec<Option<u32>>> {
    let n = first.len();
    let through = |i: usize, j: usize| (0..n).filter_map(|k| Some(second[i][k]? + first[k][j]?)).max();
    (0..n).map(|i| (0..n).map(|j| through(i, j)).collect()).collect()
}
