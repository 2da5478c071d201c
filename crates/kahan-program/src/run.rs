//! Evaluates programs in an arithmetic.

use alloc::vec::Vec;
use core::ops::Deref;

use crate::operation::{Function, Node, Operation};
use crate::{Arithmetic, Calls, Program};

impl<C, F, O, N> Program<O, N>
where
    F: Function,
    O: Deref<Target = [Operation<usize, C, F>]>,
    N: Deref<Target = [Node]>,
{
    /// Runs a program without allocation. The inputs of the program are indices into `inputs`.
    ///
    /// Overwrites `workspace`, which needs one entry for each operation, and `outputs`. Returns
    /// `None` if a constant, a quotient or a call is undefined.
    ///
    /// # Panics
    /// If `inputs` or `workspace` is too short.
    pub fn run<A: Calls<F, Constant = C>>(
        &self,
        arithmetic: &A,
        inputs: &[A::Value],
        workspace: &mut [A::Value],
        outputs: &mut [A::Value],
    ) -> Option<()> {
        self.load(arithmetic, |number| Some(inputs[*number].clone()), workspace)?;
        self.compute(arithmetic, 0, workspace)?;
        for (output, node) in outputs.iter_mut().zip(&*self.outputs) {
            output.clone_from(&workspace[node.0]);
        }
        Some(())
    }
}

impl<I, C, F, O, N> Program<O, N>
where
    F: Function,
    O: Deref<Target = [Operation<I, C, F>]>,
    N: Deref<Target = [Node]>,
{
    /// Writes inputs and constants into the workspace; `None` if a constant is undefined.
    pub fn load<A: Arithmetic<Constant = C>>(
        &self,
        arithmetic: &A,
        mut input: impl FnMut(&I) -> Option<A::Value>,
        workspace: &mut [A::Value],
    ) -> Option<()> {
        for (place, operation) in workspace.iter_mut().zip(&*self.operations) {
            match operation {
                Operation::Input(name) => *place = input(name)?,
                Operation::Constant(value) => *place = arithmetic.constant(value)?,
                _ => {}
            }
        }
        Some(())
    }

    /// Computes the operations from index `first` on. The workspace must hold inputs, constants and
    /// earlier results. Returns `None` if a quotient or call is undefined.
    #[inline(always)]
    pub fn compute<A: Calls<F, Constant = C>>(
        &self,
        arithmetic: &A,
        first: usize,
        workspace: &mut [A::Value],
    ) -> Option<()> {
        for (to, operation) in (first..).zip(&self.operations[first..]) {
            let at = |node: Node| &workspace[node.0];
            workspace[to] = match *operation {
                Operation::Input(_) | Operation::Constant(_) => continue,
                Operation::Add(a, b) => arithmetic.add(at(a), at(b)),
                Operation::Subtract(a, b) => arithmetic.subtract(at(a), at(b)),
                Operation::Multiply(a, b) => arithmetic.multiply(at(a), at(b)),
                Operation::Divide(a, b) => arithmetic.divide(at(a), at(b))?,
                Operation::Negate(a) => arithmetic.negate(at(a)),
                Operation::MultiplyAdd(a, b, c) => arithmetic.multiply_add(at(a), at(b), at(c)),
                Operation::MultiplySubtract(a, b, c) => arithmetic.multiply_subtract(at(a), at(b), at(c)),
                Operation::SubtractProduct(a, b, c) => arithmetic.subtract_product(at(a), at(b), at(c)),
                Operation::Call(ref function, a, b) => arithmetic.call(function, at(a), at(b))?,
            };
        }
        Some(())
    }

    /// Evaluates a program, where `input` returns the value of an input. An output is `None` if it
    /// depends on an undefined value.
    pub fn evaluate<A: Calls<F, Constant = C>>(
        &self,
        arithmetic: &A,
        mut input: impl FnMut(&I) -> Option<A::Value>,
    ) -> Vec<Option<A::Value>> {
        let mut values: Vec<Option<A::Value>> = Vec::with_capacity(self.operations.len());
        for operation in &*self.operations {
            let value = match operation {
                Operation::Input(name) => input(name),
                operation => value(operation, arithmetic, &values),
            };
            values.push(value);
        }
        self.outputs.iter().map(|output| values[output.0].clone()).collect()
    }
}

/// Computes an operation; `None` if the operation or one of its operands is undefined.
#[inline(always)]
fn value<I, F, A: Calls<F>>(
    operation: &Operation<I, A::Constant, F>,
    arithmetic: &A,
    values: &[Option<A::Value>],
) -> Option<A::Value> {
    let at = |node: Node| values[node.0].as_ref();
    match *operation {
        Operation::Input(_) => None,
        Operation::Constant(ref constant) => arithmetic.constant(constant),
        Operation::Negate(a) => Some(arithmetic.negate(at(a)?)),
        Operation::Add(a, b) => Some(arithmetic.add(at(a)?, at(b)?)),
        Operation::Subtract(a, b) => Some(arithmetic.subtract(at(a)?, at(b)?)),
        Operation::Multiply(a, b) => Some(arithmetic.multiply(at(a)?, at(b)?)),
        Operation::Divide(a, b) => arithmetic.divide(at(a)?, at(b)?),
        Operation::MultiplyAdd(a, b, c) => Some(arithmetic.multiply_add(at(a)?, at(b)?, at(c)?)),
        Operation::MultiplySubtract(a, b, c) => Some(arithmetic.multiply_subtract(at(a)?, at(b)?, at(c)?)),
        Operation::SubtractProduct(a, b, c) => Some(arithmetic.subtract_product(at(a)?, at(b)?, at(c)?)),
        Operation::Call(ref function, a, b) => arithmetic.call(function, at(a)?, at(b)?),
    }
}
