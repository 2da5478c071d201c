//! A plan made ready to run over any scalar: names resolved, constants in the form that scalars are
//! built from.
//!
//! The instructions and their order are the plan's, and each is the call that generated code makes
//! for it, so the bits are the same. A run fills its registers in order: with what is given whatever
//! the state, which a prepared step keeps from run to run, with the states, and with the result of
//! each instruction.

use std::sync::Arc;

use kahan_algebra::plan::{Node, Operation, Plan};
use kahan_algebra::symbols::{Symbol, Symbols};
use kahan_core::Scalar;
use smallvec::SmallVec;

use super::literal::Literal;

/// The registers of a run. So many are on the stack; a program that needs more allocates them at
/// once.
pub(super) type Registers<T> = SmallVec<[T; 64]>;

/// Where a program's inputs are.
#[derive(Debug)]
pub(super) struct Inputs<'a, T> {
    /// What the first registers hold, where that has been [kept](Program::keep).
    pub(super) kept: &'a [T],
    pub(super) state: &'a [T],
    /// The second point of a bilinear form.
    pub(super) other: &'a [T],
    pub(super) parameters: &'a [T],
    /// ε, where the program reads it.
    pub(super) eps: Option<&'a T>,
    /// The constants that a kernel reads.
    pub(super) prepared: &'a [T],
}

impl<T> Default for Inputs<'_, T> {
    fn default() -> Self {
        Inputs { kept: &[], state: &[], other: &[], parameters: &[], eps: None, prepared: &[] }
    }
}

/// What a register holds from the beginning.
#[derive(Clone, Debug)]
enum Given {
    Input(Symbol),
    Prepared(usize),
    Literal(Literal),
}

impl Given {
    fn is_state(&self) -> bool {
        matches!(self, Self::Input(Symbol::State(_) | Symbol::SecondState(_)))
    }
}

/// The index of a register.
type Register = u32;

/// One instruction; operands are earlier registers.
#[derive(Clone, Copy, Debug)]
enum Instruction {
    Add(Register, Register),
    Subtract(Register, Register),
    Multiply(Register, Register),
    Divide(Register, Register),
    /// 1/d in a kernel.
    Reciprocal(Register),
    Negate(Register),
    MultiplyAdd(Register, Register, Register),
    MultiplySubtract(Register, Register, Register),
    SubtractProduct(Register, Register, Register),
}

/// Straight-line instructions with several results.
#[derive(Clone, Debug)]
pub(super) struct Program {
    /// What the first registers hold.
    given: Vec<Given>,
    /// How many of these depend on no state; they come first.
    kept: usize,
    instructions: Vec<Instruction>,
    outputs: Vec<Register>,
}

impl Program {
    /// A plan whose divisions are written as quotients.
    pub(super) fn of(plan: &Plan, symbols: &Symbols) -> Self {
        Self::new(plan, symbols, false)
    }

    /// The kernel of a step, where 1/d is the scalar's reciprocal.
    pub(super) fn of_kernel(plan: &Plan, symbols: &Symbols) -> Self {
        Self::new(plan, symbols, true)
    }

    fn new(plan: &Plan, symbols: &Symbols, is_kernel: bool) -> Self {
        let given = |operation: &Operation| match operation {
            Operation::Input(variable) => Some(Given::Input(symbols.symbol(*variable))),
            Operation::Prepared(index) => Some(Given::Prepared(*index)),
            Operation::Constant(value) => Some(Given::Literal(Literal::from(value))),
            _ => None,
        };
        let (mut givens, mut computed): (Vec<_>, Vec<_>) = (Vec::new(), Vec::new());
        for (node, operation) in plan.operations.iter().enumerate() {
            match given(operation) {
                Some(given) => givens.push((node, given)),
                None => computed.push(node),
            }
        }
        givens.sort_by_key(|(_, given)| given.is_state());
        let mut registers = vec![0; plan.operations.len()];
        let order = givens.iter().map(|(node, _)| node).chain(&computed);
        (0..).zip(order).for_each(|(register, node)| registers[*node] = register);

        let is_one = |node: Node| matches!(&plan.operations[node.0], Operation::Constant(value) if value.as_i64() == Some(1));
        let at = |node: Node| registers[node.0];
        let instruction = |operation: &Operation| match *operation {
            Operation::Input(_) | Operation::Prepared(_) | Operation::Constant(_) => None,
            Operation::Negate(a) => Some(Instruction::Negate(at(a))),
            Operation::Add(a, b) => Some(Instruction::Add(at(a), at(b))),
            Operation::Subtract(a, b) => Some(Instruction::Subtract(at(a), at(b))),
            Operation::Multiply(a, b) => Some(Instruction::Multiply(at(a), at(b))),
            Operation::Divide(a, b) if is_kernel && is_one(a) => Some(Instruction::Reciprocal(at(b))),
            Operation::Divide(a, b) => Some(Instruction::Divide(at(a), at(b))),
            Operation::MultiplyAdd(a, b, c) => Some(Instruction::MultiplyAdd(at(a), at(b), at(c))),
            Operation::MultiplySubtract(a, b, c) => Some(Instruction::MultiplySubtract(at(a), at(b), at(c))),
            Operation::SubtractProduct(a, b, c) => Some(Instruction::SubtractProduct(at(a), at(b), at(c))),
        };
        Program {
            kept: givens.partition_point(|(_, given)| !given.is_state()),
            given: givens.into_iter().map(|(_, given)| given).collect(),
            instructions: plan.operations.iter().filter_map(instruction).collect(),
            outputs: plan.outputs.iter().map(|output| at(*output)).collect(),
        }
    }

