//! A plan made ready to run over states that are slices: names resolved, registers numbered.
//!
//! The instructions and their order are the plan's, and each is the call that generated code makes
//! for it, so the bits are the same.

use kahan_algebra::plan::{Node, Operation, Plan};
use kahan_algebra::symbols::{Symbol, Symbols};
use kahan_core::Scalar;

use crate::interpreted::Literal;

/// One instruction; operands are earlier registers.
#[derive(Clone, Copy, Debug)]
enum Instruction {
    Add(u32, u32),
    Subtract(u32, u32),
    Multiply(u32, u32),
    Divide(u32, u32),
    /// 1/d in a kernel.
    Reciprocal(u32),
    /// n/d in a kernel.
    Quotient(u32, u32),
    Negate(u32),
    MultiplyAdd(u32, u32, u32),
    MultiplySubtract(u32, u32, u32),
    SubtractProduct(u32, u32, u32),
}

/// Straight-line instructions with several results.
///
/// Registers are numbered in the order in which they are filled: with the constants (the parameters
/// and ε, or in a kernel what was prepared), the numbers that the plan writes out, the states, and
/// the result of each instruction.
#[derive(Clone, Debug)]
pub(super) struct Line {
    constants: usize,
    literals: Vec<Literal>,
    /// All of them, or none where the line reads none.
    states: usize,
    instructions: Vec<Instruction>,
    results: Vec<u32>,
}

impl Line {
    /// A plan of the states, the parameters and ε, whose divisions are written as quotients.
    pub(super) fn of(plan: &Plan, symbols: &Symbols) -> Self {
        Self::new(plan, symbols, symbols.parameters.len() + 1, false)
    }

    /// The kernel of a step with so many prepared constants, where a reciprocal is one of the
    /// scalar.
    pub(super) fn of_kernel(plan: &Plan, symbols: &Symbols, prepared: usize) -> Self {
        Self::new(plan, symbols, prepared, true)
    }

    fn new(plan: &Plan, symbols: &Symbols, constants: usize, is_kernel: bool) -> Self {
        let literal = |operation: &Operation| match operation {
            Operation::Constant(value) => Some(Literal::from(value)),
            _ => None,
        };
        let has_states = plan.inputs().iter().any(|variable| symbols.is_state(*variable));
        let mut line = Line {
            constants,
            literals: plan.operations.iter().filter_map(literal).collect(),
            states: if has_states { symbols.dimension() } else { 0 },
            instructions: Vec::new(),
            results: Vec::new(),
        };
        let (mut literals, states) = (constants.., line.given());
        let mut places: Vec<usize> = Vec::with_capacity(plan.operations.len());
        for operation in &plan.operations {
            let place = match *operation {
                Operation::Prepared(index) => Some(index),
                Operation::Constant(_) => literals.next(),
                Operation::Input(variable) => Some(match symbols.symbol(variable) {
                    Symbol::Parameter(k) => k,
                    Symbol::Epsilon => symbols.parameters.len(),
                    Symbol::State(i) => states + i,
                    Symbol::SecondState(_) => unreachable!("a line has one state"),
                }),
                _ => None,
            };
            places.push(place.unwrap_or_else(|| {
                line.instructions.push(instruction(plan, operation, &places, is_kernel));
                states + line.states + line.instructions.len() - 1
            }));
        }
        line.results = plan.outputs.iter().map(|output| register(&places, *output)).collect();
        line
    }

    /// Appends what the first registers hold whatever the state.
    pub(super) fn give<V: Scalar>(&self, constants: &[V], given: &mut Vec<V>) {
        given.extend_from_slice(&constants[..self.constants]);
        given.extend(self.literals.iter().map(|literal| V::constant(&literal.as_constant())));
    }

    /// How much is [given](Self::give).
    pub(super) fn given(&self) -> usize {
        self.constants + self.literals.len()
    }

    /// How many registers it takes.
    pub(super) fn registers(&self) -> usize {
        self.given() + self.states + self.instructions.len()
    }

    /// ε, which is the last of the constants outside of kernels.
    pub(super) fn eps<V: Copy>(&self, registers: &[V]) -> V {
        registers[self.constants - 1]
    }

