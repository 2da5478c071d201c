//! Advances states of a dense field by loops over packed coefficients.
//!
//! In: the numbers of a state, and for each stage the packed coefficients and ε. Out: the numbers
//! after some steps, bit for bit as `Engine::advance` computes them, and a guard. If the guard is
//! infinite, `Engine::advance` must repeat the steps.

use kahan_algebra::rational::Rational;
use kahan_core::__private::LARGEST_FACTOR;
use kahan_core::__private::dense::{assemble, pack, points, velocities, velocity};
use kahan_core::Constant;
use kahan_dynamics::Precision;
use smallvec::SmallVec;

use crate::follow::is_finite;
use crate::line::Line;
use crate::machine_code::StepKind;

use super::elimination::solve;
use super::floats::MachineFloat;
use super::scratch::{Scratch, with_scratch};
use super::step::add_quotient;
use super::{Engine, for_each_stage};

/// The number of steps between two checks of pivots.
const STEPS_PER_CHECK: u64 = 8;

impl Engine {
    fn coefficients(&self) -> Option<&Line> {
        let line = || Some(Line::of(self.derived.coefficients()?, &self.derived.system.field.symbols));
        self.coefficients.get_or_init(line).as_ref()
    }

    /// Returns whether loops over packed coefficients apply to steps of this kind.
    pub(super) fn has_loops(&self, kind: StepKind) -> bool {
        kind.precision != Precision::DoubleDouble
            && kind.fuses == StepKind::INTERPRETER_FUSES
            && self.derived.is_dense()
    }

    pub(super) fn packed<T: MachineFloat>(&self, constants: &[T]) -> Option<Vec<T>> {
        let pack = |field: &[T]| {
            let mut packed = Vec::with_capacity(field.len() + field.len() / 4);
            pack(self.dimension(), field, &mut packed);
            packed
        };
        let mut packed = if self.derived.system.field.symbols.parameters.is_empty() {
            let slot = &self.packed[usize::from(T::PRECISION == Precision::Double)];
            if slot.get().is_none() {
                let field: Vec<T> = self.derived.numbers()?.into_iter().map(nearest).collect();
                slot.get_or_init(|| Box::new(pack(&field)));
            }
            slot.get()?.downcast_ref::<Vec<T>>()?.clone()
        } else {
            let values =
                self.coefficients()?.values(constants, &mut Vec::new(), &[]).iter().collect::<Vec<T>>();
            pack(&values)
        };
        packed.extend(constants.last());
        Some(packed)
    }
}

fn nearest<T: MachineFloat>(number: &Rational) -> T {
    let (single, double) = match T::PRECISION {
        Precision::Single => (number.to_f32(), 0.0),
        _ => (0.0, number.to_f64()),
    };
    T::constant(&Constant::exact(number.is_negative(), &[], &[], single, double, 0.0))
}

/// Advances a state by steps of a dense field. The last of the `numbers` is a guard, which becomes
/// infinite if `Engine::advance` must repeat the steps. `stages` holds the coefficients of each
/// stage of a palindromic composition, up to the middle stage.
pub(crate) fn advance<T: MachineFloat>(kind: StepKind, numbers: &mut [T], stages: &[Vec<T>], steps: u64) {
    let Some((guard, numbers)) = numbers.split_last_mut() else { return };
    let dimension = if kind.compensated { numbers.len() / 2 } else { numbers.len() };
    let (state, carry) = numbers.split_at_mut(dimension);
    with_scratch(T::single(), |scratch| {
        for _ in 0..steps {
            for_each_stage(stages.len(), |k| {
                if !guard.is_zero() || !has_stepped(kind, [state, carry], &stages[k], scratch) {
                    *guard = T::one() / T::zero();
                }
            });
        }
    });
}

