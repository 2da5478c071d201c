//! Long orbits at run time: one map at fixed parameters and ε, stepped many times.
//!
//! [`Interpreter`](super::Interpreter) computes everything at one point; a [`Stepper`] computes the
//! next point and the integrals only, with everything prepared that does not depend on the state.
//! Its operations and their order are those of the generated code's `step`, so over floats the
//! orbits of a field with a [`StepPlan`] are the same bit for bit, unless that code is compiled for
//! a target with fused multiply-adds: those round once where this rounds twice.

use crate::arithmetic::{Arithmetic, Solved, solve};
use crate::derived::derive;
use crate::plan::{Operation, Plan, StepPlan};
use crate::poly::Variable;
use crate::symbols::Symbol;
use crate::system::System;

use super::UndefinedField;
use super::program::{Input, Program};

/// The step from a point has no value: a pole of the reduced map, or det A = 0 where the map is not
/// reduced (see [`Stepper::is_reduced`]). Floats are at a pole only where the rounded denominator
/// is zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pole;

/// A Kahan map at fixed parameters and ε (half the time step), in one arithmetic.
#[derive(Clone, Debug)]
pub struct Stepper<'a, A: Arithmetic> {
    arithmetic: &'a A,
    two_eps: A::Value,
    is_reduced: bool,
    increment: Increment<A::Value>,
    integral_names: Vec<String>,
    integrals: Program<A::Value>,
}

/// How x̃ − x is computed.
#[derive(Clone, Debug)]
enum Increment<V> {
    /// The kernel of the step: numerators, reciprocals, and after these `results` everything that
    /// it divides by; `reciprocals` are the places of each component's reciprocal among them.
    Planned { kernel: Program<V>, reciprocals: Vec<Option<usize>>, results: usize },
    /// A, row by row, and f: A (x̃ − x)/(2ε) = f.
    Elimination { matrix: Program<V>, right: Program<V> },
}

impl<V: Clone> Increment<V> {
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
}

impl<'a, A: Arithmetic> Stepper<'a, A> {
    /// Derives the map and prepares it; `parameters` in the order of the system, `eps` is ε.
    ///
    /// Cost: that of deriving and reducing the map once (milliseconds for fields of ordinary size).
    ///
    /// # Errors
    /// Where a parameter makes the field divide by zero, or the arithmetic lacks a constant.
    ///
    /// # Panics
    /// If there are fewer values than parameters.
    pub fn new(
        system: &System,
        arithmetic: &'a A,
        parameters: &[A::Value],
        eps: &A::Value,
    ) -> Result<Self, UndefinedField> {
        Self::of_each(system, arithmetic, parameters, core::slice::from_ref(eps))
            .map(|mut steppers| steppers.remove(0))
    }

    /// A stepper for each of several ε, as the stages of a composition need them; the map is
    /// derived once.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    ///
    /// # Panics
    /// As [`new`](Self::new).
    pub fn of_each(
        system: &System,
        arithmetic: &'a A,
        parameters: &[A::Value],
        eps: &[A::Value],
    ) -> Result<Vec<Self>, UndefinedField> {
        let symbols = &system.field.symbols;
        let fixed = |variable: Variable, eps: &A::Value| match symbols.symbol(variable) {
            Symbol::State(i) | Symbol::SecondState(i) => Input::State(i),
            Symbol::Parameter(k) => Input::Fixed(parameters[k].clone()),
            Symbol::Epsilon => Input::Fixed(eps.clone()),
        };
        let derived = derive(system);
        let stepper = |eps: &A::Value| {
            let input = |variable: Variable| fixed(variable, eps);
            let program = |plan: &Plan| Program::new(plan, arithmetic, &[], input);
            let divisors = program(&derived.divisors);
            if divisors.outputs().any(|value| value.is_none_or(|value| arithmetic.is_zero(value))) {
                return Err(UndefinedField);
            }
            let increment = match derived.step() {
                Some(step) => Increment::planned(step.at(arithmetic, eps), arithmetic, &input),
                None => Increment::Elimination {
                    matrix: program(&derived.matrix),
                    right: program(&derived.field),
                },
            };
            Ok(Stepper {
                arithmetic,
                two_eps: arithmetic.add(eps, eps),
                is_reduced: derived.map.is_some(),
                increment,
                integral_names: derived.integral_names.clone(),
                integrals: program(&derived.integrals),
            })
        };
        eps.iter().map(stepper).collect()
    }

    /// Whether the map is the reduced rational map; if not, it is beyond the budget of terms, and
    /// every point with det A = 0 counts as a pole.
    #[must_use]
    pub fn is_reduced(&self) -> bool {
        self.is_reduced
    }

    /// The time step 2ε.
    #[must_use]
    pub fn time_step(&self) -> &A::Value {
        &self.two_eps
    }

    /// Replaces the state x by x̃. Cost: one operation a step of the plan; over floats nothing is
    /// allocated, except by elimination.
    ///
    /// # Errors
    /// [`Pole`], and the state is then as before. A float step near a pole or beyond the range may
    /// be `Ok` with values that are not finite.
    ///
    /// # Panics
    /// If the state has too few entries.
    pub fn advance(&mut self, state: &mut [A::Value]) -> Result<(), Pole> {
        let arithmetic = self.arithmetic;
        match &mut self.increment {
            Increment::Planned { kernel, reciprocals, results } => {
                kernel.run(arithmetic, state);
                // A float has a value where it divides by zero, and still that is a pole.
                let is_zero = |value: &A::Value| arithmetic.is_zero(value);
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
            Increment::Elimination { matrix, right } => {
                matrix.run(arithmetic, state);
                right.run(arithmetic, state);
                let entries: Option<Vec<A::Value>> =
                    matrix.outputs().map(Option::<&A::Value>::cloned).collect();
                let rows: Vec<Vec<A::Value>> =
                    entries.ok_or(Pole)?.chunks(state.len()).map(<[A::Value]>::to_vec).collect();
                let right: Option<Vec<Vec<A::Value>>> =
                    right.outputs().map(|value| Some(vec![value?.clone()])).collect();
                let Solved { solution, .. } = solve(arithmetic, &rows, &right.ok_or(Pole)?).ok_or(Pole)?;
                for (x, slope) in state.iter_mut().zip(&solution) {
                    *x = arithmetic.add(x, &arithmetic.multiply(&self.two_eps, &slope[0]));
                }
            }
        }
        Ok(())
    }

    /// The names of the unconditional integrals, in their order.
    #[must_use]
    pub fn integral_names(&self) -> &[String] {
        &self.integral_names
    }

    /// The values of the unconditional integrals at a state; `None` for one that divides by zero
    /// there.
    ///
    /// # Panics
    /// If the state has too few entries.
    pub fn integrals(&mut self, state: &[A::Value]) -> impl ExactSizeIterator<Item = Option<&A::Value>> {
        self.integrals.run(self.arithmetic, state);
        self.integrals.outputs()
    }
}
