//! How long a step takes in an orbit, where each waits for the one before.
//!
//! What counts is not the longest way through one step, but the longest cycle from a state through
//! several steps back to itself: a component that no denominator depends on may come late.

use crate::poly::Variable;

use super::cost::{ADD, MULTIPLY};
use super::{Node, Operation, StepPlan};

impl StepPlan {
    /// Cycles from one state to the next in a long orbit, rounded up.
    #[must_use]
    pub fn cycles(&self) -> u64 {
        self.recurrence().div_ceil(UNIT)
    }

    /// Cycles a step in an orbit: the largest mean over cycles of up to n steps, in units of 1/60
    /// so that it is an integer.
    pub(super) fn recurrence(&self) -> u64 {
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

    /// Entry (i, j): cycles from x_j to x̃ᵢ; `None` where x̃ᵢ does not depend on x_j.
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
                Operation::Input(Variable(index)) => (usize::from(*index) == j).then_some(0),
                _ => operands.map(|ready| ready + operation.latency()),
            });
        }
        self.kernel
            .factors(&plan.outputs)
            .enumerate()
            .map(|(i, (numerator, reciprocal))| {
                let numerator = arrival[numerator.0];
                let increment = match reciprocal {
                    Some(reciprocal) => numerator.max(arrival[reciprocal.0]).map(|ready| ready + MULTIPLY),
                    None => numerator,
                };
                let itself = (i == j).then_some(0);
                increment.max(itself).map(|ready| ready + ADD)
            })
            .collect()
    }
}

/// Divisible by the lengths of cycles of up to six steps.
const UNIT: u64 = 60;

/// The longest ways through one step after another.
fn composed(first: &[Vec<Option<u32>>], second: &[Vec<Option<u32>>]) -> Vec<Vec<Option<u32>>> {
    let n = first.len();
    let through = |i: usize, j: usize| (0..n).filter_map(|k| Some(second[i][k]? + first[k][j]?)).max();
    (0..n).map(|i| (0..n).map(|j| through(i, j)).collect()).collect()
}
