//! A plan prepared for evaluation over any scalar; names are resolved, and each node has a
//! register.
//!
//! In: a plan; for each evaluation, constants and a state in the caller's registers. Out: results
//! with the bits of generated code.

use std::marker::PhantomData;

use kahan_algebra::plan::{Input, Operation, Plan, variables};
use kahan_algebra::symbols::{Symbol, Symbols};
use kahan_core::Scalar;
use kahan_program::{Arithmetic, Calls, Function, Node, Program};

use crate::literal::Literal;

type Instruction = kahan_program::Operation<usize, Box<Literal>, Reciprocal>;

/// A straight-line program with several results.
///
/// The registers hold, in order: the constants, the numbers in the plan, the states, and the
/// computed values. The constants are the parameters and ε. If a step consists of two programs, the
/// constants of the second are the results of the first.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    program: Program<Vec<Instruction>>,
    constants: usize,
    /// The number of constants, including the numbers of the plan.
    given: usize,
    /// The number of coordinates of all points that the program reads.
    states: usize,
    has_poles: bool,
}

#[derive(Clone, Copy, Debug)]
struct Reciprocal;

impl Function for Reciprocal {
    fn arguments(&self) -> usize {
        1
    }
}

struct ScalarArithmetic<V> {
    has_poles: bool,
    scalar: PhantomData<V>,
}

impl<V: Scalar> Arithmetic for ScalarArithmetic<V> {
    type Value = V;
    type Constant = Box<Literal>;

    fn constant(&self, value: &Box<Literal>) -> Option<V> {
        Some(V::constant(&value.as_constant()))
    }

    #[inline(always)]
    fn add(&self, a: &V, b: &V) -> V {
        a.clone() + b.clone()
    }

    #[inline(always)]
    fn subtract(&self, a: &V, b: &V) -> V {
        a.clone() - b.clone()
    }

    #[inline(always)]
    fn multiply(&self, a: &V, b: &V) -> V {
        a.clone() * b.clone()
    }

    #[inline(always)]
    fn negate(&self, a: &V) -> V {
        -a.clone()
    }

    #[inline(always)]
    fn divide(&self, a: &V, b: &V) -> Option<V> {
        if self.has_poles { a.clone().quotient(b.clone()) } else { Some(a.clone() / b.clone()) }
    }

    #[inline(always)]
    fn multiply_add(&self, a: &V, b: &V, c: &V) -> V {
        a.clone().multiply_add(b.clone(), c.clone())
    }

    #[inline(always)]
    fn multiply_subtract(&self, a: &V, b: &V, c: &V) -> V {
        a.clone().multiply_subtract(b.clone(), c.clone())
    }

    #[inline(always)]
    fn subtract_product(&self, a: &V, b: &V, c: &V) -> V {
        a.clone().subtract_product(b.clone(), c.clone())
    }

    fn is_zero(&self, a: &V) -> bool {
        a.is_zero()
    }
}

impl<V: Scalar> Calls<Reciprocal> for ScalarArithmetic<V> {
    #[inline(always)]
    fn call(&self, _: &Reciprocal, a: &V, _: &V) -> Option<V> {
        a.reciprocal()
    }
}

impl Line {
    /// Prepares a plan whose inputs are states, parameters and ε.
    pub(crate) fn of(plan: &Plan, symbols: &Symbols) -> Self {
        Self::new(plan, symbols, symbols.parameters.len() + 1, false)
    }

    /// Prepares a plan. After a division by zero, a run of the program returns `None`.
    pub(crate) fn with_checked_divisions(plan: &Plan, symbols: &Symbols) -> Self {
        Self::new(plan, symbols, symbols.parameters.len() + 1, true)
    }

    /// Prepares the second program of a step, which reads the state. Its constants are the
    /// `prepared` results of the first program. After a division by zero, a run returns `None`.
    pub(crate) fn of_kernel(plan: &Plan, symbols: &Symbols, prepared: usize) -> Self {
        Self::new(plan, symbols, prepared, true)
    }

