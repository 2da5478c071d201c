//! Advances many trajectories by machine code, in tiles.
//!
//! In: columns, with ε and parameters. Out: the columns after some steps. A tile holds at most 512
//! trajectories, in whole SIMD registers. With few variables, its steps run while it is in the L1
//! cache. Steps by elimination run 64 at a time.

use kahan_core::__private::LARGEST_FACTOR;
use kahan_core::Composition;

use crate::follow::is_finite;
use crate::machine_code::{ColumnsCode, InstructionSet, StepKind};

use super::coded::GUARDED;
use super::columns::{Columns, Tile, advance};
use super::floats::MachineFloat;
use super::scratch::with_scratch;
use super::{Engine, distinct_coefficients, for_each_stage};

const TILE: usize = 512;
/// The number of bytes in a cache line.
const LINE: usize = 64;
const PAGE: usize = 4096;
/// The least number of steps for which copying a tile to aligned memory saves time.
const WORTH_MOVING: u64 = 8;

impl Engine {
    /// Advances all trajectories by machine code. Returns `false` if the step has no machine code.
    pub(crate) fn has_advanced_columns<T: MachineFloat>(
        &self,
        columns: &mut Columns<'_, '_, T>,
        composition: Composition,
        steps: u64,
        kind: StepKind,
        set: Option<InstructionSet>,
    ) -> bool {
        let Some(set) = set.or_else(InstructionSet::best) else { return false };
        let trajectories = columns.columns.first().map_or(0, |column| column.len() as u64);
        if !self.codes.is_worth_compiling(trajectories.saturating_mul(steps), self) {
            return false;
        }
        let Some(code) = self.codes.columns(self, kind, set) else { return false };
        if code.is_guarded() {
            self.advance_guarded(&code, columns, composition, steps, kind);
        } else {
            run(&code, columns, composition, steps, kind);
        }
        true
    }

    fn advance_guarded<T: MachineFloat>(
        &self,
        code: &ColumnsCode<T>,
        columns: &mut Columns<'_, '_, T>,
        composition: Composition,
        steps: u64,
        kind: StepKind,
    ) {
        let step = (self.steps().form(kind.is_general), kind);
        let trajectories = columns.columns.first().map_or(0, |column| column.len());
        let mut kept = with_scratch(T::single(), |scratch| std::mem::take(&mut scratch.guarded));
        for first in (0..trajectories).step_by(TILE) {
            let piece = first..trajectories.min(first + TILE);
            for made in (0..steps).step_by(GUARDED as usize) {
                let now = GUARDED.min(steps - made);
                kept.clear();
                columns.columns.iter().for_each(|column| kept.extend_from_slice(&column[piece.clone()]));
                let length = kept.len();
                kept.resize(length + piece.len(), T::zero());
                let (before, guard) = kept.split_at_mut(length);
                columns.with_part(&piece, Some(guard), |own| run(code, own, composition, now, kind));
                for k in piece.clone() {
                    let is_kept = guard[k - first].approximate() <= LARGEST_FACTOR as f64;
                    if is_kept && columns.columns.iter().all(|column| is_finite(&column[k..=k])) {
                        continue;
                    }
                    for (column, before) in columns.columns.iter_mut().zip(before.chunks_exact(piece.len())) {
                        column[k] = before[k - first];
                    }
                    columns.with_part(&(k..k + 1), None, |own| {
                        advance(step, T::single(), own, composition, now);
                    });
                }
            }
        }
        with_scratch(T::single(), |scratch| scratch.guarded = kept);
    }
}

