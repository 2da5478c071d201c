//! Evaluates functions derived from a field, such as the map and its Jacobian, at a state.
//!
//! In: plans (straight-line programs of functions), and slices whose lengths were checked. Out:
//! numbers with the bits that code from `kahan!` gives. All maps of a field use the same plans.

mod coded;
mod coded_columns;
mod columns;
mod couplings;
mod dense;
mod elimination;
mod floats;
mod group_code;
mod scratch;
mod step;
mod transposed;

use std::any::Any;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use kahan_algebra::derived::{Derived, derive};
use kahan_algebra::plan::Plan;
use kahan_algebra::system::System;
use kahan_algebra::variational::Sensitivity;
use kahan_core::{Composition, Constant, Dual, FloatScalar, Scalar};

use crate::line::Line;
use crate::machine_code::{Codes, StepKind};

pub(crate) use elimination::determinant;
use elimination::{has_negative_determinant, solve};
use step::StepForms;

pub(crate) use coded::CompiledStages;
pub(crate) use columns::Columns;
pub(crate) use columns::values_of;
pub(crate) use couplings::{EliminationPattern, Factors};
pub(crate) use dense::advance as advance_dense;
pub use floats::{MachineFloat, RuntimeFloat};
pub(crate) use group_code::GroupCode;
use scratch::Workspace;
pub(crate) use scratch::{Scratch, with_scratch};
pub(crate) use step::{Step, into_matrix};
pub(crate) use transposed::TransposedSolver;

/// A function of one or two states that is derived from a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MapObject {
    Field,
    /// The Jacobian f′(x), row by row.
    FieldJacobian,
    Integrals,
    Density,
    /// For the Poisson bracket with this index, the matrix entries above the diagonal.
    Bracket(usize),
    /// The field f(x). Coefficients that depend on ε are evaluated at the map's ε.
    FieldAtEps,
    /// The Jacobian of [`FieldAtEps`](Self::FieldAtEps), row by row.
    FieldJacobianAtEps,
    /// The polarised field Q(x,y) + ½B(x+y) + c, if `FieldAtEps` is Q(x,x) + Bx + c.
    PolarizedAtEps,
    /// The matrix A(x,ε), row by row.
    Matrix,
    /// The Jacobian ∂x̃/∂x of the map, row by row.
    Jacobian,
    /// The symmetric bilinear form Q(x,y), where Q(x,x) is the quadratic part of the field.
    Bilinear,
    /// The polarised field Q(x,y) + ½B(x+y) + c of a field Q(x,x) + Bx + c.
    Polarized,
    /// The determinant det A(x,ε) in expanded form, unless the expansion has too many terms.
    DetMatrix,
    /// The expanded numerators and denominator of x̃, unless they have too many terms.
    RationalMap,
    /// Numerators and denominator of x̃ without a common factor that depends on states.
    ReducedMap,
    /// The tangent vector (∂x̃/∂x)·v, where v is a tangent vector at x. The program reads two
    /// points of 2n numbers: (x, v), and x̃ with n unused numbers.
    Tangent,
}

impl MapObject {
    /// Returns the object's index in the tables of [`Engine`], and its plan if it has a plan.
    pub(crate) fn entry(self, derived: &Derived) -> (usize, Option<&Plan>) {
        match self {
            MapObject::Field => (0, Some(derived.at_eps_zero().field())),
            MapObject::FieldJacobian => (1, Some(derived.at_eps_zero().field_jacobian())),
            MapObject::Integrals => (2, Some(&derived.integrals)),
            MapObject::Density => (3, derived.density.as_ref()),
            MapObject::Matrix => (4, None),
            MapObject::Jacobian => (5, None),
            MapObject::Bilinear => (6, Some(derived.at_eps_zero().bilinear())),
            MapObject::Polarized => (7, Some(derived.at_eps_zero().polarized())),
            MapObject::DetMatrix => (8, derived.det_matrix.as_ref()),
            MapObject::RationalMap => (9, derived.rational_map.as_ref()),
            MapObject::ReducedMap => (10, derived.reduced_map.as_ref()),
            MapObject::FieldAtEps => (11, Some(derived.field())),
            MapObject::FieldJacobianAtEps => (12, Some(derived.field_jacobian())),
            MapObject::PolarizedAtEps => (13, Some(derived.polarized())),
            MapObject::Tangent => (14, derived.tangent_map().map(|(_, plan)| plan)),
            MapObject::Bracket(index) => (15 + index, derived.brackets.get(index).map(|(_, plan)| plan)),
        }
    }
}

