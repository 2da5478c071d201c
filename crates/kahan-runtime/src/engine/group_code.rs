//! Compiled steps of a group of orbits, one orbit in each SIMD lane.
//!
//! In: the machine code of each orbit's stages. Out: points after some steps, with tangent vectors
//! on request, or integrals. All numbers equal those of single orbits bit for bit.

use std::sync::{Arc, OnceLock};

use kahan_core::observe::{GROUP, Group};

use crate::machine_code::{GroupKind, InstructionSet, Sweep, TangentKind};

use super::coded::CompiledStages;
use super::floats::MachineFloat;
use super::{Engine, for_each_stage};

/// The code of a group's steps, compiled at first use; `Some(None)` if compilation fails.
pub(crate) type GroupCodeCell<T> = OnceLock<Option<Arc<Sweep<T>>>>;

/// The machine code for steps of a group of orbits, with the constants of these orbits.
#[derive(Debug)]
pub(crate) struct GroupCode<T> {
    code: Arc<Sweep<T>>,
    /// The constants, ordered by stage, then by SIMD register, then by index within the stage.
    constants: Vec<T>,
    stages: usize,
}

impl Engine {
    /// Returns code for the steps of a group of orbits; the memory of `workspace` is reused.
    pub(crate) fn group_code<T: MachineFloat>(
        &self,
        stages: [&CompiledStages<T>; GROUP],
        set: Option<InstructionSet>,
        workspace: Vec<T>,
    ) -> Option<GroupCode<T>> {
        let first = stages[0];
        let count = first.is_like_all(&stages)?;
        let work = GroupKind::Steps(first.kind);
        let find = || self.codes.group_code(self, work, set.or_else(InstructionSet::best)?);
        let code = Arc::clone(first.abreast.get_or_init(find).as_ref()?);
        Some(GroupCode::of(code, count, workspace, |stage, lane, k| stages[lane].constants[stage][k]))
    }

    /// Returns code for the steps of a group of orbits, with tangent vectors after each point.
    ///
    /// If `constants` (the parameters and ε of each map) are given, a straight-line program uses
    /// them to compute the vectors. Otherwise a stage is a step of the variational field.
    pub(crate) fn group_code_with_vectors<T: MachineFloat>(
        &self,
        stages: [&CompiledStages<T>; GROUP],
        constants: Option<[&[T]; GROUP]>,
        (vectors, has_squares): (usize, bool),
        set: Option<InstructionSet>,
        workspace: Vec<T>,
    ) -> Option<GroupCode<T>> {
        let [first, ..] = stages;
        let count = first.is_like_all(&stages)?;
        let is_variational = constants.is_none();
        let work =
            GroupKind::Carrying(TangentKind { kind: first.kind, is_variational, vectors, has_squares });
        let code = self.codes.group_code(self, work, set.or_else(InstructionSet::best)?)?;
        let own = first.constants[0].len();
        Some(GroupCode::of(code, count, workspace, |stage, lane, k| match (constants, k.checked_sub(own)) {
            (Some(constants), Some(k)) => constants[lane][k],
            _ => stages[lane].constants[stage][k],
        }))
    }

    /// Returns code that writes the integrals of each orbit after the coordinates of its point.
    pub(crate) fn group_code_of_integrals<T: MachineFloat>(
        &self,
        constants: [&[T]; GROUP],
        set: Option<InstructionSet>,
        workspace: Vec<T>,
    ) -> Option<GroupCode<T>> {
        let code = self.codes.group_code(self, GroupKind::Integrals, set.or_else(InstructionSet::best)?)?;
        Some(GroupCode::of(code, 1, workspace, |_, lane, k| constants[lane][k]))
    }
}

impl<T: MachineFloat> GroupCode<T> {
    /// Gathers the constants; `constant` returns the number for a stage, a lane and an index.
    fn of(
        code: Arc<Sweep<T>>,
        stages: usize,
        workspace: Vec<T>,
        constant: impl Fn(usize, usize, usize) -> T,
    ) -> Self {
        let (width, mut constants) = (code.width(), workspace);
        constants.clear();
        for stage in 0..stages {
            for first in (0..GROUP).step_by(width) {
                for k in 0..code.constants() / width {
                    constants.extend((first..first + width).map(|lane| constant(stage, lane, k)));
                }
            }
        }
        GroupCode { code, constants, stages }
    }

    pub(crate) fn step(&self, columns: &mut [Group<T>]) {
        let length = self.constants.len() / self.stages;
        let of_stage = |k: usize| &self.constants[k * length..][..length];
        for_each_stage(self.stages, |k| self.code.run(columns, of_stage(k), 1));
    }

    pub(crate) fn advance(&self, columns: &mut [Group<T>], steps: u64) {
        match self.stages {
            1 => self.code.run(columns, &self.constants, steps),
            _ => (0..steps).for_each(|_| self.step(columns)),
        }
    }

    pub(crate) fn into_memory(self) -> Vec<T> {
        self.constants
    }
}
