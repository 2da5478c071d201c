//! The step of a field at any ε: a straight line where the plan has one, elimination where it has
//! none.

use kahan_algebra::derived::Derived;
use kahan_algebra::plan::StepPlan;
use kahan_core::__private::may_divide_by;
use kahan_core::Scalar;

use super::elimination::solve;
use super::line::Line;
use super::scratch::Scratch;

/// The forms of a step.
#[derive(Debug)]
pub(crate) struct Steps {
    first: Step,
    /// For lanes, and where the first divides by ε for numbers and an ε that do not allow it.
    general: Option<Step>,
    divides_by_eps: bool,
}

impl Steps {
    pub(super) fn of(derived: &Derived) -> Self {
        match derived.step() {
            Some(plan) => Steps {
                first: Step::straight(plan, derived),
                general: plan.general.as_deref().map(|general| Step::straight(general, derived)),
                divides_by_eps: plan.has_inverse_step(),
            },
            None => Steps { first: Step::by_elimination(derived), general: None, divides_by_eps: false },
        }
    }

    /// The form of single steps over V at this ε, and whether it rounds increments before it adds
    /// them, as generated code does in the form that it rarely takes.
    pub(crate) fn at<V: Scalar>(&self, eps: &V) -> (&Step, bool) {
        match &self.general {
            // What never divides by ε has this form as its own.
            Some(general) if self.divides_by_eps && !may_divide_by(eps) => {
                (general, may_divide_by(&V::one()))
            }
            _ => (&self.first, false),
        }
    }

    /// The form of several trajectories side by side.
    pub(crate) fn of_lanes(&self) -> &Step {
        self.general.as_ref().unwrap_or(&self.first)
    }
}

/// One form of a step.
#[derive(Debug)]
pub(crate) struct Step {
    kind: Kind,
    /// For each component the index of its reciprocal.
    reciprocals: Vec<Option<usize>>,
}

#[derive(Debug)]
enum Kind {
    Straight { constants: Line, kernel: Line },
    Elimination { field_jacobian: Line, field: Line },
}

impl Step {
    fn straight(plan: &StepPlan, derived: &Derived) -> Self {
        let symbols = &derived.system.field.symbols;
        let kind = Kind::Straight {
            constants: Line::of(&plan.constants, symbols),
            kernel: Line::of_kernel(&plan.kernel, symbols, plan.constants.outputs.len()),
        };
        Step { kind, reciprocals: plan.reciprocals.clone() }
    }

    fn by_elimination(derived: &Derived) -> Self {
        let symbols = &derived.system.field.symbols;
        let kind = Kind::Elimination {
            field_jacobian: Line::of(&derived.field_jacobian, symbols),
            field: Line::of(&derived.field, symbols),
        };
        Step { kind, reciprocals: vec![None; symbols.dimension()] }
    }

    /// Whether it compares numbers, which several side by side can't.
    pub(crate) fn has_lanes(&self) -> bool {
        matches!(self.kind, Kind::Straight { .. })
    }

    /// Appends all that does not depend on the state to `given`. `constants` are the parameters and
    /// ε, half the time step.
    pub(crate) fn prepare<V: Scalar + Copy>(
        &self,
        constants: &[V],
        registers: &mut Vec<V>,
        given: &mut Vec<V>,
    ) {
        match &self.kind {
            Kind::Straight { constants: prepared, kernel } => {
                let start = given.len();
                given.extend(prepared.results(constants, registers, &[]));
                registers.clear();
                registers.extend(given.drain(start..));
                kernel.give(registers, given);
            }
            Kind::Elimination { field_jacobian, field } => {
                field_jacobian.give(constants, given);
                field.give(constants, given);
            }
        }
    }

    /// Replaces a state by the next one. `given` is what was prepared; whether increments are
    /// rounded before they are added, is said by [`Steps::at`].
    #[inline]
    pub(crate) fn advance<V: Scalar + Copy>(
        &self,
        given: &[V],
        rounds: bool,
        state: &mut [V],
        scratch: &mut Scratch<V>,
    ) {
        self.compute(given, state, scratch);
        for (i, x) in state.iter_mut().enumerate() {
            *x = added(self.quotient(i, rounds, scratch), *x);
        }
    }