fn run<T: MachineFloat>(
    code: &ColumnsCode<T>,
    columns: &mut Columns<'_, '_, T>,
    composition: Composition,
    steps: u64,
    kind: StepKind,
) {
    with_scratch(T::single(), |scratch| {
        let mut prepared =
            PreparedColumns { code, kind, composition, constants: &mut scratch.given, length: 0 };
        let is_one = |values: &[T]| values.len() == 1;
        let are_shared = is_one(columns.eps) && columns.parameters.iter().all(|values| is_one(values));
        if are_shared {
            prepared.of_registers(columns, 0, 1, &mut scratch.constants);
        }
        let (trajectories, width) = (columns.columns.first().map_or(0, |column| column.len()), code.width());
        let whole = trajectories / width * width;
        for first in (0..whole).step_by(TILE) {
            let end = whole.min(first + TILE);
            if !are_shared {
                prepared.of_registers(columns, first, (end - first) / width, &mut scratch.constants);
            }
            let mut tile: Tile<'_, T> =
                columns.columns.iter_mut().map(|column| &mut column[first..end]).collect();
            let crosses = |column: &&mut [T]| column.as_ptr().align_offset(LINE) != 0;
            if steps >= WORTH_MOVING && tile.iter().any(crosses) {
                run_in_lines(&mut tile, &mut scratch.state, |moved| {
                    prepared.run(moved, are_shared, steps);
                });
            } else {
                prepared.run(&mut tile, are_shared, steps);
            }
        }
        if whole < trajectories {
            if !are_shared {
                prepared.of_registers(columns, whole, 1, &mut scratch.constants);
            }
            let rest = &mut scratch.state;
            rest.clear();
            for column in columns.columns.iter() {
                let last = column[trajectories - 1];
                rest.extend(column[whole..].iter().copied().chain(core::iter::repeat(last)).take(width));
            }
            {
                let mut tile: Tile<'_, T> = rest.chunks_exact_mut(width).collect();
                prepared.run(&mut tile, are_shared, steps);
            }
            for (column, advanced) in columns.columns.iter_mut().zip(rest.chunks_exact(width)) {
                let rest = &mut column[whole..];
                rest.copy_from_slice(&advanced[..rest.len()]);
            }
        }
    });
}

/// Copies a tile to columns aligned to cache lines, and advances the copy.
fn run_in_lines<T: MachineFloat>(
    tile: &mut [&mut [T]],
    workspace: &mut Vec<T>,
    run: impl FnOnce(&mut [&mut [T]]),
) {
    let line = LINE / size_of::<T>();
    let len = tile.first().map_or(0, |column| column.len());
    // Columns begin at offsets that are spread over a page. With equal offsets, loads would wait
    // for unrelated stores (4K aliasing).
    let page = PAGE / size_of::<T>();
    let apart = (page / tile.len().max(1)).next_multiple_of(line);
    let stride = len.next_multiple_of(page) + apart;
    workspace.clear();
    workspace.resize(tile.len() * stride + line, T::zero());
    let begin = workspace.as_ptr().align_offset(LINE).min(line);
    let columns = || (0..).step_by(stride).map(|at| at..at + len);
    let moved = &mut workspace[begin..];
    tile.iter().zip(columns()).for_each(|(column, place)| moved[place].copy_from_slice(column));
    run(&mut moved
        .chunks_mut(stride)
        .map(|column| &mut column[..len])
        .take(tile.len())
        .collect::<Tile<'_, T>>());
    tile.iter_mut().zip(columns()).for_each(|(column, place)| column.copy_from_slice(&moved[place]));
}

struct PreparedColumns<'a, T> {
    code: &'a ColumnsCode<T>,
    kind: StepKind,
    composition: Composition,
    constants: &'a mut Vec<T>,
    length: usize,
}

impl<T: MachineFloat> PreparedColumns<'_, T> {
    /// Prepares the constants of `registers` registers, which begin with trajectory `first`.
    fn of_registers(
        &mut self,
        Columns { columns, eps, parameters }: &Columns<'_, '_, T>,
        first: usize,
        registers: usize,
        given: &mut Vec<T>,
    ) {
        let (width, last) =
            (self.code.width(), columns.first().map_or(0, |column| column.len()).saturating_sub(1));
        self.constants.clear();
        for gamma in distinct_coefficients(&self.composition) {
            for register in 0..registers {
                let place = |lane: usize| last.min(first + register * width + lane);
                let of = |values: &[T], lane: usize| {
                    if values.len() == 1 { values[0] } else { values[place(lane)] }
                };
                given.clear();
                parameters.iter().for_each(|values| given.extend((0..width).map(|lane| of(values, lane))));
                given.extend((0..width).map(|lane| self.kind.stage_eps(gamma, of(eps, lane))));
                self.code.prepare(given, self.constants);
            }
        }
        self.length = self.constants.len() / distinct_coefficients(&self.composition).len();
    }

    fn run(&self, tile: &mut [&mut [T]], are_shared: bool, steps: u64) {
        let stages = distinct_coefficients(&self.composition).len();
        let of_stage = |k: usize| &self.constants[k * self.length..][..self.length];
        if stages == 1 {
            self.code.advance_columns(tile, of_stage(0), are_shared, steps);
        } else {
            (0..steps).for_each(|_| {
                for_each_stage(stages, |k| self.code.advance_columns(tile, of_stage(k), are_shared, 1));
            });
        }
    }
}
