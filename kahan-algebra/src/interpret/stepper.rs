//! Long orbits at run time: one map at fixed parameters and ε, stepped many times.
//!
//! [`Interpreter`](super::Interpreter) computes everything at one point; a [`Stepper`] computes the
//! next point and the integrals only, with everything prepared that does not depend on the state.
//! Its operations and their order are those of the generated code's `step`, so over floats the
//! orbits of a field with a [`StepPlan`](crate::plan::StepPlan) are the same bit for bit, unless
//! that code is compiled for a target with fused multiply-adds: those round once where this rounds
//! twice.

use crate::arithmetic::Arithmetic;
use crate::derived::derive;
use crate::plan::Plan;
use crate::poly::Variable;
use crate::symbols::Symbol;
use crate::system::System;

use super::UndefinedField;
use super::increment::Increment;
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
            Ok(Stepper {
                arithmetic,
                two_eps: arithmetic.add(eps, eps),
                is_reduced: derived.map.is_some(),
                increment: Increment::of(&derived, arithmetic, eps, &input),
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
        self.increment.add_to(state, self.arithmetic)
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