    /// What the first registers hold whatever the state.
    ///
    /// # Panics
    /// If an input is missing.
    pub(super) fn keep<T: Scalar>(&self, inputs: &Inputs<'_, T>) -> Arc<[T]> {
        self.given[..self.kept].iter().map(|given| inputs.value(given)).collect()
    }

    /// The results, or `None` where a division by zero has no value in this scalar.
    ///
    /// # Panics
    /// If an input is missing.
    pub(super) fn run<'a, T: Scalar>(
        &'a self,
        inputs: &Inputs<'_, T>,
        registers: &'a mut Registers<T>,
    ) -> Option<Results<'a, T>> {
        self.run_with(inputs, registers, T::quotient)
    }

    /// The results, divisions written as generated code has them outside of kernels.
    ///
    /// # Panics
    /// If an input is missing; for exact scalars, at a division by zero.
    pub(super) fn values<'a, T: Scalar>(
        &'a self,
        inputs: &Inputs<'_, T>,
        registers: &'a mut Registers<T>,
    ) -> Results<'a, T> {
        self.run_with(inputs, registers, |a, b| Some(a / b))
            .unwrap_or_else(|| unreachable!("only kernels have poles"))
    }

    fn run_with<'a, T: Scalar>(
        &'a self,
        inputs: &Inputs<'_, T>,
        registers: &'a mut Registers<T>,
        divide: impl Fn(T, T) -> Option<T>,
    ) -> Option<Results<'a, T>> {
        registers.resize(self.given.len() + self.instructions.len(), T::zero());
        // Once, and not for each operand: whether they are on the stack is asked here.
        let registers = registers.as_mut_slice();
        let kept = inputs.kept.len();
        registers[..kept].clone_from_slice(inputs.kept);
        for (to, given) in (kept..).zip(&self.given[kept..]) {
            registers[to] = inputs.value(given);
        }
        for (to, instruction) in (self.given.len()..).zip(&self.instructions) {
            let at = |register: Register| registers[register as usize].clone();
            registers[to] = match *instruction {
                Instruction::Add(a, b) => at(a) + at(b),
                Instruction::Subtract(a, b) => at(a) - at(b),
                Instruction::Multiply(a, b) => at(a) * at(b),
                Instruction::Divide(a, b) => divide(at(a), at(b))?,
                Instruction::Reciprocal(a) => registers[a as usize].reciprocal()?,
                Instruction::Negate(a) => -at(a),
                Instruction::MultiplyAdd(a, b, c) => at(a).multiply_add(at(b), at(c)),
                Instruction::MultiplySubtract(a, b, c) => at(a).multiply_subtract(at(b), at(c)),
                Instruction::SubtractProduct(a, b, c) => at(a).subtract_product(at(b), at(c)),
            };
        }
        Some(Results { registers, outputs: &self.outputs })
    }
}

/// The results of a run, in its registers.
#[derive(Debug)]
pub(super) struct Results<'a, T> {
    registers: &'a [T],
    outputs: &'a [Register],
}

impl<T: Clone> Results<'_, T> {
    /// The result with this index.
    #[inline]
    pub(super) fn get(&self, index: usize) -> T {
        self.registers[self.outputs[index] as usize].clone()
    }

    /// All of them, in order.
    pub(super) fn iter(&self) -> impl ExactSizeIterator<Item = T> {
        self.outputs.iter().map(|register| self.registers[*register as usize].clone())
    }
}

impl<T: Scalar> Inputs<'_, T> {
    #[inline]
    fn value(&self, given: &Given) -> T {
        match given {
            Given::Input(Symbol::State(i)) => self.state[*i].clone(),
            Given::Input(Symbol::SecondState(i)) => self.other[*i].clone(),
            Given::Input(Symbol::Parameter(k)) => self.parameters[*k].clone(),
            Given::Input(Symbol::Epsilon) => {
                self.eps.cloned().unwrap_or_else(|| unreachable!("a field has no epsilon in it"))
            }
            Given::Prepared(index) => self.prepared[*index].clone(),
            Given::Literal(literal) => T::constant(&literal.as_constant()),
        }
    }
}