/// The plans of a field, and all data prepared from the plans so far.
#[derive(Debug)]
pub struct Engine {
    pub(crate) derived: Derived,
    steps: OnceLock<StepForms>,
    lines: Vec<OnceLock<Option<Line>>>,
    /// A straight-line program for each integral.
    single_integrals: OnceLock<Vec<Line>>,
    sensitivities: Mutex<Vec<(Vec<Sensitivity>, Arc<Engine>)>>,
    coefficients: OnceLock<Option<Line>>,
    /// The packed coefficients of a dense field without parameters, in `f32` and in `f64`.
    packed: [OnceLock<Box<dyn Any + Send + Sync>>; 2],
    pub(crate) codes: Codes,
}

/// A step of the map at one ε, with the constants of the step.
#[derive(Clone, Debug)]
pub(crate) struct Stage<T> {
    is_general: bool,
    given: Vec<T>,
}

/// Returns the coefficients of a palindromic composition from the first to the middle one.
fn distinct_coefficients(
    composition: &Composition,
) -> impl ExactSizeIterator<Item = &'static Constant<'static>> {
    composition.coefficients().take(composition.stages() / 2 + 1)
}

/// Calls `run` for each stage of a palindromic composition, in order.
#[inline(always)]
pub(crate) fn for_each_stage(distinct: usize, mut run: impl FnMut(usize)) {
    let last = 2 * distinct - 2;
    (0..=last).for_each(|k| run(k.min(last - k)));
}

impl Engine {
    pub(crate) fn new(system: &System) -> Self {
        let derived = derive(system);
        let (objects, _) = MapObject::Bracket(derived.brackets.len()).entry(&derived);
        Engine {
            lines: (0..objects).map(|_| OnceLock::new()).collect(),
            codes: Codes::default(),
            derived,
            steps: OnceLock::new(),
            single_integrals: OnceLock::new(),
            sensitivities: Mutex::default(),
            coefficients: OnceLock::new(),
            packed: Default::default(),
        }
    }

    pub(crate) fn dimension(&self) -> usize {
        self.derived.system.field.dimension()
    }

