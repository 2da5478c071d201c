//! The same by machine code, where there is some.

use std::sync::{Arc, OnceLock};

use kahan_core::{Composition, Scalar};

use crate::machine::{OrbitCode, StepKind};

use super::abreast::AbreastOnce;
use super::scratch::{Scratch, Scratches, with_scratch};
use super::step::Steps;
use super::{Engine, stage_constants};

/// The stages of a step as code, with the constants of those that differ, the middle one last.
#[derive(Clone, Debug)]
pub(crate) struct CodedStages<T> {
    code: Arc<OrbitCode<T>>,
    pub(super) kind: StepKind,
    pub(super) constants: Arc<[Vec<T>]>,
    /// The code that carries what a state lacks, once it was asked for.
    carrying: Arc<OnceLock<Option<Arc<OrbitCode<T>>>>>,
    pub(super) abreast: Arc<AbreastOnce<T>>,
}

impl<T: Scratches> CodedStages<T> {
    /// The state one step later.
    pub(crate) fn step(&self, state: &[T], next: &mut [T]) {
        self.code.step(state, &self.constants, next);
    }
}

impl Engine {
    /// A kind of step in the form that its stages over V take at these ε; `None` where they are not
    /// all of one form.
    pub(crate) fn kind_at<V: Scalar>(
        &self,
        kind: StepKind,
        eps: impl IntoIterator<Item = V>,
    ) -> Option<StepKind> {
        let mut general = eps.into_iter().map(|eps| self.steps().are_general(&eps));
        let is_general = general.next()?;
        let rounds_increments = Steps::rounds::<V>(is_general);
        general.all(|other| other == is_general).then_some(StepKind { is_general, rounds_increments, ..kind })
    }

    /// What the kernel of a kind reads; `constants` are the parameters and ε.
    pub(crate) fn prepared<V: Scalar + Copy>(
        &self,
        kind: StepKind,
        constants: &[V],
        scratch: &mut Scratch<V>,
    ) -> Vec<V> {
        self.steps().form(kind.is_general).prepared(constants, &mut scratch.registers)
    }

    /// The stages of a composition as code, where there is some; `constants` are the parameters and
    /// ε.
    pub(crate) fn coded_stages<T: Scratches>(
        &self,
        constants: &[T],
        composition: Composition,
        fuses: bool,
    ) -> Option<CodedStages<T>> {
        let own = stage_constants(constants, composition);
        let kind =
            self.kind_at(StepKind::of::<T>(fuses), own.iter().map(|constants| super::split(constants).1))?;
        let code = self.codes.orbit(self, kind, own.len() > 1)?;
        let constants = with_scratch(T::single(), |scratch| {
            own.iter().map(|constants| self.prepared(kind, constants, scratch)).collect()
        });
        Some(CodedStages { code, kind, constants, carrying: Arc::default(), abreast: Arc::default() })
    }

    /// Replaces a state by the one so many steps later.
    pub(crate) fn advance_coded<T: Scratches>(&self, stages: &CodedStages<T>, state: &mut [T], steps: u64) {
        stages.code.advance(state, &stages.constants, steps);
    }

    /// The same, with what the state lacks carried along; `false` where there is no code.
    pub(crate) fn has_advanced_with_carry<T: Scratches>(
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
            code.advance(numbers, &stages.constants, steps);
            let (advanced, lacking) = numbers.split_at(state.len());
            state.copy_from_slice(advanced);
            carry.copy_from_slice(lacking);
        });
        true
    }
}
