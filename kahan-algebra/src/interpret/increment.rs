//! x̃ − x at fixed parameters and ε: by the step's plan, or by elimination where there is none.

use crate::arithmetic::{Arithmetic, Solved, solve};
use crate::derived::Derived;
use crate::plan::{Operation, Plan, StepPlan};
use crate::poly::Variable;

use super::Pole;
use super::program::{Input, Program};

/// How x̃ − x is computed.
#[derive(Clone, Debug)]
pub(super) enum Increment<V> {
    /// The kernel of the step: numerators, reciprocals, and after these `results` everything that
    /// it divides by; `reciprocals` are the places of each component's reciprocal among them.
    Planned { kernel: Program<V>, reciprocals: Vec<Option<usize>>, results: usize },
    /// A, row by row, and f: A (x̃ − x)/(2ε) = f.
    Elimination { matrix: Program<V>, right: Program<V>, two_eps: V },
}

impl<V: Clone> Increment<V> {
    pub(super) fn of<A: Arithmetic<Value = V>>(
        derived: &Derived,
        arithmetic: &A,
        eps: &V,
        input: &impl Fn(Variable) -> Input<V>,
    ) -> Self {
        let program = |plan: &Plan| Program::new(plan, arithmetic, &[], input);
        match derived.step() {
            Some(step) => Self::planned(step.at(arithmetic, eps), arithmetic, input),
            None => Increment::Elimination {
                matrix: program(&derived.matrix),
                right: program(&derived.field),
                two_eps: arithmetic.add(eps, eps),
            },
        }
    }

    /// Computes the prepared constants, and prepares the kernel that uses them.
    fn planned<A: Arithmetic<Value = V>>(
        step: &StepPlan,
        arithmetic: &A,
        input: &impl Fn(Variable) -> Input<V>,
    ) -> Self {
        let constants = Program::new(&step.constants, arithmetic, &[], input);
        let constants: Vec<Option<V>> = constants.outputs().map(Option::<&V>::cloned).collect();
        let divisors = step.kernel.operations.iter().filter_map(|operation| match *operation {
            Operation::Divide(_, divisor) => Some(divisor),
            _ => None,
        });
        let outputs = step.kernel.outputs.iter().copied().chain(divisors).collect();
        let kernel = Plan { operations: step.kernel.operations.clone(), outputs };
        let numerators = step.reciprocals.len();
        Increment::Planned {
            kernel: Program::new(&kernel, arithmetic, &constants, input),
            reciprocals: step.reciprocals.iter().map(|place| place.map(|place| numerators + place)).collect(),
            results: step.kernel.outputs.len(),
        }
    }

    /// Replaces x by x̃; at a pole the state is as before.
    pub(super) fn add_to<A: Arithmetic<Value = V>>(
        &mut self,
        state: &mut [V],
        arithmetic: &A,
    ) -> Result<(), Pole> {
        match self {
            Increment::Planned { kernel, reciprocals, results } => {
                kernel.run(arithmetic, state);
                // A float has a value where it divides by zero, and still that is a pole.
                let is_zero = |value: &V| arithmetic.is_zero(value);
                if kernel.outputs().any(|value| value.is_none())
                    || kernel.outputs().skip(*results).flatten().any(is_zero)
                {
                    return Err(Pole);
                }
                for ((x, place), numerator) in state.iter_mut().zip(reciprocals).zip(kernel.outputs()) {
                    let numerator = numerator.ok_or(Pole)?;
                    *x = match place.and_then(|place| kernel.output(place)) {
                        Some(reciprocal) => arithmetic.multiply_add(numerator, reciprocal, x),
                        None => arithmetic.add(x, numerator),
                    };
                }
            }
            Increment::Elimination { matrix, right, two_eps } => {
                matrix.run(arithmetic, state);
                right.run(arithmetic, state);
                let entries: Option<Vec<V>> = matrix.outputs().map(Option::<&V>::cloned).collect();
                let rows: Vec<Vec<V>> = entries.ok_or(Pole)?.chunks(state.len()).map(<[V]>::to_vec).collect();
                let right: Option<Vec<Vec<V>>> =
                    right.outputs().map(|value| Some(vec![value?.clone()])).collect();
                let Solved { solution, .. } = solve(arithmetic, &rows, &right.ok_or(Pole)?).ok_or(Pole)?;
                for (x, slope) in state.iter_mut().zip(&solution) {
                    *x = arithmetic.add(x, &arithmetic.multiply(two_eps, &slope[0]));
                }
            }
        }
        Ok(())
    }
}
