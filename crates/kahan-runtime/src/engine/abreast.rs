//! The orbits of a group, side by side in registers, each with the bits that it has alone.
//!
//! In: the stages of each, as code. Out: points, or points with tangent vectors, one step later.

use std::sync::{Arc, OnceLock};

use kahan_core::observe::{GROUP, Group};

use crate::machine::{InstructionSet, SideBySide, Sweep};

use super::coded::CodedStages;
use super::floats::MachineFloat;
use super::{Engine, in_turn};

/// The most vectors that are carried at once.
const MOST_VECTORS: usize = 2;

/// The code for no tangent vector, one, and so on, once it was asked for; `None` where there is
/// none.
pub(crate) type AbreastOnce<T> = [OnceLock<Option<Arc<Sweep<T>>>>; MOST_VECTORS + 1];

/// The steps of a group's orbits, or another line over their columns.
#[derive(Debug)]
pub(crate) struct Abreast<T> {
    code: Arc<Sweep<T>>,
    /// Those of the stages that differ, one after another, each for one register after another.
    constants: Vec<T>,
    stages: usize,
}

impl Engine {
    /// The steps of orbits with these stages and so many tangent vectors each; `None` where they
    /// have no code in common. `workspace` is used for the constants.
    pub(crate) fn abreast<T: MachineFloat>(
        &self,
        stages: [&CodedStages<T>; GROUP],
        vectors: usize,
        set: Option<InstructionSet>,
        workspace: Vec<T>,
    ) -> Option<Abreast<T>> {
        let [first, ..] = stages;
        let count = first.constants.len();
        let kind = first.kind;
        if stages.iter().any(|own| own.kind != kind || own.constants.len() != count) {
            return None;
        }
        let work = SideBySide::Steps(kind, vectors);
        let find = || self.codes.abreast(self, work, set.or_else(InstructionSet::best)?);
        let code = Arc::clone(first.abreast.get(vectors)?.get_or_init(find).as_ref()?);
        Some(Abreast::of(code, count, workspace, |stage, lane, k| stages[lane].constants[stage][k]))
    }

    /// What writes the integrals of orbits behind their points; `constants` are the parameters and
    /// ε of each.
    pub(crate) fn integrals_abreast<T: MachineFloat>(
        &self,
        constants: [&[T]; GROUP],
        set: Option<InstructionSet>,
        workspace: Vec<T>,
    ) -> Option<Abreast<T>> {
        let code = self.codes.abreast(self, SideBySide::Integrals, set.or_else(InstructionSet::best)?)?;
        Some(Abreast::of(code, 1, workspace, |_, lane, k| constants[lane][k]))
    }
}

impl<T: MachineFloat> Abreast<T> {
    /// `constant` is that of a stage, a lane and a place.
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
        Abreast { code, constants, stages }
    }

    /// Replaces columns of a group by those one step later.
    pub(crate) fn step(&self, columns: &mut [Group<T>]) {
        let length = self.constants.len() / self.stages;
        let of_stage = |k: usize| &self.constants[k * length..][..length];
        in_turn(self.stages, |k| self.code.run(columns, of_stage(k), 1));
    }

    /// The room of its constants.
    pub(crate) fn into_room(self) -> Vec<T> {
        self.constants
    }
}
