//! The step of a dense field by loops over packed coefficients, with the bits of the interpreter.
//!
//! In: the numbers of a state, and of each stage the packed coefficients with ε behind them. Out:
//! the numbers some steps later, and behind them a guard: it is infinite where the interpreter has
//! to make the steps, since a number is not finite or a state is −0.

use kahan_core::__private::dense::{assemble, pack, velocity};
use kahan_core::Precision;

use crate::follow::is_finite;
use crate::line::Line;
use crate::machine::StepKind;

use super::elimination::solve;
use super::floats::MachineFloat;
use super::scratch::{Scratch, with_scratch};
use super::step::add_increment;
use super::{Engine, in_turn};

impl Engine {
    /// The line of the coefficients of a dense field, from its parameters.
    fn coefficients(&self) -> Option<&Line> {
        let line = || Some(Line::of(self.derived.coefficients()?, &self.derived.system.field.symbols));
        self.coefficients.get_or_init(line).as_ref()
    }

    /// Whether there are loops for steps of a kind: the field is dense, and the bits are those of
    /// this build.
    pub(super) fn has_loops(&self, kind: StepKind) -> bool {
        kind.precision != Precision::DoubleDouble
            && kind.fuses == cfg!(target_feature = "fma")
            && self.coefficients().is_some()
    }

    /// What the loops of a dense field take; `constants` are the parameters and ε.
    pub(super) fn packed<T: MachineFloat>(&self, constants: &[T]) -> Option<Vec<T>> {
        let mut registers = Vec::new();
        let field: Vec<T> = self.coefficients()?.values(constants, &mut registers, &[]).iter().collect();
        let mut packed = Vec::with_capacity(field.len() + field.len() / 4);
        pack(self.dimension(), &field, &mut packed);
        packed.extend(constants.last());
        Some(packed)
    }
}

/// Advances the numbers of a state, with a guard behind them, by steps of a dense field. Of each
/// stage that differs `stages` has what [`Engine::packed`] gives, the middle one last.
pub(crate) fn advance<T: MachineFloat>(kind: StepKind, numbers: &mut [T], stages: &[Vec<T>], steps: u64) {
    let Some((guard, numbers)) = numbers.split_last_mut() else { return };
    let dimension = if kind.compensated { numbers.len() / 2 } else { numbers.len() };
    let (state, carry) = numbers.split_at_mut(dimension);
    with_scratch(T::single(), |scratch| {
        for _ in 0..steps {
            in_turn(stages.len(), |k| {
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
    let is_negative_zero = |x: &T| x.is_zero() && (T::one() / *x).approximate() < 0.0;
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
        add_increment(kind, time_step * *velocity, &mut state[i], carry.get_mut(i));
    }
    is_finite(state)
}