    /// Appends the registers of the line, filled with what is given.
    pub(super) fn open<V: Scalar + Copy>(&self, given: &[V], registers: &mut Vec<V>) {
        registers.extend_from_slice(given);
        registers.resize(registers.len() + self.registers() - given.len(), V::zero());
    }

    /// Runs the line in its registers, and shows its results. What was given stays, so that the
    /// line can be run again.
    #[inline(always)]
    pub(super) fn run<'a, V: Scalar + Copy>(
        &'a self,
        registers: &'a mut [V],
        state: &[V],
    ) -> impl ExactSizeIterator<Item = V> + use<'a, V> {
        let first = self.given() + self.states;
        registers[self.given()..first].copy_from_slice(&state[..self.states]);
        for (to, instruction) in (first..).zip(&self.instructions) {
            let at = |register: u32| registers[register as usize];
            registers[to] = match *instruction {
                Instruction::Add(a, b) => at(a) + at(b),
                Instruction::Subtract(a, b) => at(a) - at(b),
                Instruction::Multiply(a, b) => at(a) * at(b),
                Instruction::Divide(a, b) => at(a) / at(b),
                Instruction::Reciprocal(d) => has_value(at(d).reciprocal()),
                Instruction::Quotient(a, b) => has_value(at(a).quotient(at(b))),
                Instruction::Negate(a) => -at(a),
                Instruction::MultiplyAdd(a, b, c) => at(a).multiply_add(at(b), at(c)),
                Instruction::MultiplySubtract(a, b, c) => at(a).multiply_subtract(at(b), at(c)),
                Instruction::SubtractProduct(a, b, c) => at(a).subtract_product(at(b), at(c)),
            };
        }
        self.results.iter().map(|result| registers[*result as usize])
    }

    /// The results of a single run; what `registers` hold is lost.
    pub(super) fn results<'a, V: Scalar + Copy>(
        &'a self,
        constants: &[V],
        registers: &'a mut Vec<V>,
        state: &[V],
    ) -> impl ExactSizeIterator<Item = V> + use<'a, V> {
        registers.clear();
        self.give(constants, registers);
        registers.resize(self.registers(), V::zero());
        self.run(registers, state)
    }
}

/// Floats, and what is made of them, can be divided by zero.
#[inline(always)]
pub(super) fn has_value<V>(quotient: Option<V>) -> V {
    quotient.unwrap_or_else(|| unreachable!("floats have a reciprocal of zero"))
}

fn register(places: &[usize], node: Node) -> u32 {
    u32::try_from(places[node.0]).unwrap_or_else(|_| unreachable!("plans have a budget of terms"))
}

fn instruction(plan: &Plan, operation: &Operation, places: &[usize], is_kernel: bool) -> Instruction {
    let at = |node: Node| register(places, node);
    let is_one =
        |node: Node| matches!(&plan.operations[node.0], Operation::Constant(one) if one.as_i64() == Some(1));
    match *operation {
        Operation::Add(a, b) => Instruction::Add(at(a), at(b)),
        Operation::Subtract(a, b) => Instruction::Subtract(at(a), at(b)),
        Operation::Multiply(a, b) => Instruction::Multiply(at(a), at(b)),
        Operation::Divide(a, b) if is_kernel && is_one(a) => Instruction::Reciprocal(at(b)),
        Operation::Divide(a, b) if is_kernel => Instruction::Quotient(at(a), at(b)),
        Operation::Divide(a, b) => Instruction::Divide(at(a), at(b)),
        Operation::Negate(a) => Instruction::Negate(at(a)),
        Operation::MultiplyAdd(a, b, c) => Instruction::MultiplyAdd(at(a), at(b), at(c)),
        Operation::MultiplySubtract(a, b, c) => Instruction::MultiplySubtract(at(a), at(b), at(c)),
        Operation::SubtractProduct(a, b, c) => Instruction::SubtractProduct(at(a), at(b), at(c)),
        Operation::Input(_) | Operation::Prepared(_) | Operation::Constant(_) => {
            unreachable!("these are no instructions")
        }
    }
}
