//! A plan made ready to run over any scalar: names resolved, constants in the form that scalars are
//! built from.
//!
//! The instructions and their order are the plan's, and each is the call that generated code makes
//! for it, so the bits are the same. Registers are a vector a run: this is the back end for what is
//! asked a few million times, not for races.

use kahan_algebra::plan::{Node, Operation, Plan};
use kahan_algebra::poly::Variable;
use kahan_algebra::symbols::{Symbol, Symbols};
use kahan_core::Scalar;

use super::literal::Literal;

/// Where a program's inputs are.
#[derive(Debug)]
pub(crate) struct Inputs<'a, T> {
    pub(crate) state: &'a [T],
    /// The second point of a bilinear form.
    pub(crate) other: &'a [T],
    pub(crate) parameters: &'a [T],
    /// ε, where the program reads it.
    pub(crate) eps: Option<&'a T>,
    /// The constants that a kernel reads.
    pub(crate) prepared: &'a [T],
}

impl<T> Default for Inputs<'_, T> {
    fn default() -> Self {
        Inputs { state: &[], other: &[], parameters: &[], eps: None, prepared: &[] }
    }
}

/// One instruction; operands are earlier instructions.
#[derive(Clone, Debug)]
enum Instruction {
    Input(Symbol),
    Prepared(usize),
    Literal(Literal),
    Add(usize, usize),
    Subtract(usize, usize),
    Multiply(usize, usize),
    Divide(usize, usize),
    /// 1/d in a kernel.
    Reciprocal(usize),
    Negate(usize),
    MultiplyAdd(usize, usize, usize),
    MultiplySubtract(usize, usize, usize),
    SubtractProduct(usize, usize, usize),
}

/// Straight-line instructions with several results.
#[derive(Clone, Debug)]
pub(crate) struct Program {
    instructions: Vec<Instruction>,
    outputs: Vec<usize>,
}

impl Program {
    /// A plan whose divisions are written as quotients.
    pub(crate) fn of(plan: &Plan, symbols: &Symbols) -> Self {
        Self::new(plan, symbols, false)
    }

    /// The kernel of a step, where 1/d is the scalar's reciprocal.
    pub(super) fn of_kernel(plan: &Plan, symbols: &Symbols) -> Self {
        Self::new(plan, symbols, true)
    }

    fn new(plan: &Plan, symbols: &Symbols, is_kernel: bool) -> Self {
        let is_one = |node: Node| matches!(&plan.operations[node.0], Operation::Constant(value) if value.as_i64() == Some(1));
        let input = |variable: Variable| Instruction::Input(symbols.symbol(variable));
        let instruction = |operation: &Operation| match *operation {
            Operation::Input(variable) => input(variable),
            Operation::Prepared(index) => Instruction::Prepared(index),
            Operation::Constant(ref value) => Instruction::Literal(Literal::from(value)),
            Operation::Negate(a) => Instruction::Negate(a.0),
            Operation::Add(a, b) => Instruction::Add(a.0, b.0),
            Operation::Subtract(a, b) => Instruction::Subtract(a.0, b.0),
            Operation::Multiply(a, b) => Instruction::Multiply(a.0, b.0),
            Operation::Divide(a, b) if is_kernel && is_one(a) => Instruction::Reciprocal(b.0),
            Operation::Divide(a, b) => Instruction::Divide(a.0, b.0),
            Operation::MultiplyAdd(a, b, c) => Instruction::MultiplyAdd(a.0, b.0, c.0),
            Operation::MultiplySubtract(a, b, c) => Instruction::MultiplySubtract(a.0, b.0, c.0),
            Operation::SubtractProduct(a, b, c) => Instruction::SubtractProduct(a.0, b.0, c.0),
        };
        Program {
            instructions: plan.operations.iter().map(instruction).collect(),
            outputs: plan.outputs.iter().map(|output| output.0).collect(),
        }
    }

    /// The results, or `None` where a division by zero has no value in this scalar.
    ///
    /// # Panics
    /// If an input is missing.
    pub(super) fn run<T: Scalar>(&self, inputs: &Inputs<'_, T>) -> Option<Vec<T>> {
        self.run_with(inputs, T::quotient)
    }

    /// The results, divisions written as generated code has them outside of kernels.
    ///
    /// # Panics
    /// If an input is missing; for exact scalars, at a division by zero.
    pub(crate) fn values<T: Scalar>(&self, inputs: &Inputs<'_, T>) -> Vec<T> {
        self.run_with(inputs, |a, b| Some(a / b)).unwrap_or_else(|| unreachable!("only kernels have poles"))
    }

    fn run_with<T: Scalar>(
        &self,
        inputs: &Inputs<'_, T>,
        divide: impl Fn(T, T) -> Option<T>,
    ) -> Option<Vec<T>> {
        let mut registers: Vec<T> = Vec::with_capacity(self.instructions.len());
        for instruction in &self.instructions {
            let at = |index: usize| registers[index].clone();
            let value = match *instruction {
                Instruction::Input(symbol) => inputs.value(symbol),
                Instruction::Prepared(index) => inputs.prepared[index].clone(),
                Instruction::Literal(ref literal) => T::constant(&literal.as_constant()),
                Instruction::Add(a, b) => at(a) + at(b),
                Instruction::Subtract(a, b) => at(a) - at(b),
                Instruction::Multiply(a, b) => at(a) * at(b),
                Instruction::Divide(a, b) => divide(at(a), at(b))?,
                Instruction::Reciprocal(a) => registers[a].reciprocal()?,
                Instruction::Negate(a) => -at(a),
                Instruction::MultiplyAdd(a, b, c) => at(a).multiply_add(at(b), at(c)),
                Instruction::MultiplySubtract(a, b, c) => at(a).multiply_subtract(at(b), at(c)),
                Instruction::SubtractProduct(a, b, c) => at(a).subtract_product(at(b), at(c)),
            };
            registers.push(value);
        }
        Some(self.outputs.iter().map(|&output| registers[output].clone()).collect())
    }
}

impl<T: Scalar> Inputs<'_, T> {
    fn value(&self, symbol: Symbol) -> T {
        match symbol {
            Symbol::State(i) => self.state[i].clone(),
            Symbol::SecondState(i) => self.other[i].clone(),
            Symbol::Parameter(k) => self.parameters[k].clone(),
            Symbol::Epsilon => {
                self.eps.cloned().unwrap_or_else(|| unreachable!("a field has no epsilon in it"))
            }
        }
    }
}
