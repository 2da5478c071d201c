//! A plan made ready to run over any scalar: names resolved, registers numbered.
//!
//! The instructions and their order are the plan's, and each is the call that generated code makes
//! for it, so the bits are the same. Whoever runs a line brings its registers.

use kahan_algebra::plan::{Node, Operation, Plan};
use kahan_algebra::poly::Variable;
use kahan_algebra::symbols::{Symbol, Symbols};
use kahan_core::Scalar;

use crate::literal::Literal;

/// One instruction; operands are earlier registers.
#[derive(Clone, Copy, Debug)]
enum Instruction {
    Add(u32, u32),
    Subtract(u32, u32),
    Multiply(u32, u32),
    Divide(u32, u32),
    /// 1/d where it may have no value.
    Reciprocal(u32),
    /// n/d where it may have no value.
    Quotient(u32, u32),
    Negate(u32),
    MultiplyAdd(u32, u32, u32),
    MultiplySubtract(u32, u32, u32),
    SubtractProduct(u32, u32, u32),
}

/// Straight-line instructions with several results.
///
/// Registers are numbered in the order in which they are filled: with the constants (the parameters
/// and ε, or in a kernel what was prepared), the numbers that the plan writes out, the states
/// (those of a second point behind those of the first), and the result of each instruction.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    constants: usize,
    literals: Vec<Literal>,
    /// Those of as many points as the line reads.
    states: usize,
    instructions: Vec<Instruction>,
    results: Vec<u32>,
}

impl Line {
    /// A plan of the states, the parameters and ε, whose divisions are written as quotients.
    pub(crate) fn of(plan: &Plan, symbols: &Symbols) -> Self {
        Self::new(plan, symbols, symbols.parameters.len() + 1, false)
    }

    /// The same where a division by zero may have no value.
    pub(crate) fn with_poles(plan: &Plan, symbols: &Symbols) -> Self {
        Self::new(plan, symbols, symbols.parameters.len() + 1, true)
    }

    /// The kernel of a step with so many prepared constants, where a division by zero may have no
    /// value.
    pub(crate) fn of_kernel(plan: &Plan, symbols: &Symbols, prepared: usize) -> Self {
        Self::new(plan, symbols, prepared, true)
    }