    pub(crate) fn sensitivities(&self, by: &[Sensitivity]) -> Arc<Engine> {
        let mut known = self.sensitivities.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, engine)) = known.iter().find(|(own, _)| own == by) {
            return Arc::clone(engine);
        }
        let engine = Arc::new(Engine::new(&self.derived.system.sensitivities(by)));
        known.push((by.to_vec(), Arc::clone(&engine)));
        engine
    }

    pub(crate) fn at_eps(&self, object: MapObject) -> MapObject {
        match object {
            _ if !self.derived.system.field.depends_on_eps() => object,
            MapObject::Field => MapObject::FieldAtEps,
            MapObject::FieldJacobian => MapObject::FieldJacobianAtEps,
            MapObject::Polarized => MapObject::PolarizedAtEps,
            _ => object,
        }
    }

    pub(crate) fn steps(&self) -> &StepForms {
        self.steps.get_or_init(|| StepForms::of(&self.derived))
    }

    /// Returns the straight-line program of an object that has a plan.
    pub(crate) fn line(&self, object: MapObject) -> Option<&Line> {
        let (place, plan) = object.entry(&self.derived);
        let symbols = || match object {
            MapObject::Tangent => Some(self.derived.tangent_map()?.0),
            _ => Some(&self.derived.system.field.symbols),
        };
        let line = || Some(Line::of(plan?, symbols()?));
        self.lines.get(place)?.get_or_init(line).as_ref()
    }

    pub(crate) fn objects(&self) -> usize {
        self.lines.len()
    }

    pub(crate) fn known_line(&self, object: MapObject) -> &Line {
        self.line(object).unwrap_or_else(|| unreachable!("every field has it"))
    }

    pub(crate) fn single_integrals(&self) -> &[Line] {
        let Derived { integrals, integral_names, system, .. } = &self.derived;
        let line = |k| Line::with_checked_divisions(&integrals.part(k..k + 1), &system.field.symbols);
        self.single_integrals.get_or_init(|| (0..integral_names.len()).map(line).collect())
    }

    pub(crate) fn stages<T: RuntimeFloat>(&self, constants: &[Vec<T>]) -> Vec<Stage<T>> {
        with_scratch(T::single(), |scratch| constants.iter().map(|own| self.stage(own, scratch)).collect())
    }

    pub(crate) fn stage<V: Scalar + Copy>(&self, constants: &[V], scratch: &mut Scratch<V>) -> Stage<V> {
        let is_general = self.steps().are_general(&split(constants).1);
        let mut given = Vec::new();
        self.steps().form(is_general).prepare(constants, &mut scratch.registers, &mut given);
        Stage { is_general, given }
    }

    /// Advances a state by interpreted steps. If `carry` is not empty, it holds the rounding errors
    /// of the state for compensated summation.
    pub(crate) fn advance<T: RuntimeFloat>(
        &self,
        kind: StepKind,
        stages: &[Stage<T>],
        [state, carry]: [&mut [T]; 2],
        steps: u64,
    ) {
        with_scratch(T::single(), |scratch| {
            self.run(kind, stages, steps, scratch, |step, kind, registers, workspace| {
                step.advance(kind, [state, carry], registers, workspace, |x| kind.stored(x), T::factor);
            });
        });
    }

    /// Makes one step of `state`, and returns whether the step divided by exactly 0.
    pub(crate) fn divides_by_zero<T: RuntimeFloat>(&self, stages: &[Stage<T>], state: &mut [T]) -> bool {
        let (kind, mut divides) = (StepKind::of(T::PRECISION, false), false);
        with_scratch(T::single(), |scratch| {
            self.run(kind, stages, 1, scratch, |step, kind, registers, workspace| {
                step.advance(kind, [state, &mut []], registers, workspace, |x| x, EliminationPattern::factor);
                divides |= step.has_divided_by_zero(registers, workspace);
            });
        });
        divides
    }

    #[inline(always)]
    pub(crate) fn run<V: Scalar + Copy>(
        &self,
        kind: StepKind,
        stages: &[Stage<V>],
        steps: u64,
        Scratch { registers, workspace, .. }: &mut Scratch<V>,
        mut advance: impl FnMut(&Step, StepKind, &mut [V], &mut Workspace<V>),
    ) {
        let steps_of_field = self.steps();
        let form = |stage: &Stage<V>| steps_of_field.form(stage.is_general);
        let size = stages.iter().map(|stage| form(stage).registers()).max().unwrap_or(0);
        registers.clear();
        for (k, stage) in stages.iter().enumerate() {
            registers.resize(k * size, V::zero());
            form(stage).open(&stage.given, registers);
        }
        registers.resize(stages.len() * size, V::zero());
        for _ in 0..steps {
            for_each_stage(stages.len(), |k| {
                let kind =
                    StepKind { rounds_increments: StepForms::rounds::<V>(stages[k].is_general), ..kind };
                advance(form(&stages[k]), kind, &mut registers[k * size..][..size], workspace);
            });
        }
    }

    /// Evaluates `object` at a state; `constants` are the parameters and ε. If this field has no
    /// program for the object, `out` stays unchanged.
    pub(crate) fn evaluate<T: RuntimeFloat>(
        &self,
        object: MapObject,
        constants: &[T],
        state: &[T],
        out: &mut [T],
    ) {
        if T::has_evaluated(self, object, constants, state, out) {
            return;
        }
        match object {
            MapObject::Jacobian => self.jacobian(constants, state, out),
            MapObject::Matrix => {
                self.evaluate(self.at_eps(MapObject::FieldJacobian), constants, state, out);
                into_matrix(out, split(constants).1, state.len());
            }
            _ => with_scratch(T::single(), |scratch| {
                let Some(line) = self.line(object) else { return };
                let results = line.values(constants, &mut scratch.registers, state).iter();
                out.iter_mut().zip(results).for_each(|(out, result)| *out = result);
            }),
        }
    }

    /// Writes ∂x̃/∂x row by row: by dual numbers if the step has a straight-line program, and
    /// otherwise as the product A(x,ε)⁻¹·A(x̃,−ε).
    fn jacobian<T: RuntimeFloat>(&self, constants: &[T], state: &[T], out: &mut [T]) {
        let (parameters, eps) = split(constants);
        let step = self.steps().of_duals();
        if step.has_lanes() {
            with_scratch(T::duals(), |scratch| jacobian_by_duals(step, constants, state, out, scratch));
        } else {
            let mut next = state.to_vec();
            let kind = StepKind::of(T::PRECISION, false);
            self.advance(kind, &self.stages(&[constants.to_vec()]), [&mut next, &mut []], 1);
            let behind: Vec<T> = parameters.iter().copied().chain([-eps]).collect();
            self.evaluate(MapObject::Matrix, &behind, &next, out);
            if !step.solves_columns(constants, state, out) {
                let mut matrix = vec![T::zero(); out.len()];
                self.evaluate(MapObject::Matrix, constants, state, &mut matrix);
                solve(&mut matrix, out, state.len());
            }
        }
    }

    pub(crate) fn has_negative_determinant(&self, constants: &[f64], state: &[f64]) -> bool {
        let along_couplings = self.steps().form(false).has_negative_determinant(constants, state);
        along_couplings.unwrap_or_else(|| {
            let mut matrix = vec![0.0; state.len().pow(2)];
            self.evaluate(MapObject::Matrix, constants, state, &mut matrix);
            has_negative_determinant(&mut matrix, state.len())
        })
    }

    /// Returns the derivative of x̃ with respect to `constants[index]`, a parameter or ε.
    pub(crate) fn by_constant<T: RuntimeFloat>(&self, constants: &[T], index: usize, state: &[T]) -> Vec<T> {
        let mut extended: Vec<Dual<T, 1>> =
            constants.iter().map(|constant| Dual::from_value(*constant)).collect();
        extended[index] = Dual::coordinate(constants[index], 0);
        let mut point: Vec<Dual<T, 1>> = state.iter().map(|x| Dual::from_value(*x)).collect();
        let kind = StepKind::of(T::PRECISION, false);
        with_scratch(T::duals(), |scratch| {
            let stages = [self.stage(&extended, scratch)];
            self.run(kind, &stages, 1, scratch, |step, kind, registers, workspace| {
                step.advance(
                    kind,
                    [&mut point, &mut []],
                    registers,
                    workspace,
                    |x| x,
                    EliminationPattern::factor,
                );
            });
        });
        point.into_iter().map(|Dual { gradient: [slope], .. }| slope).collect()
    }
}