fn has_stepped<T: MachineFloat>(
    kind: StepKind,
    [state, carry]: [&mut [T]; 2],
    stage: &[T],
    Scratch { workspace, dense, .. }: &mut Scratch<T>,
) -> bool {
    let Some((&eps, packed)) = stage.split_last() else { return false };
    let n = state.len();
    if state.iter().any(is_negative_zero) {
        return false;
    }
    let outcome = &mut workspace.outcome;
    outcome.clear();
    if velocity(packed, state, eps, dense) {
        outcome.extend_from_slice(dense.last(n));
    } else {
        assemble(packed, state, eps, dense);
        outcome.extend_from_slice(dense.last(n));
        let matrix = &mut workspace.matrix;
        matrix.clear();
        matrix.extend((0..n * n).map(|place| dense.entry(n, [place / n, place % n])));
        solve(matrix, outcome, n);
    }
    let time_step = eps + eps;
    for (i, velocity) in outcome.iter().enumerate() {
        let (x, carry) = (&mut state[i], carry.get_mut(i));
        add_quotient(kind, (time_step * *velocity, None), x, carry, |x| kind.stored(x));
    }
    is_finite(state)
}

fn is_negative_zero<T: MachineFloat>(x: &T) -> bool {
    x.is_zero() && (T::one() / *x).approximate() < 0.0
}

/// Advances many trajectories by SIMD loops; each column holds one variable. The closure `alone`
/// repeats steps with a too small pivot, with a number that is not finite, or from a state with −0.
pub(crate) fn advance_columns<T: MachineFloat>(
    kind: StepKind,
    columns: &mut [&mut [T]],
    stages: &[Vec<T>],
    steps: u64,
    mut alone: impl FnMut(&mut [T], u64),
) {
    let (n, width) = (columns.len(), points::<T>());
    let trajectories = columns.first().map_or(0, |column| column.len());
    // Take the scratch memory out of its thread-local cell, because `alone` borrows the cell too.
    let mut scratch = with_scratch(T::single(), std::mem::take);
    let Scratch { state, guarded, given, registers, workspace, dense, .. } = &mut scratch;
    for first in (0..trajectories).step_by(width) {
        let count = width.min(trajectories - first);
        state.clear();
        for column in columns.iter() {
            let last = column[first + count - 1];
            state.extend(column[first..first + count].iter().copied());
            state.resize(state.len() + width - count, last);
        }
        for made in (0..steps).step_by(STEPS_PER_CHECK as usize) {
            let now = STEPS_PER_CHECK.min(steps - made);
            guarded.clone_from(state);
            let [largest, growth] = [&mut *registers, &mut *given].map(|list| {
                list.clear();
                list.resize(width, T::zero());
                &mut list[..]
            });
            for _ in 0..now {
                for_each_stage(stages.len(), |k| {
                    let Some((&eps, packed)) = stages[k].split_last() else { return };
                    let velocity = &mut workspace.outcome;
                    velocity.clone_from(state);
                    velocities(packed, velocity, eps, growth, dense);
                    let time_step = eps + eps;
                    for (x, velocity) in state.iter_mut().zip(velocity) {
                        add_quotient(kind, (time_step * *velocity, None), x, None, |x| kind.stored(x));
                    }
                    for (largest, growth) in largest.iter_mut().zip(&*growth) {
                        *largest = if growth.is_better_pivot(largest) { *growth } else { *largest };
                    }
                });
            }
            for p in 0..count {
                let mut own = (0..n).map(|i| i * width + p);
                let is_kept = largest[p].approximate().abs() <= LARGEST_FACTOR as f64
                    && own
                        .all(|place| is_finite(&state[place..=place]) && !is_negative_zero(&guarded[place]));
                if !is_kept {
                    let mut x: SmallVec<[T; 64]> = (0..n).map(|i| guarded[i * width + p]).collect();
                    alone(&mut x, now);
                    x.iter().enumerate().for_each(|(i, x)| state[i * width + p] = *x);
                }
            }
        }
        for (column, advanced) in columns.iter_mut().zip(state.chunks_exact(width)) {
            column[first..first + count].copy_from_slice(&advanced[..count]);
        }
    }
    with_scratch(T::single(), |own| *own = scratch);
}