    fn new(plan: &Plan, symbols: &Symbols, constants: usize, has_poles: bool) -> Self {
        let literal = |operation: &Operation| match operation {
            Operation::Constant(value) => Some(Literal::from(value)),
            _ => None,
        };
        let points = |variable: &Variable| match symbols.symbol(*variable) {
            Symbol::State(_) => 1,
            Symbol::SecondState(_) => 2,
            Symbol::Parameter(_) | Symbol::Epsilon => 0,
        };
        let points = plan.inputs().iter().map(points).max().unwrap_or(0);
        let mut line = Line {
            constants,
            literals: plan.operations.iter().filter_map(literal).collect(),
            states: points * symbols.dimension(),
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
                    Symbol::SecondState(i) => states + symbols.dimension() + i,
                }),
                _ => None,
            };
            places.push(place.unwrap_or_else(|| {
                line.instructions.push(instruction(plan, operation, &places, has_poles));
                states + line.states + line.instructions.len() - 1
            }));
        }
        line.results = plan.outputs.iter().map(|output| register(&places, *output)).collect();
        line
    }

    /// Puts into the first registers what they hold whatever the state.
    pub(crate) fn give<V: Scalar>(&self, constants: impl IntoIterator<Item = V>, registers: &mut [V]) {
        let literals = self.literals.iter().map(|literal| V::constant(&literal.as_constant()));
        let given = constants.into_iter().take(self.constants).chain(literals);
        registers.iter_mut().zip(given).for_each(|(register, given)| *register = given);
    }

    /// How much is [given](Self::give).
    pub(crate) fn given(&self) -> usize {
        self.constants + self.literals.len()
    }

    /// How many registers it takes.
    pub(crate) fn registers(&self) -> usize {
        self.given() + self.states + self.instructions.len()
    }

    /// ε, which is the last of the constants outside of kernels.
    pub(crate) fn eps<V: Clone>(&self, registers: &[V]) -> V {
        registers[self.constants - 1].clone()
    }

    /// Runs the line in its registers, and shows its results; `None` where a division by zero has
    /// no value in this scalar. What was given stays, so that the line can be run again.
    #[inline(always)]
    pub(crate) fn run<'a, V: Scalar>(
        &'a self,
        registers: &'a mut [V],
        state: &[V],
    ) -> Option<Results<'a, V>> {
        let first = self.given() + self.states;
        registers[self.given()..first].clone_from_slice(&state[..self.states]);
        for (to, instruction) in (first..).zip(&self.instructions) {
            let at = |register: u32| registers[register as usize].clone();
            registers[to] = match *instruction {
                Instruction::Add(a, b) => at(a) + at(b),
                Instruction::Subtract(a, b) => at(a) - at(b),
                Instruction::Multiply(a, b) => at(a) * at(b),
                Instruction::Divide(a, b) => at(a) / at(b),
                Instruction::Reciprocal(d) => registers[d as usize].reciprocal()?,
                Instruction::Quotient(a, b) => at(a).quotient(at(b))?,
                Instruction::Negate(a) => -at(a),
                Instruction::MultiplyAdd(a, b, c) => at(a).multiply_add(at(b), at(c)),
                Instruction::MultiplySubtract(a, b, c) => at(a).multiply_subtract(at(b), at(c)),
                Instruction::SubtractProduct(a, b, c) => at(a).subtract_product(at(b), at(c)),
            };
        }
        Some(Results { registers, places: &self.results })
    }

    /// Whether the run that has filled these registers divides by zero.
    pub(crate) fn has_divided_by_zero<V: Scalar>(&self, registers: &[V]) -> bool {
        self.instructions.iter().any(|instruction| match *instruction {
            Instruction::Divide(_, d) | Instruction::Reciprocal(d) | Instruction::Quotient(_, d) => {
                registers[d as usize].is_zero()
            }
            _ => false,
        })
    }

    /// The results of a single run.
    pub(crate) fn results<'a, V: Scalar>(
        &'a self,
        constants: impl IntoIterator<Item = V>,
        registers: &'a mut [V],
        state: &[V],
    ) -> Option<Results<'a, V>> {
        self.give(constants, registers);
        self.run(registers, state)
    }
}

/// The results of a run, in its registers.
#[derive(Debug)]
pub(crate) struct Results<'a, V> {
    registers: &'a [V],
    places: &'a [u32],
}

impl<'a, V: Clone> Results<'a, V> {
    /// The result with this index.
    #[inline]
    pub(crate) fn get(&self, index: usize) -> V {
        self.registers[self.places[index] as usize].clone()
    }

    /// All of them, in order.
    #[inline(always)]
    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = V> + use<'a, V> {
        let registers = self.registers;
        self.places.iter().map(|place| registers[*place as usize].clone())
    }
}

/// What has a value over floats at any place, and over exact scalars wherever the field is defined.
///
/// # Panics
/// Where it has none.
#[inline(always)]
pub(crate) fn has_value<V>(value: Option<V>) -> V {
    value.unwrap_or_else(|| panic!("an exact number is divided by zero"))
}

fn register(places: &[usize], node: Node) -> u32 {
    u32::try_from(places[node.0]).unwrap_or_else(|_| unreachable!("plans have a budget of terms"))
}

fn instruction(plan: &Plan, operation: &Operation, places: &[usize], has_poles: bool) -> Instruction {
    let at = |node: Node| register(places, node);
    let is_one =
        |node: Node| matches!(&plan.operations[node.0], Operation::Constant(one) if one.as_i64() == Some(1));
    match *operation {
        Operation::Add(a, b) => Instruction::Add(at(a), at(b)),
        Operation::Subtract(a, b) => Instruction::Subtract(at(a), at(b)),
        Operation::Multiply(a, b) => Instruction::Multiply(at(a), at(b)),
        Operation::Divide(a, b) if has_poles && is_one(a) => Instruction::Reciprocal(at(b)),
        Operation::Divide(a, b) if has_poles => Instruction::Quotient(at(a), at(b)),
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
