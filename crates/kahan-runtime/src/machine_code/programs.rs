//! Programs to compile, written by running the interpreter over [`Traced`] numbers.
//!
//! In: an engine with its plans. Out: a `Program` of `kahan-jit` that has the interpreter's
//! operations in their order. An elimination becomes a program with a guard. The result is `None`
//! for a long elimination, and for some steps in double-double.

use kahan_core::Scalar;
use kahan_dynamics::Precision;
use kahan_jit::{Input, Program};

use crate::engine::{
    EliminationPattern, Engine, MachineFloat, MapObject, Scratch, Step, into_matrix, jacobian_by_duals,
};
use crate::line::Line;

use super::double_double::{self, Pair};
use super::traced::{self, Traced};
use super::{InstructionSet, StepKind, TangentKind};

const MOST_OPERATIONS: u32 = 50_000;

impl StepKind {
    /// Returns the program that computes the next state from a state, with the prepared constants
    /// of the step. `None` for branching steps, and for double-double with compensation.
    ///
    /// A state is x₁, …, xₙ; a compensated state has n rounding errors after it. In double-double
    /// each xᵢ is two numbers, the high one first, and a guard is last, which is 0 if the result is
    /// valid.
    pub(super) fn program<T: MachineFloat>(self, engine: &Engine) -> Option<Program> {
        let step = engine.steps().form(self.is_general);
        let variables = engine.dimension();
        if self.precision == Precision::DoubleDouble {
            if self.compensated {
                return None;
            }
            return double_double::program(self.fuses, || {
                let state = (0..variables).map(|i| Pair::of(Input::State, i)).collect();
                self.advanced(step, state, |k| Pair::of(Input::Constant, k), |pair| pair)
            });
        }
        let numbers = if self.compensated { 2 * variables } else { variables };
        traced::program(|| self.next(step, Traced::<T>::states(0..numbers)))
    }

    pub(super) fn guarded_program<T: MachineFloat>(self, engine: &Engine) -> Option<(Program, bool)> {
        match self.program::<T>(engine) {
            Some(program) => Some((program, self.precision == Precision::DoubleDouble)),
            None => Some((self.eliminating::<T>(engine)?, true)),
        }
    }

    /// Returns the program of a step by elimination. The last result is at most
    /// [`LARGEST_FACTOR`](kahan_core::__private::LARGEST_FACTOR) while all pivots are accepted and
    /// all numbers are finite.
    fn eliminating<T: MachineFloat>(self, engine: &Engine) -> Option<Program> {
        if !self.has_eliminating_code(engine) {
            return None;
        }
        let step = engine.steps().form(self.is_general);
        let variables = engine.dimension();
        let numbers = if self.compensated { 2 * variables } else { variables };
        traced::program(|| {
            let mut numbers = Traced::<T>::states(0..=numbers);
            let guard = numbers.pop()?;
            let (mut scratch, mut given) = (Scratch::default(), Vec::new());
            step.prepare(&constants(engine), &mut scratch.registers, &mut given);
            scratch.registers.clear();
            step.open(&given, &mut scratch.registers);
            let (state, carry) = numbers.split_at_mut(variables);
            let mut growth = None;
            step.advance(
                self,
                [state, carry],
                &mut scratch.registers,
                &mut scratch.workspace,
                Traced::rounded_to_single,
                |tables, slopes, eps, factors| {
                    let compare = [Traced::larger, Traced::smaller];
                    growth = tables.growth(slopes, eps, factors, Traced::magnitude, compare);
                    true
                },
            );
            numbers.push(growth.map_or(guard, |growth| guard.larger(growth)));
            Some(numbers)
        })
    }

    /// Returns whether a step by elimination can be compiled: not in double-double, and not with
    /// more than [`MOST_OPERATIONS`] operations.
    pub(crate) fn has_eliminating_code(self, engine: &Engine) -> bool {
        InstructionSet::best().is_some()
            && self.precision != Precision::DoubleDouble
            && self.fuses == Self::INTERPRETER_FUSES
            && engine.codes.operations(engine).is_some_and(|operations| operations <= MOST_OPERATIONS)
    }

    fn next<T: MachineFloat>(self, step: &Step, numbers: Vec<Traced<T>>) -> Option<Vec<Traced<T>>> {
        let constant = |k| Traced::input(Input::Constant(k));
        self.advanced(step, numbers, constant, Traced::rounded_to_single)
    }

