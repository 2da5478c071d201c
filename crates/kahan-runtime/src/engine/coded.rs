//! The same by machine code, where there is some.

use std::sync::{Arc, OnceLock};

use crate::machine::{OrbitCode, StepKind};

use super::Engine;
use super::abreast::AbreastOnce;
use super::floats::{MachineFloat, RuntimeFloat};
use super::scratch::{Scratch, with_scratch};
use super::step::Steps;

/// Code, once it was asked for; `None` where there is none.
type CodeOnce<W> = OnceLock<Option<Arc<OrbitCode<W>>>>;

/// The stages of a step as code, with the constants of those that differ, the middle one last.
#[derive(Clone, Debug)]
pub(crate) struct CodedStages<T: RuntimeFloat> {
    code: Arc<OrbitCode<T::Word>>,
    pub(super) kind: StepKind,
    pub(super) constants: Arc<[Vec<T::Word>]>,
    /// The code that carries what a state lacks, once it was asked for.
    carrying: Arc<CodeOnce<T::Word>>,
    pub(super) abreast: Arc<AbreastOnce<T::Word>>,
}

impl<T: RuntimeFloat> CodedStages<T> {
    /// Replaces a state by the one so many steps later; `false` where code cannot tell, and the
    /// state is as before.
    pub(crate) fn has_advanced(&self, state: &mut [T], steps: u64) -> bool {
        T::has_run(&self.code, &self.constants, state, steps)
    }
}

impl<T: MachineFloat> CodedStages<T> {
    /// The state one step later.
    pub(crate) fn step(&self, state: &[T], next: &mut [T]) {
        self.code.step(state, &self.constants, next);
    }
}

impl Engine {
    /// The stages of a composition as code, where there is some and they are all of one form; `own`
    /// are the parameters and ε of those that differ.
    pub(crate) fn coded_stages<T: RuntimeFloat>(
        &self,
        kind: StepKind,
        own: &[Vec<T>],
    ) -> Option<CodedStages<T>> {
        let mut general = own.iter().map(|constants| self.steps().are_general(&super::split(constants).1));
        let is_general = general.next()?;
        let kind = StepKind { is_general, rounds_increments: Steps::rounds::<T>(is_general), ..kind };
        if general.any(|other| other != is_general) {
            return None;
        }
        let code = self.codes.orbit(self, kind, own.len() > 1)?;
        let (step, mut registers) = (self.steps().form(is_general), Vec::new());
        let mut prepared =
            |own| Some(step.prepared(own, &mut registers)?.iter().flat_map(T::words).collect());
        let constants = own.iter().map(|own| prepared(own)).collect::<Option<_>>()?;
        Some(CodedStages { code, kind, constants, carrying: Arc::default(), abreast: Arc::default() })
    }

    /// The same, with what the state lacks carried along; `false` where there is no code.
    pub(crate) fn has_advanced_with_carry<T: RuntimeFloat>(
        &self,
        stages: &CodedStages<T>,
        state: &mut [T],
        carry: &mut [T],
        steps: u64,
    ) -> bool {
        let code = stages.carrying.get_or_init(|| {
            let kind = StepKind { compensated: true, ..stages.kind };
            self.codes.orbit(self, kind, stages.constants.len() > 1)
        });
        let Some(code) = code else { return false };
        with_scratch(T::single(), |Scratch { state: numbers, .. }| {
            numbers.clear();
            numbers.extend(state.iter().chain(carry.iter()));
            let has_run = T::has_run(code, &stages.constants, numbers, steps);
            let (advanced, lacking) = numbers.split_at(state.len());
            state.copy_from_slice(advanced);
            carry.copy_from_slice(lacking);
            has_run
        })
    }
}
