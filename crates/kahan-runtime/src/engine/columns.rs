//! Many trajectories, one column for each variable.
//!
//! In: columns, ε and parameters; each value is shared, or each trajectory has a value of its own.
//! Out: the columns after some steps. Each SIMD lane holds one trajectory. With elimination,
//! trajectories advance one after the other, because each may need other row exchanges.

use core::ops::Range;

use kahan_core::__private::Lanes;
use kahan_core::Composition;
use smallvec::SmallVec;

use crate::machine_code::StepKind;

use super::couplings::EliminationPattern;
use super::floats::{MachineFloat, RuntimeFloat};
use super::scratch::{Scratch, ScratchKey, with_scratch};
use super::step::{Step, StepForms};
use super::{Engine, distinct_coefficients, for_each_stage};

#[derive(Debug)]
pub(crate) struct Columns<'a, 'b, T> {
    /// Column c holds variable c of all trajectories.
    pub(crate) columns: &'a mut [&'b mut [T]],
    pub(crate) eps: &'a [T],
    pub(crate) parameters: &'a [&'a [T]],
}

/// A range of rows of every column. Up to 64 columns need no heap allocation.
pub(super) type Tile<'a, T> = SmallVec<[&'a mut [T]; 64]>;

impl<T> Columns<'_, '_, T> {
    pub(super) fn with_part(
        &mut self,
        trajectories: &Range<usize>,
        guard: Option<&mut [T]>,
        run: impl FnOnce(&mut Columns<'_, '_, T>),
    ) {
        let mut columns: Tile<'_, T> =
            self.columns.iter_mut().map(|column| &mut column[trajectories.clone()]).collect();
        columns.extend(guard);
        let parameters = self.parameters.iter().map(|values| values_of(values, trajectories));
        let parameters: SmallVec<[&[T]; 8]> = parameters.collect();
        let eps = values_of(self.eps, trajectories);
        run(&mut Columns { columns: &mut columns, eps, parameters: &parameters });
    }
}

pub(crate) fn values_of<'a, T>(values: &'a [T], trajectories: &Range<usize>) -> &'a [T] {
    if values.len() > 1 { &values[trajectories.clone()] } else { values }
}

const LANES: usize = 8;

#[inline(always)]
fn gather_lanes<T: MachineFloat, V: Lanes<T>>(number: impl Fn(usize) -> T) -> V {
    let mut numbers = [T::zero(); LANES];
    for (place, own) in numbers[..V::WIDTH].iter_mut().enumerate() {
        *own = number(place);
    }
    V::load(&numbers, 0)
}

#[inline(always)]
fn scatter_lanes<T: MachineFloat, V: Lanes<T>>(register: V) -> [T; LANES] {
    let mut numbers = [T::zero(); LANES];
    register.store(&mut numbers, 0);
    numbers
}

impl Engine {
    pub(crate) fn interpret_columns<T: MachineFloat>(
        &self,
        columns: &mut Columns<'_, '_, T>,
        composition: Composition,
        steps: u64,
        kind: StepKind,
    ) {
        let step = (self.steps().form(kind.is_general), kind);
        if step.0.has_lanes() {
            advance(step, T::lanes(), columns, composition, steps);
        } else {
            advance(step, T::single(), columns, composition, steps);
        }
    }

    /// Returns `kind` with the formula of single orbits; `None` if they use several at these ε.
    pub(crate) fn kind_of_orbits<T: MachineFloat>(
        &self,
        kind: StepKind,
        eps: &[T],
        composition: Composition,
    ) -> Option<StepKind> {
        let each = |eps: &T| {
            let eps = *eps;
            distinct_coefficients(&composition).map(move |gamma| kind.stage_eps(gamma, eps))
        };
        self.kind_at(kind, eps.iter().flat_map(each))
    }

    /// Returns the common kind of step at these values of ε; `None` if the kinds differ.
    pub(super) fn kind_at<T: RuntimeFloat>(
        &self,
        kind: StepKind,
        eps: impl Iterator<Item = T>,
    ) -> Option<StepKind> {
        let mut general = eps.map(|eps| self.steps().are_general(&eps));
        let is_general = general.next().unwrap_or(true);
        let kind = StepKind { is_general, rounds_increments: StepForms::rounds::<T>(is_general), ..kind };
        general.all(|other| other == is_general).then_some(kind)
    }
}

/// Advances trajectories in groups of `V::WIDTH`; copies of the last trajectory fill the last
/// group.
pub(super) fn advance<T, V>(
    (step, kind): (&Step, StepKind),
    local: ScratchKey<V>,
    Columns { columns, eps, parameters }: &mut Columns<'_, '_, T>,
    composition: Composition,
    steps: u64,
) where
    T: MachineFloat,
    V: Lanes<T>,
{
    let trajectories = columns.first().map_or(0, |column| column.len());
    let (stages, size) = (distinct_coefficients(&composition).len(), step.registers());
    with_scratch(local, |Scratch { registers, workspace, constants, given, state, .. }| {
        for first in (0..trajectories).step_by(V::WIDTH) {
            let last = trajectories.min(first + V::WIDTH) - 1;
            let gather = |values: &[T]| {
                gather_lanes(
                    |place| if values.len() == 1 { values[0] } else { values[last.min(first + place)] },
                )
            };
            [&mut *constants, given, state].into_iter().for_each(Vec::clear);
            state.extend(columns.iter().map(|column| gather(column)));
            constants.extend(parameters.iter().map(|values| gather(values)));
            constants.push(V::zero());
            let eps = scatter_lanes::<T, V>(gather(eps));
            for gamma in distinct_coefficients(&composition) {
                constants[parameters.len()] = gather_lanes(|place| kind.stage_eps(gamma, eps[place]));
                step.prepare(constants, registers, given);
            }
            registers.clear();
            given.chunks_exact(given.len() / stages).for_each(|given| step.open(given, registers));
            for _ in 0..steps {
                for_each_stage(stages, |k| {
                    let registers = &mut registers[k * size..][..size];
                    let stored = |x: V| {
                        let x = scatter_lanes(x);
                        gather_lanes(|place| kind.stored(x[place]))
                    };
                    step.advance(
                        kind,
                        [state, &mut []],
                        registers,
                        workspace,
                        stored,
                        EliminationPattern::factor,
                    );
                });
            }
            for (column, x) in columns.iter_mut().zip(&*state) {
                let x = scatter_lanes(*x);
                column[first..=last].copy_from_slice(&x[..=last - first]);
            }
        }
    });
}