pub(crate) fn split<T: Copy>(constants: &[T]) -> (&[T], T) {
    let (eps, parameters) = constants.split_last().unwrap_or_else(|| unreachable!("there is an eps"));
    (parameters, *eps)
}

/// Returns the parameters and ε at which integrals are evaluated. Compositions nearly preserve the
/// integrals of the flow, which are the integrals at ε = 0.
pub(crate) fn integral_constants<T: FloatScalar>(constants: &[T], composition: Composition) -> Vec<T> {
    let (parameters, eps) = split(constants);
    let eps = if composition == Composition::KAHAN { eps } else { T::zero() };
    parameters.iter().copied().chain([eps]).collect()
}

pub(crate) fn stage_constants<T: RuntimeFloat>(
    kind: StepKind,
    constants: &[T],
    composition: Composition,
) -> Vec<Vec<T>> {
    let (parameters, eps) = split(constants);
    let stage = |gamma| parameters.iter().copied().chain([kind.stage_eps(gamma, eps)]).collect();
    distinct_coefficients(&composition).map(stage).collect()
}

pub(crate) fn jacobian_by_duals<V: Scalar + Copy>(
    step: &Step,
    constants: &[V],
    state: &[V],
    out: &mut [V],
    scratch: &mut Scratch<Dual<V, 1>>,
) {
    let Scratch { registers, workspace, constants: extended, given, state: point, .. } = scratch;
    [&mut *extended, given, point].into_iter().for_each(Vec::clear);
    extended.extend(constants.iter().map(|constant| Dual::from_value(*constant)));
    step.prepare(extended, registers, given);
    registers.clear();
    step.open(given, registers);
    point.extend(state.iter().map(|x| Dual::from_value(*x)));
    for j in 0..state.len() {
        point[j] = Dual::coordinate(state[j], 0);
        for (i, increment) in step.increments(point, registers, workspace).enumerate() {
            let [slope] = increment.gradient;
            out[i * state.len() + j] = if i == j { V::one() + slope } else { slope };
        }
        point[j] = Dual::from_value(state[j]);
    }
}
