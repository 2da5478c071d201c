//! Straight-line programs and their static analysis.

use alloc::vec;
use alloc::vec::Vec;
use core::ops::{Deref, Range};

use crate::Builder;
use crate::operation::{Function, Node, Operation};

/// A straight-line program: a list of operations, some of whose results are outputs.
///
/// The lists `O` of operations and `N` of outputs are vectors or borrowed slices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Program<O, N = Vec<Node>> {
    /// The operations. Operands come before the operations that use them.
    pub operations: O,
    /// The results that the program returns, in order.
    pub outputs: N,
}

impl<I, C, F, O, N> Program<O, N>
where
    F: Function,
    O: Deref<Target = [Operation<I, C, F>]>,
    N: Deref<Target = [Node]>,
{
    /// Returns for each operation how often it occurs as an operand or an output.
    #[must_use]
    pub fn uses(&self) -> Vec<usize> {
        let mut uses = vec![0; self.operations.len()];
        for operation in &*self.operations {
            for operand in operation.operands() {
                uses[operand.0] += 1;
            }
        }
        for output in &*self.outputs {
            uses[output.0] += 1;
        }
        uses
    }

    /// Returns for each operation whether an output depends on it.
    #[must_use]
    pub fn needed(&self) -> Vec<bool> {
        let operations: &[Operation<I, C, F>] = &self.operations;
        let mut needed = vec![false; operations.len()];
        for output in &*self.outputs {
            needed[output.0] = true;
        }
        for (index, operation) in operations.iter().enumerate().rev() {
            if needed[index] {
                for operand in operation.operands() {
                    needed[operand.0] = true;
                }
            }
        }
        needed
    }

    /// Returns whether the program is valid: operations read only results of earlier operations,
    /// calls of one-argument functions repeat their operand, and all outputs exist.
    #[must_use]
    pub fn is_well_formed(&self) -> bool {
        let operations: &[Operation<I, C, F>] = &self.operations;
        let reads_earlier = |(index, operation): (usize, &Operation<I, C, F>)| match operation {
            Operation::Call(function, a, b) if function.arguments() == 1 && a != b => false,
            _ => operation.operands().all(|operand| operand.0 < index),
        };
        operations.iter().enumerate().all(reads_earlier)
            && self.outputs.iter().all(|output| output.0 < operations.len())
    }

    /// Returns the inputs in order.
    #[must_use]
    pub fn inputs(&self) -> Vec<I>
    where
        I: Clone,
    {
        let mut inputs = Vec::new();
        for operation in &*self.operations {
            if let Operation::Input(input) = operation {
                inputs.push(input.clone());
            }
        }
        inputs
    }
}

impl<I: Clone, C: Clone, F: Function + Clone> Program<Vec<Operation<I, C, F>>> {
    /// Creates the program with these outputs, keeping only operations that the outputs need.
    #[must_use]
    pub fn of_results(operations: &[Operation<I, C, F>], outputs: &[Node]) -> Self {
        let needed = Program { operations, outputs }.needed();
        // Operations that no output needs keep `usize::MAX`, which is never read.
        let (mut kept, mut places) = (Vec::new(), vec![Node(usize::MAX); operations.len()]);
        for (index, operation) in operations.iter().enumerate() {
            if needed[index] {
                places[index] = Node(kept.len());
                kept.push(operation.with_operands(|node| places[node.0]));
            }
        }
        Program { operations: kept, outputs: outputs.iter().map(|node| places[node.0]).collect() }
    }

    /// Returns the program that computes only the given range of outputs.
    #[must_use]
    pub fn part(&self, outputs: Range<usize>) -> Self {
        Program::of_results(&self.operations, &self.outputs[outputs])
    }
}

impl<I, C, F> Program<Vec<Operation<I, C, F>>>
where
    I: Clone + core::hash::Hash + Eq,
    C: Clone + core::hash::Hash + Eq,
    F: Function + Clone + core::hash::Hash + Eq,
{
    /// Joins programs into one with all their outputs in order. Operations that occur in several
    /// programs are computed once.
    #[must_use]
    pub fn together<'a>(programs: impl IntoIterator<Item = &'a Self>) -> Self
    where
        Self: 'a,
    {
        let mut builder = Builder::default();
        let outputs: Vec<Node> = programs.into_iter().flat_map(|program| builder.include(program)).collect();
        builder.finish(&outputs)
    }
}
