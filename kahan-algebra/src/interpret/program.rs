//! A plan whose parameters are known, ready to be run many times: what depends on no state is
//! computed once, and no run allocates more than the arithmetic itself does.

use crate::arithmetic::Arithmetic;
use crate::plan::{Node, Operation, Plan};
use crate::poly::Variable;

/// Where the value of a variable comes from.
pub(super) enum Input<V> {
    /// It is this.
    Fixed(V),
    /// The state with this index.
    State(usize),
}

/// A plan with a register for each of its steps.
#[derive(Clone, Debug)]
pub(super) struct Program<V> {
    /// `None` where a step divides by zero.
    registers: Vec<Option<V>>,
    /// Registers that hold states: register, index of the state.
    states: Vec<(usize, usize)>,
    /// Steps that depend on states, in order: register, operation.
    steps: Vec<(usize, Operation)>,
    outputs: Vec<Node>,
}

impl<V: Clone> Program<V> {
    /// Prepares a plan, given its prepared constants; the same operations in the same order as
    /// [`Plan::evaluate`].
    pub(super) fn new<A: Arithmetic<Value = V>>(
        plan: &Plan,
        arithmetic: &A,
        prepared: &[Option<V>],
        input: impl Fn(Variable) -> Input<V>,
    ) -> Self {
        let mut program = Program {
            registers: Vec::new(),
            states: Vec::new(),
            steps: Vec::new(),
            outputs: plan.outputs.clone(),
        };
        let mut varies = vec![false; plan.operations.len()];
        for (index, operation) in plan.operations.iter().enumerate() {
            program.registers.push(None);
            match operation {
                Operation::Input(variable) => match input(*variable) {
                    Input::Fixed(value) => program.registers[index] = Some(value),
                    Input::State(state) => {
                        varies[index] = true;
                        program.states.push((index, state));
                    }
                },
                Operation::Prepared(constant) => program.registers[index] = prepared[*constant].clone(),
                _ if operation.operands().any(|operand| varies[operand.0]) => {
                    varies[index] = true;
                    program.steps.push((index, operation.clone()));
                }
                _ => {
                    program.registers[index] = operation.compute(arithmetic, &program.registers);
                }
            }
        }
        program
    }

    /// Runs the plan at a state; the results stand in [`outputs`](Self::outputs) afterwards.
    pub(super) fn run<A: Arithmetic<Value = V>>(&mut self, arithmetic: &A, state: &[V]) {
        for &(register, index) in &self.states {
            self.registers[register] = Some(state[index].clone());
        }
        for (register, operation) in &self.steps {
            self.registers[*register] = operation.compute(arithmetic, &self.registers);
        }
    }

    /// The results of the last run, `None` for one that divides by zero on its way.
    pub(super) fn outputs(&self) -> impl ExactSizeIterator<Item = Option<&V>> {
        self.outputs.iter().map(|output| self.registers[output.0].as_ref())
    }

    /// One of them.
    pub(super) fn output(&self, index: usize) -> Option<&V> {
        self.registers[self.outputs[index].0].as_ref()
    }
}
