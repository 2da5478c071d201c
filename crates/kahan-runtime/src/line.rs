//! A plan made ready to run over any scalar: its names are resolved, and its nodes are registers.
//!
//! The operations and their order are the plan's, and each is the call that generated code makes
//! for it, so the bits are the same. Whoever runs a line brings its registers.

use kahan_algebra::plan::{Node, Operation, Plan};
use kahan_algebra::poly::Variable;
use kahan_algebra::symbols::{Symbol, Symbols};
use kahan_core::Scalar;

use crate::literal::Literal;

/// A straight line of operations with several results.
///
/// Registers are numbered in the order in which they are filled: with the constants (the parameters
/// and ε, or in a kernel what was prepared), the numbers that the plan writes out, the states
/// (those of a second point behind those of the first), and the result of each operation.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    constants: usize,
    literals: Vec<Literal>,
    /// Those of as many points as the line reads.
    states: usize,
    /// What is computed; each operand is the node of a register.
    operations: Vec<Operation>,
    results: Vec<Node>,
    /// Whether a division may have no value. One by which 1 is divided is a reciprocal then.
    has_poles: bool,
    /// The register of the number 1.
    one: Option<Node>,
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
        let points = |variable: &Variable| match symbols.symbol(*variable) {
            Symbol::State(_) => 1,
            Symbol::SecondState(_) => 2,
            Symbol::Parameter(_) | Symbol::Epsilon => 0,
        };
        let points = plan.inputs().iter().map(points).max().unwrap_or(0);
        let numbers = plan.operations.iter().filter_map(|operation| match operation {
            Operation::Constant(value) => Some(value),
            _ => None,
        });
        let one = numbers.clone().position(|value| value.as_i64() == Some(1));
        let mut line = Line {
            constants,
            literals: numbers.map(Literal::from).collect(),
            states: points * symbols.dimension(),
            operations: Vec::new(),
            results: Vec::new(),
            has_poles,
            one: one.map(|place| Node(constants + place)),
        };
        let (mut literals, states) = (constants.., line.given());
        let mut registers: Vec<Node> = Vec::with_capacity(plan.operations.len());
        for operation in &plan.operations {
            let register = match *operation {
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
            registers.push(Node(register.unwrap_or_else(|| {
                line.operations.push(operation.with_operands(|operand| registers[operand.0]));
                line.registers() - 1
            })));
        }
        line.results = plan.outputs.iter().map(|output| registers[output.0]).collect();
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
        self.given() + self.states + self.operations.len()
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
        for (to, operation) in (first..).zip(&self.operations) {
            let at = |operand: Node| registers[operand.0].clone();
            registers[to] = match *operation {
                Operation::Add(a, b) => at(a) + at(b),
                Operation::Subtract(a, b) => at(a) - at(b),
                Operation::Multiply(a, b) => at(a) * at(b),
                Operation::Divide(a, b) if !self.has_poles => at(a) / at(b),
                Operation::Divide(a, b) if self.one == Some(a) => registers[b.0].reciprocal()?,
                Operation::Divide(a, b) => at(a).quotient(at(b))?,
                Operation::Negate(a) => -at(a),
                Operation::MultiplyAdd(a, b, c) => at(a).multiply_add(at(b), at(c)),
                Operation::MultiplySubtract(a, b, c) => at(a).multiply_subtract(at(b), at(c)),
                Operation::SubtractProduct(a, b, c) => at(a).subtract_product(at(b), at(c)),
                Operation::Input(_) | Operation::Prepared(_) | Operation::Constant(_) => {
                    unreachable!("these have registers of their own")
                }
            };
        }
        Some(Results { registers, places: &self.results })
    }

    /// Whether the run that has filled these registers divides by zero.
    pub(crate) fn has_divided_by_zero<V: Scalar>(&self, registers: &[V]) -> bool {
        self.operations.iter().any(|operation| match *operation {
            Operation::Divide(_, divisor) => registers[divisor.0].is_zero(),
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

    /// The same in registers that are made as many as it takes.
    ///
    /// # Panics
    /// Where a division by zero has no value.
    pub(crate) fn values<'a, V: Scalar + Copy>(
        &'a self,
        constants: &[V],
        registers: &'a mut Vec<V>,
        state: &[V],
    ) -> Results<'a, V> {
        registers.resize(self.registers(), V::zero());
        has_value(self.results(constants.iter().copied(), registers, state))
    }
}

/// The results of a run, in its registers.
#[derive(Debug)]
pub(crate) struct Results<'a, V> {
    registers: &'a [V],
    places: &'a [Node],
}

impl<'a, V: Clone> Results<'a, V> {
    /// The result with this index.
    #[inline]
    pub(crate) fn get(&self, index: usize) -> V {
        self.registers[self.places[index].0].clone()
    }

    /// All of them, in order.
    #[inline(always)]
    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = V> + use<'a, V> {
        let registers = self.registers;
        self.places.iter().map(|place| registers[place.0].clone())
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
