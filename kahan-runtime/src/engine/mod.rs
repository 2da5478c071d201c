//! What computes: every object of a field at a state that is a slice, by the plans of the field.
//!
//! In: plans, and numbers whose counts fit (whoever calls has seen to that). Out: numbers, with the
//! bits of generated code. A plan is made ready when it is first asked for, and kept for all maps
//! of the field. Here is the one place that knows how a plan is run.

mod columns;
mod elimination;
mod lanes;
mod line;
mod scratch;
mod step;

use std::sync::{Arc, OnceLock};

use kahan_algebra::derived::{Derived, derive};
use kahan_algebra::plan::Plan;
use kahan_algebra::system::System;
use kahan_core::__private::Dual;
use kahan_core::{Composition, Constant, Scalar};

use crate::interpreted::Code;
use crate::machine::Codes;

use elimination::solve;
use step::{Step, Steps, into_matrix};

pub(crate) use columns::Columns;
pub(crate) use line::Line;
pub(crate) use scratch::{Scratch, Scratches, with_scratch};

/// A function of the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Object {
    /// f(x)
    Field,
    /// f′(x), row by row.
    FieldJacobian,
    /// The integrals, in order.
    Integrals,
    /// The density, where one is claimed.
    Density,
    /// The entries above the diagonal of the bracket with this index.
    Bracket(usize),
    /// A(x,ε), row by row.
    Matrix,
    /// ∂x̃/∂x, row by row.
    Jacobian,
}

/// The plans of a field, and what has been made of them.
#[derive(Debug)]
pub(crate) struct Engine {
    pub(crate) derived: Derived,
    steps: OnceLock<Steps>,
    field: OnceLock<Line>,
    field_jacobian: OnceLock<Line>,
    integrals: OnceLock<Line>,
    density: OnceLock<Line>,
    brackets: Vec<OnceLock<Line>>,
    code: OnceLock<Arc<Code>>,
    pub(crate) codes: Codes,
}

/// A step of the map at one ε, with all that does not depend on the state.
#[derive(Clone, Debug)]
pub(crate) struct Stage<T> {
    eps: T,
    given: Vec<T>,
}

/// The coefficients of the stages that differ: those of a composition up to its middle.
fn distinct(composition: &Composition) -> impl ExactSizeIterator<Item = &'static Constant<'static>> {
    composition.coefficients().take(composition.stages() / 2 + 1)
}

/// Runs the stages of a composition in order, of which `distinct` differ.
pub(crate) fn in_turn(distinct: usize, mut run: impl FnMut(usize)) {
    let last = 2 * distinct - 2;
    (0..=last).for_each(|k| run(k.min(last - k)));
}

impl Engine {
    /// Derives the map.
    pub(crate) fn new(system: &System) -> Self {
        let derived = derive(system);
        Engine {
            brackets: derived.brackets.iter().map(|_| OnceLock::new()).collect(),
            derived,
            steps: OnceLock::new(),
            field: OnceLock::new(),
            field_jacobian: OnceLock::new(),
            integrals: OnceLock::new(),
            density: OnceLock::new(),
            code: OnceLock::new(),
            codes: Codes::default(),
        }
    }

    /// The programs of maps over any scalar.
    pub(crate) fn code(&self) -> &Arc<Code> {
        self.code.get_or_init(|| Arc::new(Code::of(&self.derived)))
    }

    fn steps(&self) -> &Steps {
        self.steps.get_or_init(|| Steps::of(&self.derived))
    }

    fn line(&self, object: Object) -> Option<&Line> {
        let derived = &self.derived;
        let (kept, plan): (&OnceLock<Line>, &Plan) = match object {
            Object::Field => (&self.field, &derived.field),
            Object::FieldJacobian => (&self.field_jacobian, &derived.field_jacobian),
            Object::Integrals => (&self.integrals, &derived.integrals),
            Object::Density => (&self.density, derived.density.as_ref()?),
            Object::Bracket(index) => (self.brackets.get(index)?, &derived.brackets.get(index)?.1),
        };
        Some(kept.get_or_init(|| Line::of(plan, &derived.system.field.symbols)))
    }