    fn new(plan: &Plan, symbols: &Symbols, constants: usize, has_poles: bool) -> Self {
        let points = variables(plan).into_iter().map(|variable| match symbols.symbol(variable) {
            Symbol::State(_) => 1,
            Symbol::SecondState(_) => 2,
            Symbol::Parameter(_) | Symbol::Epsilon => 0,
        });
        let states = points.max().unwrap_or(0) * symbols.dimension();
        let mut operations: Vec<Instruction> = (0..constants).map(Instruction::Input).collect();
        operations.extend(plan.operations.iter().filter_map(|operation| match operation {
            Operation::Constant(value) => Some(Instruction::Constant(Box::new(Literal::from(value)))),
            _ => None,
        }));
        let given = operations.len();
        operations.extend((given..given + states).map(Instruction::Input));
        let mut literals = (constants..given).map(Node);
        let mut one = None;
        let mut registers: Vec<Node> = Vec::with_capacity(plan.operations.len());
        for operation in &plan.operations {
            let at = |node: Node| registers[node.0];
            let computed = match *operation {
                Operation::Input(input) => {
                    registers.push(Node(match input {
                        Input::Prepared(index) => index,
                        Input::Variable(variable) => match symbols.symbol(variable) {
                            Symbol::Parameter(k) => k,
                            Symbol::Epsilon => symbols.parameters.len(),
                            Symbol::State(i) => given + i,
                            Symbol::SecondState(i) => given + symbols.dimension() + i,
                        },
                    }));
                    continue;
                }
                Operation::Constant(ref value) => {
                    let literal = literals.next().expect("a register for each constant");
                    one = one.or((value.as_i64() == Some(1)).then_some(literal));
                    registers.push(literal);
                    continue;
                }
                Operation::Divide(a, b) if has_poles && one == Some(at(a)) => {
                    Instruction::Call(Reciprocal, at(b), at(b))
                }
                _ => operation.computed(at).expect("a plan calls no functions"),
            };
            registers.push(Node(operations.len()));
            operations.push(computed);
        }
        let outputs = plan.outputs.iter().map(|output| registers[output.0]).collect();
        Line { program: Program { operations, outputs }, constants, given, states, has_poles }
    }

    /// Writes the constants and the numbers of the plan into the first registers.
    pub(crate) fn give<V: Scalar>(&self, constants: impl IntoIterator<Item = V>, registers: &mut [V]) {
        let mut constants = constants.into_iter();
        for (register, operation) in registers.iter_mut().zip(&self.program.operations[..self.given]) {
            *register = match operation {
                Instruction::Constant(literal) => V::constant(&literal.as_constant()),
                _ => constants.next().expect("as many constants as the line has"),
            };
        }
    }

    pub(crate) fn given(&self) -> usize {
        self.given
    }

    pub(crate) fn outputs(&self) -> usize {
        self.program.outputs.len()
    }

    pub(crate) fn registers(&self) -> usize {
        self.program.operations.len()
    }

    /// Returns ε, the last constant; not for programs made by [`of_kernel`](Self::of_kernel).
    pub(crate) fn eps<V: Clone>(&self, registers: &[V]) -> V {
        registers[self.constants - 1].clone()
    }

    /// Runs the program in its registers; `None` if it divides by 0 and the scalar has no 1/0.
    #[inline(always)]
    pub(crate) fn run<'a, V: Scalar>(
        &'a self,
        registers: &'a mut [V],
        state: &[V],
    ) -> Option<Results<'a, V>> {
        let first = self.given + self.states;
        registers[self.given..first].clone_from_slice(&state[..self.states]);
        let scalars = ScalarArithmetic { has_poles: self.has_poles, scalar: PhantomData };
        self.program.compute(&scalars, first, registers)?;
        Some(Results { registers, places: &self.program.outputs })
    }

    pub(crate) fn has_divided_by_zero<V: Scalar>(&self, registers: &[V]) -> bool {
        self.program.operations.iter().any(|operation| match *operation {
            Instruction::Divide(_, divisor) | Instruction::Call(Reciprocal, divisor, _) => {
                registers[divisor.0].is_zero()
            }
            _ => false,
        })
    }

    pub(crate) fn results<'a, V: Scalar>(
        &'a self,
        constants: impl IntoIterator<Item = V>,
        registers: &'a mut [V],
        state: &[V],
    ) -> Option<Results<'a, V>> {
        self.give(constants, registers);
        self.run(registers, state)
    }

    /// Runs the program once, after resizing the registers.
    ///
    /// # Panics
    /// If a division by zero has no value in the scalar.
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

#[derive(Debug)]
pub(crate) struct Results<'a, V> {
    registers: &'a [V],
    places: &'a [Node],
}

impl<'a, V: Clone> Results<'a, V> {
    #[inline]
    pub(crate) fn get(&self, index: usize) -> V {
        self.registers[self.places[index].0].clone()
    }

    #[inline(always)]
    pub(crate) fn iter(&self) -> impl ExactSizeIterator<Item = V> + use<'a, V> {
        let registers = self.registers;
        self.places.iter().map(|place| registers[place.0].clone())
    }
}

/// Unwraps a value. Floats always have a value, and exact scalars have one if the field is defined.
///
/// # Panics
/// If the value is `None`.
#[inline(always)]
pub(crate) fn has_value<V>(value: Option<V>) -> V {
    value.unwrap_or_else(|| panic!("an exact number is divided by zero"))
}