    /// Returns the state one step later; `None` for a step that branches.
    fn advanced<V: Scalar + Copy>(
        self,
        step: &Step,
        mut numbers: Vec<V>,
        constant: impl Fn(usize) -> V,
        single: impl Fn(V) -> V,
    ) -> Option<Vec<V>> {
        let [_, kernel] = step.lines()?;
        let mut registers = vec![V::zero(); kernel.registers()];
        kernel.give((0..).map(constant), &mut registers);
        let (state, carry) = numbers.split_at_mut(step.quotients.len());
        let workspace = &mut Scratch::default().workspace;
        step.advance(self, [state, carry], &mut registers, workspace, single, EliminationPattern::factor);
        Some(numbers)
    }
}

impl TangentKind {
    /// Returns the program that advances a point and its tangent vectors, and on request computes
    /// the squared lengths of the vectors. `None` for a step that branches.
    pub(super) fn program<T: MachineFloat>(self, engine: &Engine) -> Option<Program> {
        let step = engine.steps().form(self.kind.is_general);
        let n = engine.dimension() / if self.is_variational { 2 } else { 1 };
        traced::program(|| {
            let x = Traced::<T>::states(0..n);
            let mut numbers = match self.is_variational {
                true => Vec::new(),
                false => self.kind.next(step, x.clone())?,
            };
            let mut squares = Vec::new();
            for k in 1..=self.vectors {
                // All vectors use one traced point, so that common subexpressions in x are compiled
                // once.
                let v = Traced::states(k * n..(k + 1) * n);
                let carried = if self.is_variational {
                    let mut next = self.kind.next(step, [&x[..], &v].concat())?;
                    let carried = next.split_off(n);
                    numbers.extend(next.into_iter().filter(|_| k == 1));
                    carried
                } else {
                    let next = &numbers[..n];
                    tangent(engine, self.kind, &[&x[..], &v, next, next].concat())?
                };
                squares
                    .extend(carried.iter().map(|entry| *entry * *entry).reduce(|sum, square| sum + square));
                numbers.extend(carried);
            }
            numbers.extend(squares.into_iter().filter(|_| self.has_squares));
            Some(numbers)
        })
    }
}

/// Returns (∂x̃/∂x)·v for a tangent vector v at x; `state` is x, v, x̃ and n unused numbers.
fn tangent<T: MachineFloat>(engine: &Engine, kind: StepKind, state: &[Traced<T>]) -> Option<Vec<Traced<T>>> {
    let [prepared, _] = engine.steps().form(kind.is_general).lines()?;
    let (line, first) = (engine.line(MapObject::Tangent)?, prepared.outputs());
    let count = engine.derived.system.field.symbols.parameters.len() + 1;
    let constants = (first..first + count).map(|k| Traced::input(Input::Constant(k)));
    Some(traced::unfused(|| results(line, &constants.collect::<Vec<_>>(), state)))
}

/// Returns the program that computes an object from a state, if the object has a straight-line
/// program.
pub(super) fn object<T: MachineFloat>(object: MapObject, engine: &Engine) -> Option<Program> {
    traced::program(|| {
        let n = engine.dimension();
        let points = if object == MapObject::Tangent { 4 } else { 1 };
        let (state, constants) = (Traced::<T>::states(0..points * n), constants(engine));
        match object {
            MapObject::Matrix => {
                let mut slopes =
                    results(engine.line(engine.at_eps(MapObject::FieldJacobian))?, &constants, &state);
                into_matrix(&mut slopes, constants[constants.len() - 1], n);
                Some(slopes)
            }
            MapObject::Jacobian => {
                let step = engine.steps().of_duals();
                step.lines()?;
                let mut slopes = vec![state[0]; n * n];
                jacobian_by_duals(step, &constants, &state, &mut slopes, &mut Scratch::default());
                Some(slopes)
            }
            _ => Some(results(engine.line(object)?, &constants, &state)),
        }
    })
}

pub(super) fn prepared<T: MachineFloat>(engine: &Engine, is_general: bool) -> Option<Program> {
    let lines = engine.steps().form(is_general).lines();
    traced::program(|| {
        let constants = constants::<T>(engine);
        Some(match lines {
            Some([prepared, _]) => results(prepared, &constants, &[]),
            None => constants,
        })
    })
}

pub(super) fn integrals_behind_the_state<T: MachineFloat>(engine: &Engine) -> Option<Program> {
    traced::program(|| {
        let state = Traced::<T>::states(0..engine.dimension());
        let integrals = results(engine.line(MapObject::Integrals)?, &constants(engine), &state);
        Some([state, integrals].concat())
    })
}

fn constants<T: MachineFloat>(engine: &Engine) -> Vec<Traced<T>> {
    (0..=engine.derived.system.field.symbols.parameters.len())
        .map(|k| Traced::input(Input::Constant(k)))
        .collect()
}

fn results<T: MachineFloat>(line: &Line, constants: &[Traced<T>], state: &[Traced<T>]) -> Vec<Traced<T>> {
    line.values(constants, &mut Vec::new(), state).iter().collect()
}
