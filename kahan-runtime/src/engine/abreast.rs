//! The orbits of a group, side by side in registers, each with the bits that it has alone.
//!
//! In: the stages of each, as code. Out: points, or points with tangent vectors, one step later.

use std::sync::{Arc, OnceLock};

use kahan_core::observe::{GROUP, Group};

use crate::machine::{InstructionSet, Sweep};

use super::coded::CodedStages;
use super::scratch::Scratches;
use super::{Engine, Instructions, in_turn};

/// The most vectors that are carried at once.
const MOST_VECTORS: usize = 2;

/// The code for no tangent vector, one, and so on, once it was asked for; `None` where there is none.
pub(crate) type AbreastOnce<T> = [OnceLock<Option<Arc<Sweep<T>>>>; MOST_VECTORS + 1];

/// The steps of a group's orbits.
#[derive(Debug)]
pub(crate) struct Abreast<T> {
    code: Arc<Sweep<T>>,
    /// Those of the stages that differ, one after another, each for one register after another.
    constants: Vec<T>,
    stages: usize,
}

impl Engine {
    /// The steps of orbits with these stages and so many tangent vectors each; `None` where they
    /// have no code in common. `room` is used for the constants.
    pub(crate) fn abreast<T: Scratches>(
        &self,
        stages: [&CodedStages<T>; GROUP],
        vectors: usize,
        Instructions { set, .. }: Instructions,
        room: Vec<T>,
    ) -> Option<Abreast<T>> {
        let [first, ..] = stages;
        let count = first.constants.len();
        let kind = (first.kind, first.form);
        if stages.iter().any(|own| (own.kind, own.form) != kind || own.constants.len() != count) {
            return None;
        }
        let find = || self.codes.abreast(&self.derived, kind, vectors, set.or_else(InstructionSet::best)?);
        let code = Arc::clone(first.abreast.get(vectors)?.get_or_init(find).as_ref()?);
        let mut constants = room;
        constants.clear();
        for stage in 0..count {
            for register in stages.chunks_exact(code.width()) {
                for k in 0..code.constants() / code.width() {
                    constants.extend(register.iter().map(|own| own.constants[stage][k]));
                }
            }
        }
        Some(Abreast { code, constants, stages: count })
    }
}

impl<T: Scratches> Abreast<T> {
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
