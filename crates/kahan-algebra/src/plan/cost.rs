//! What a plan costs: operations counted, and the length of the critical path from a state to the
//! next state.
//!
//! The latencies are those of the x86-64 cores of the last ten years, in cycles; others differ by
//! one or two, which changes no choice between plans by much. They serve to compare plans, and
//! never enter a promise.

use std::cmp::Reverse;

use kahan_syntax::table::sorted_by_key;

use super::{Node, Operation, Plan};

/// Cycles until the result of an addition or subtraction can be used.
pub(super) const ADD: u32 = 3;
/// Cycles until the result of a multiplication can be used.
pub(super) const MULTIPLY: u32 = 4;
/// Cycles until the result of a multiply-add can be used.
pub(super) const FUSED: u32 = 4;
/// Cycles until the result of a division can be used.
pub(super) const DIVIDE: u32 = 14;

/// What a prepared constant that was rounded more than once costs, in operations.
pub(super) const DERIVED: usize = 3;

/// Operations of a plan, and its critical path.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Additions, subtractions and negations.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Multiply-adds: one operation where the target has them, else two.
    pub fused: usize,
    /// Divisions.
    pub divisions: usize,
    /// Cycles from the inputs to the last result, if nothing else hinders: additions 3,
    /// multiplications and multiply-adds 4, divisions 14.
    pub critical_path: u32,
}

impl Cost {
    /// All operations, a multiply-add counted twice: what a target without it carries out.
    #[must_use]
    pub fn operations(&self) -> usize {
        self.additions + self.multiplications + 2 * self.fused + self.divisions
    }
}

impl Operation {
    /// Cycles that the operation itself takes.
    pub(super) fn latency(&self) -> u32 {
        match self {
            Operation::Input(_) | Operation::Constant(_) | Operation::Prepared(_) => 0,
            // A change of sign is a bit.
            Operation::Negate(_) => 1,
            Operation::Add(..) | Operation::Subtract(..) => ADD,
            Operation::Multiply(..) => MULTIPLY,
            Operation::Divide(..) => DIVIDE,
            Operation::MultiplyAdd(..) | Operation::MultiplySubtract(..) | Operation::SubtractProduct(..) => {
                FUSED
            }
        }
    }
}

impl Plan {
    /// The operations of the plan and its critical path.
    #[must_use]
    pub fn cost(&self) -> Cost {
        let mut cost = Cost::default();
        for operation in &self.operations {
            match operation {
                Operation::Input(_) | Operation::Constant(_) | Operation::Prepared(_) => {}
                Operation::Negate(_) | Operation::Add(..) | Operation::Subtract(..) => cost.additions += 1,
                Operation::Multiply(..) => cost.multiplications += 1,
                Operation::Divide(..) => cost.divisions += 1,
                Operation::MultiplyAdd(..)
                | Operation::MultiplySubtract(..)
                | Operation::SubtractProduct(..) => {
                    cost.fused += 1;
                }
            }
        }
        let ready = self.ready();
        cost.critical_path = self.outputs.iter().map(|output| ready[output.0]).max().unwrap_or(0);
        cost
    }

    /// The cycle in which each operation's result can be used, inputs being there from the
    /// beginning.
    pub(super) fn ready(&self) -> Vec<u32> {
        let mut ready: Vec<u32> = Vec::with_capacity(self.operations.len());
        for operation in &self.operations {
            let operands = operation.operands().map(|Node(index)| ready[index]).max().unwrap_or(0);
            ready.push(operands + operation.latency());
        }
        ready
    }
}

/// When the sum of values is ready, the earliest two added first.
pub(super) fn gathered(ready: &[u32]) -> u32 {
    combined(ready.to_vec(), ADD)
}

/// When the product of values is ready, the earliest two multiplied first.
pub(super) fn multiplied(ready: Vec<u32>) -> u32 {
    combined(ready, MULTIPLY)
}

/// When one value is left of these, two becoming one after so many cycles.
fn combined(all: Vec<u32>, latency: u32) -> u32 {
    let mut ready = sorted_by_key(all, |at| Reverse(*at));
    // The earliest two stand last.
    while let [.., later, _] = ready[..] {
        ready.truncate(ready.len() - 2);
        let at = later + latency;
        ready.insert(ready.partition_point(|other| *other >= at), at);
    }
    ready.first().copied().unwrap_or(0)
}