    /// The distinct stages of a composition, each prepared; `constants` are the parameters and ε.
    pub(crate) fn stages<T: Scratches>(&self, constants: &[T], composition: Composition) -> Vec<Stage<T>> {
        let (parameters, eps) = split(constants);
        let stage = |coefficient: &Constant<'_>| {
            let eps = T::constant(coefficient) * eps;
            let (step, _) = self.steps().at(&eps);
            let constants: Vec<T> = parameters.iter().copied().chain([eps]).collect();
            let mut given = Vec::new();
            with_scratch(T::single(), |scratch| {
                step.prepare(&constants, &mut scratch.registers, &mut given);
            });
            Stage { eps, given }
        };
        distinct(&composition).map(stage).collect()
    }

    /// A step, prepared; `constants` are the parameters and ε.
    pub(crate) fn stage<V: Scalar + Copy>(&self, constants: &[V], scratch: &mut Scratch<V>) -> Stage<V> {
        let (_, eps) = split(constants);
        let mut given = Vec::new();
        self.steps().at(&eps).0.prepare(constants, &mut scratch.registers, &mut given);
        Stage { eps, given }
    }

    /// One step from a state; with what the state lacks carried along, where `carry` is not empty.
    pub(crate) fn advance_stage<V: Scalar + Copy>(
        &self,
        Stage { eps, given }: &Stage<V>,
        state: &mut [V],
        carry: &mut [V],
        scratch: &mut Scratch<V>,
    ) {
        let (step, rounds) = self.steps().at(eps);
        if carry.is_empty() {
            step.advance(given, rounds, state, scratch);
        } else {
            step.advance_with_carry(given, rounds, state, carry, scratch);
        }
    }

    /// The increment at a state, added to another one.
    pub(crate) fn add_increment<V: Scalar + Copy>(
        &self,
        Stage { eps, given }: &Stage<V>,
        state: &[V],
        base: &mut [V],
        scratch: &mut Scratch<V>,
    ) {
        let (step, rounds) = self.steps().at(eps);
        step.add_increment(given, rounds, state, base, scratch);
    }

    /// Replaces a state by the one so many steps later.
    pub(crate) fn advance<T: Scratches>(&self, stages: &[Stage<T>], state: &mut [T], steps: u64) {
        with_scratch(T::single(), |scratch| {
            for _ in 0..steps {
                in_turn(stages.len(), |k| {
                    let Stage { eps, given } = &stages[k];
                    let (step, rounds) = self.steps().at(eps);
                    step.advance(given, rounds, state, scratch);
                });
            }
        });
    }

    /// The same, with what the state lacks carried along.
    pub(crate) fn advance_with_carry<T: Scratches>(
        &self,
        stages: &[Stage<T>],
        state: &mut [T],
        carry: &mut [T],
        steps: u64,
    ) {
        with_scratch(T::single(), |scratch| {
            for _ in 0..steps {
                in_turn(stages.len(), |k| {
                    let Stage { eps, given } = &stages[k];
                    let (step, rounds) = self.steps().at(eps);
                    step.advance_with_carry(given, rounds, state, carry, scratch);
                });
            }
        });
    }

    /// An object at a state; `constants` are the parameters and ε. What `out` has no room for is
    /// left out, as is an object that the field has not.
    pub(crate) fn evaluate<T: Scratches>(&self, object: Object, constants: &[T], state: &[T], out: &mut [T]) {
        let Some(line) = self.line(object) else { return };
        with_scratch(T::single(), |scratch| {
            let results = line.results(constants, &mut scratch.registers, state);
            out.iter_mut().zip(results).for_each(|(out, result)| *out = result);
        });
    }

    /// A(x,ε), row by row; `constants` are the parameters and ε.
    pub(crate) fn matrix<T: Scratches>(&self, constants: &[T], state: &[T], out: &mut [T]) {
        self.evaluate(Object::FieldJacobian, constants, state, out);
        into_matrix(out, split(constants).1, state.len());
    }

    /// ∂x̃/∂x of a step, row by row: the straight line over dual numbers, or A(x,ε)⁻¹·A(x̃,−ε);
    /// `constants` are the parameters and ε.
    pub(crate) fn jacobian<T: Scratches>(&self, constants: &[T], state: &[T], out: &mut [T]) {
        let (parameters, eps) = split(constants);
        let (step, _) = self.steps().at(&Dual::<T, 1>::lift(eps));
        if step.has_lanes() {
            with_scratch(T::duals(), |scratch| jacobian_by_duals(step, constants, state, out, scratch));
        } else {
            let mut next = state.to_vec();
            self.advance(&self.stages(constants, Composition::KAHAN), &mut next, 1);
            let behind: Vec<T> = parameters.iter().copied().chain([-eps]).collect();
            self.matrix(&behind, &next, out);
            let mut matrix = vec![T::zero(); out.len()];
            self.matrix(constants, state, &mut matrix);
            solve(&mut matrix, out, state.len());
        }
    }
}

/// The parameters, and ε behind them.
fn split<T: Copy>(constants: &[T]) -> (&[T], T) {
    let (eps, parameters) = constants.split_last().unwrap_or_else(|| unreachable!("there is an eps"));
    (parameters, *eps)
}

/// One direction after the other.
fn jacobian_by_duals<T: Scratches>(
    step: &Step,
    constants: &[T],
    state: &[T],
    out: &mut [T],
    scratch: &mut Scratch<Dual<T, 1>>,
) {
    let [mut lifted, mut given, mut point] =
        [&mut scratch.constants, &mut scratch.given, &mut scratch.state].map(core::mem::take);
    [&mut lifted, &mut given, &mut point].into_iter().for_each(Vec::clear);
    lifted.extend(constants.iter().map(|constant| Dual::lift(*constant)));
    step.prepare(&lifted, &mut scratch.registers, &mut given);
    point.extend(state.iter().map(|x| Dual::lift(*x)));
    for j in 0..state.len() {
        point[j] = Dual::coordinate(state[j], 0);
        for (i, increment) in step.increments(&given, &point, scratch).enumerate() {
            let [slope] = increment.gradient;
            out[i * state.len() + j] = if i == j { T::one() + slope } else { slope };
        }
        point[j] = Dual::lift(state[j]);
    }
    (scratch.constants, scratch.given, scratch.state) = (lifted, given, point);
}
