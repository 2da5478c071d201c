//! Computes the cost of a program: operation counts and critical path.
//!
//! Latencies are typical of x86-64 cores of the last ten years, in cycles. A multiply-add takes one
//! cycle more than an addition. [`Program::fused`] does not fuse an addition if this lengthens the
//! critical path.

use alloc::vec;
use alloc::vec::Vec;
use core::hash::Hash;

use crate::{Node, Operation, Program};

/// The latency of an addition or subtraction in cycles.
pub const ADD: u32 = 3;
/// The latency of a multiplication in cycles.
pub const MULTIPLY: u32 = 4;
/// The latency of a multiply-add in cycles.
pub const FUSED: u32 = 4;
/// The latency of a division in cycles.
pub const DIVIDE: u32 = 14;

/// The operation counts and critical path of a program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// The number of additions, subtractions and negations.
    pub additions: usize,
    /// The number of multiplications.
    pub multiplications: usize,
    /// The number of multiply-adds.
    pub fused: usize,
    /// The number of divisions.
    pub divisions: usize,
    /// The number of cycles from the inputs to the last output with unlimited parallelism.
    pub critical_path: u32,
}

impl Cost {
    /// Counts the operations, where a multiply-add is a multiplication and an addition.
    #[must_use]
    pub fn operations(&self) -> usize {
        self.additions + self.multiplications + 2 * self.fused + self.divisions
    }
}

impl<I, C> Operation<I, C> {
    /// Returns the latency of the operation in cycles.
    #[must_use]
    pub fn latency(&self) -> u32 {
        match self {
            Operation::Input(_) | Operation::Constant(_) => 0,
            // A negation flips only the sign bit.
            Operation::Negate(_) => 1,
            Operation::Add(..) | Operation::Subtract(..) => ADD,
            Operation::Multiply(..) => MULTIPLY,
            Operation::Divide(..) => DIVIDE,
            Operation::MultiplyAdd(..) | Operation::MultiplySubtract(..) | Operation::SubtractProduct(..) => {
                FUSED
            }
            Operation::Call(function, ..) => match *function {},
        }
    }
}

impl<I: Clone + Eq + Hash, C: Clone + Eq + Hash> Program<Vec<Operation<I, C>>> {
    /// Counts the operations, and adds the latencies on the longest path of dependent operations.
    #[must_use]
    pub fn cost(&self) -> Cost {
        let mut cost = Cost::default();
        for operation in &self.operations {
            match operation {
                Operation::Input(_) | Operation::Constant(_) => {}
                Operation::Negate(_) | Operation::Add(..) | Operation::Subtract(..) => cost.additions += 1,
                Operation::Multiply(..) => cost.multiplications += 1,
                Operation::Divide(..) => cost.divisions += 1,
                Operation::MultiplyAdd(..)
                | Operation::MultiplySubtract(..)
                | Operation::SubtractProduct(..) => {
                    cost.fused += 1;
                }
                Operation::Call(function, ..) => match *function {},
            }
        }
        let ready = self.ready();
        cost.critical_path = self.outputs.iter().map(|output| ready[output.0]).max().unwrap_or(0);
        cost
    }

    /// Returns for each operation the cycle in which its result is ready.
    #[must_use]
    pub fn ready(&self) -> Vec<u32> {
        let mut ready: Vec<u32> = Vec::with_capacity(self.operations.len());
        for operation in &self.operations {
            let operands = operation.operands().map(|Node(index)| ready[index]).max().unwrap_or(0);
            ready.push(operands + operation.latency());
        }
        ready
    }

    /// Replaces products and sums by multiply-adds where this does not lengthen the critical path.
    /// Targets without the instruction should run the original program.
    #[must_use]
    pub fn fused(mut self) -> Self {
        let mut uses = self.uses();
        let required = self.required();
        let mut ready = vec![0; self.operations.len()];
        for index in 0..self.operations.len() {
            if let Some(fused) = self.fusable(index, &uses, &ready, required[index]) {
                for operand in self.operations[index].operands() {
                    if !fused.operands().any(|kept| kept == operand) {
                        uses[operand.0] -= 1;
                    }
                }
                self.operations[index] = fused;
            }
            let operation = &self.operations[index];
            let operands = operation.operands().map(|Node(index)| ready[index]).max().unwrap_or(0);
            ready[index] = operands + operation.latency();
        }
        Program::together([&self])
    }

    fn fusable(&self, index: usize, uses: &[usize], ready: &[u32], required: u32) -> Option<Operation<I, C>> {
        let product = |node: Node| match self.operations[node.0] {
            Operation::Multiply(a, b) if uses[node.0] == 1 => Some((a, b)),
            _ => None,
        };
        let at = |node: Node| ready[node.0];
        let candidate = match self.operations[index] {
            Operation::Add(a, b) => {
                // If both summands are products, the one that is ready later is fused.
                let (late, early) = if at(a) > at(b) { (a, b) } else { (b, a) };
                match (product(late), product(early)) {
                    (Some((x, y)), _) => Some(Operation::MultiplyAdd(x, y, early)),
                    (None, Some((x, y))) => Some(Operation::MultiplyAdd(x, y, late)),
                    (None, None) => None,
                }
            }
            Operation::Subtract(a, b) => match (product(a), product(b)) {
                (Some((x, y)), _) if at(a) > at(b) => Some(Operation::MultiplySubtract(x, y, b)),
                (_, Some((x, y))) => Some(Operation::SubtractProduct(a, x, y)),
                (Some((x, y)), None) => Some(Operation::MultiplySubtract(x, y, b)),
                (None, None) => None,
            },
            _ => None,
        }?;
        let fused = candidate.operands().map(at).max().unwrap_or(0) + FUSED;
        let unfused = self.operations[index].operands().map(at).max().unwrap_or(0) + ADD;
        (fused <= required.max(unfused)).then_some(candidate)
    }

    /// Returns for each operation the latest cycle in which its result may be ready without
    /// lengthening the critical path.
    #[must_use]
    pub fn required(&self) -> Vec<u32> {
        let critical_path = self.cost().critical_path;
        let mut required = vec![critical_path; self.operations.len()];
        for (index, operation) in self.operations.iter().enumerate().rev() {
            let latest = required[index].saturating_sub(operation.latency());
            for operand in operation.operands() {
                required[operand.0] = required[operand.0].min(latest);
            }
        }
        required
    }
}
