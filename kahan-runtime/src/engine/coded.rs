//! The same by machine code, where there is some.

use std::sync::{Arc, OnceLock};

use kahan_core::{Composition, Scalar};

use crate::machine::{Form, OrbitCode, StepKind};

use super::abreast::AbreastOnce;
use super::scratch::{Scratch, Scratches, with_scratch};
use super::step::Steps;
use super::{Engine, Object, stage_constants};

/// The stages of a step as code, with the constants of those that differ, the middle one last.
#[derive(Clone, Debug)]
pub(crate) struct CodedStages<T> {
    code: Arc<OrbitCode<T>>,
    pub(super) kind: StepKind,
    pub(super) form: Form,
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
    /// The form of a step's stages at these ε, and whether it rounds increments; `None` where they
    /// are not all of one form.
    pub(crate) fn form<V: Scalar>(&self, eps: impl IntoIterator<Item = V>) -> Option<(Form, bool)> {
        let mut general = eps.into_iter().map(|eps| self.steps().are_general(&eps));
        let first = general.next()?;
        let form = if first { Form::AnyEps } else { Form::Own };
        general.all(|other| other == first).then_some((form, Steps::rounds::<V>(first)))
    }

    /// What the kernel of a form reads; `constants` are the parameters and ε.
    pub(crate) fn prepared<V: Scalar + Copy>(
        &self,
        form: Form,
        constants: &[V],
        scratch: &mut Scratch<V>,
    ) -> Vec<V> {
        self.steps().form(form == Form::AnyEps).prepared(constants, &mut scratch.registers)
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
        let (form, rounds_increments) = self.form(own.iter().map(|constants| super::split(constants).1))?;
        let kind = StepKind { rounds_increments, ..StepKind::of::<T>(fuses) };
        let code = self.codes.orbit(&self.derived, kind, form, own.len() > 1)?;
        let constants = with_scratch(T::single(), |scratch| {
            own.iter().map(|constants| self.prepared(form, constants, scratch)).collect()
        });
        Some(CodedStages { code, kind, form, constants, carrying: Arc::default(), abreast: Arc::default() })
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
            self.codes.orbit(&self.derived, kind, stages.form, stages.constants.len() > 1)
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

    /// Computes an object by code; `false` where there is none, or no room for all of it.
    pub(super) fn has_evaluated<T: Scratches>(
        &self,
        object: Object,
        constants: &[T],
        state: &[T],
        out: &mut [T],
    ) -> bool {
        let code = self.codes.function(&self.derived, object);
        code.is_some_and(|code| code.has_run(constants, state, out))
    }
}