    /// The same for a state that is carried with what it lacks: the operations of
    /// [`Quotients::added_with_carry`](kahan_core::Quotients::added_with_carry).
    pub(crate) fn advance_with_carry<V: Scalar + Copy>(
        &self,
        given: &[V],
        rounds: bool,
        state: &mut [V],
        carry: &mut [V],
        scratch: &mut Scratch<V>,
    ) {
        self.compute(given, state, scratch);
        for (i, (x, carry)) in state.iter_mut().zip(carry).enumerate() {
            let quotient = self.quotient(i, rounds, scratch);
            let base = *x + *carry;
            let rest = *carry - (base - *x);
            let next = added(quotient, base);
            let distance = next - base;
            let lacks = match quotient {
                (numerator, Some(reciprocal)) => numerator.multiply_subtract(reciprocal, distance),
                (increment, None) => increment - distance,
            };
            (*x, *carry) = (next, rest + lacks);
        }
    }

    /// Adds the increment at a state to another one.
    pub(crate) fn add_increment<V: Scalar + Copy>(
        &self,
        given: &[V],
        rounds: bool,
        state: &[V],
        base: &mut [V],
        scratch: &mut Scratch<V>,
    ) {
        self.compute(given, state, scratch);
        for (i, x) in base.iter_mut().enumerate() {
            *x = added(self.quotient(i, rounds, scratch), *x);
        }
    }

    /// x̃ − x, a component after the other.
    pub(super) fn increments<'a, V: Scalar + Copy>(
        &'a self,
        given: &[V],
        state: &[V],
        scratch: &'a mut Scratch<V>,
    ) -> impl ExactSizeIterator<Item = V> + use<'a, V> {
        self.compute(given, state, scratch);
        (0..self.reciprocals.len()).map(|i| self.quotient(i, true, scratch).0)
    }

    /// Computes numerators and reciprocals.
    #[inline(always)]
    fn compute<V: Scalar + Copy>(&self, given: &[V], state: &[V], scratch: &mut Scratch<V>) {
        let Scratch { registers, outcome, matrix, .. } = scratch;
        outcome.clear();
        registers.clear();
        match &self.kind {
            Kind::Straight { kernel, .. } => {
                registers.extend_from_slice(given);
                outcome.extend(kernel.run(registers, state));
            }
            Kind::Elimination { field_jacobian, field } => {
                let (of_slopes, of_field) = given.split_at(field_jacobian.given());
                let eps = field_jacobian.eps(of_slopes);
                registers.extend_from_slice(of_slopes);
                matrix.clear();
                matrix.extend(field_jacobian.run(registers, state));
                into_matrix(matrix, eps, state.len());
                registers.clear();
                registers.extend_from_slice(of_field);
                outcome.extend(field.run(registers, state));
                solve(matrix, outcome, state.len());
                let time_step = eps + eps;
                outcome.iter_mut().for_each(|velocity| *velocity = time_step * *velocity);
            }
        }
    }

    /// Component i of the increment before its last multiplication.
    #[inline(always)]
    fn quotient<V: Scalar + Copy>(&self, i: usize, rounds: bool, scratch: &Scratch<V>) -> (V, Option<V>) {
        let (numerators, reciprocals) = scratch.outcome.split_at(self.reciprocals.len());
        match self.reciprocals[i] {
            Some(place) if rounds => (numerators[i] * reciprocals[place], None),
            place => (numerators[i], place.map(|place| reciprocals[place])),
        }
    }
}

/// A component of the next state.
#[inline(always)]
fn added<V: Scalar>((numerator, reciprocal): (V, Option<V>), x: V) -> V {
    match reciprocal {
        Some(reciprocal) => numerator.multiply_add(reciprocal, x),
        None => x + numerator,
    }
}

/// f′(x), row by row, becomes A(x,ε) = I − εf′(x).
pub(super) fn into_matrix<V: Scalar + Copy>(slopes: &mut [V], eps: V, n: usize) {
    for (place, entry) in slopes.iter_mut().enumerate() {
        let scaled = -(eps * *entry);
        *entry = if place / n == place % n { V::one() + scaled } else { scaled };
    }
}
