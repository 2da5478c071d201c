//! The same by machine code, where there is some.

use std::sync::{Arc, OnceLock};

use kahan_core::__private::LARGEST_FACTOR;
use kahan_core::num_traits::Zero;
use kahan_core::{Composition, Scalar};

use crate::follow::is_finite;
use crate::machine::{OrbitCode, StepKind};

use super::Engine;
use super::abreast::AbreastOnce;
use super::dense::advance_columns as advance_dense_columns;
use super::distinct;
use super::floats::{MachineFloat, RuntimeFloat};
use super::scratch::{Scratch, with_scratch};

/// Steps between two looks at the guard of code.
pub(super) const GUARDED: u64 = 64;

/// Machine code, once it was compiled; `None` in it if it cannot be compiled.
type CodeOnce<W> = OnceLock<Option<Arc<OrbitCode<W>>>>;

/// The stages of a step as code, with the constants of those that differ, the middle one last.
#[derive(Clone, Debug)]
pub(crate) struct CodedStages<T: RuntimeFloat> {
    /// The code of states, and that of states that carry what they lack.
    codes: [Arc<CodeOnce<T::Word>>; 2],
    pub(super) kind: StepKind,
    pub(super) constants: Arc<[Vec<T::Word>]>,
    pub(super) abreast: Arc<AbreastOnce<T::Word>>,
}

impl<T: RuntimeFloat> CodedStages<T> {
    fn new(code: CodeOnce<T::Word>, kind: StepKind, constants: Arc<[Vec<T::Word>]>) -> Self {
        let codes = [Arc::new(code), Arc::default()];
        CodedStages { codes, kind, constants, abreast: Arc::default() }
    }

    /// The number of stages that differ, where all of these have the kind of this and as many.
    pub(super) fn is_like_all(&self, all: &[&Self]) -> Option<usize> {
        let count = self.constants.len();
        let is_like = |own: &&Self| own.kind == self.kind && own.constants.len() == count;
        all.iter().all(is_like).then_some(count)
    }

    /// Whether it is the loops of a dense field, which step one state at a time.
    pub(crate) fn has_loops(&self) -> bool {
        self.compiled().is_some_and(OrbitCode::has_loops)
    }

    /// The code of states, if it was compiled.
    fn compiled(&self) -> Option<&OrbitCode<T::Word>> {
        self.codes[0].get()?.as_deref()
    }

    /// Advances columns by the loops of a dense field; `alone` makes the steps that they refuse.
    pub(crate) fn advance_columns(
        &self,
        columns: &mut [&mut [T::Word]],
        steps: u64,
        alone: impl FnMut(&mut [T::Word], u64),
    ) {
        advance_dense_columns(self.kind, columns, &self.constants, steps, alone);
    }

    /// The code for `steps` more steps; with `carries` the one that carries what a state lacks.
    /// `None` where it cannot be compiled, or compiling it does not pay yet.
    pub(crate) fn code(&self, engine: &Engine, carries: bool, steps: u64) -> Option<&OrbitCode<T::Word>> {
        let once = &self.codes[usize::from(carries)];
        if once.get().is_none() && !engine.codes.pay_after(steps, engine) {
            return None;
        }
        let kind = StepKind { compensated: carries, ..self.kind };
        let compile = || match engine.has_loops(kind) {
            true => Some(Arc::new(OrbitCode::loops(kind))),
            false => engine.codes.orbit(engine, kind, self.constants.len() > 1),
        };
        once.get_or_init(compile).as_deref()
    }

    /// Advances a state by `steps` steps of `code`. A `carry` that is not empty holds the rounding
    /// errors of the state, and is advanced with it. `interpret` takes the steps that the guard of
    /// `code` refuses.
    pub(crate) fn advance(
        &self,
        code: &OrbitCode<T::Word>,
        [state, carry]: [&mut [T]; 2],
        steps: u64,
        interpret: impl Fn([&mut [T]; 2], u64),
    ) {
        let at_once = if code.is_guarded() { GUARDED } else { steps };
        let mut left = steps;
        while left > 0 {
            let now = left.min(at_once);
            if !self.has_advanced(code, [&mut *state, &mut *carry], now) {
                interpret([&mut *state, &mut *carry], now);
            }
            left -= now;
        }
    }

    /// Replaces a state by the one a step later at another ε, without an allocation. Returns
    /// `false` and changes nothing where the code is not compiled, refuses steps, or is that of
    /// another form of the step than the one at this ε.
    pub(crate) fn has_stepped_at(
        &self,
        engine: &Engine,
        (parameters, eps): (&[T], T),
        composition: Composition,
        state: &mut [T],
    ) -> bool {
        let code = self.compiled().filter(|code| !code.is_guarded() && !code.has_loops());
        let (Some(code), Some(words)) = (code, T::as_words(state)) else { return false };
        let stages = || distinct(&composition).map(|gamma| self.kind.stage_eps(gamma, eps));
        let step = engine.steps().form(self.kind.is_general);
        if engine.kind_at(self.kind, stages()) != Some(self.kind) || !step.has_lanes() {
            return false;
        }
        with_scratch(T::Word::single(), |scratch| {
            let Scratch { registers, constants, stages: prepared, .. } = scratch;
            prepared.resize(stages().len(), Vec::new());
            for (prepared, eps) in prepared.iter_mut().zip(stages()) {
                constants.clear();
                constants.extend(parameters.iter().copied().chain([eps]).flat_map(T::words));
                prepared.clear();
                match step.prepared(constants, registers) {
                    Some(own) => prepared.extend(own.iter()),
                    None => prepared.extend_from_slice(constants),
                }
            }
            code.advance(words, prepared, 1);
        });
        true
    }

    /// Advances a state and its `carry` by `code`. Returns `false` and changes nothing where the
    /// guard of `code` refuses the steps.
    fn has_advanced(&self, code: &OrbitCode<T::Word>, [state, carry]: [&mut [T]; 2], steps: u64) -> bool {
        if carry.is_empty()
            && !code.is_guarded()
            && let Some(words) = T::as_words(state)
        {
            code.advance(words, &self.constants, steps);
            return true;
        }
        // The loops of dense fields work in the thread's scratch, too.
        let mut numbers = with_scratch(T::Word::single(), |scratch| std::mem::take(&mut scratch.state));
        numbers.clear();
        numbers.extend(state.iter().chain(&*carry).flat_map(|number| number.words()));
        let own = numbers.len();
        if code.is_guarded() {
            numbers.push(T::Word::zero());
        }
        code.advance(&mut numbers, &self.constants, steps);
        let (words, guard) = numbers.split_at(own);
        let is_kept = |guard: &T::Word| guard.approximate() <= LARGEST_FACTOR as f64;
        let is_told = guard.iter().all(|guard| is_kept(guard) && is_finite(words));
        if is_told {
            let words = words.chunks_exact(own / (state.len() + carry.len()));
            let advanced = state.iter_mut().chain(carry).zip(words);
            advanced.for_each(|(number, words)| *number = T::from_words(words));
        }
        with_scratch(T::Word::single(), |scratch| scratch.state = numbers);
        is_told
    }
}

impl<T: MachineFloat> CodedStages<T> {
    /// Writes the state one step later; `false` where there is no code, or a guard to look at.
    pub(crate) fn has_stepped(&self, state: &[T], next: &mut [T]) -> bool {
        let Some(code) = self.compiled().filter(|code| !code.is_guarded()) else { return false };
        code.step(state, &self.constants, next);
        true
    }
}

impl Engine {
    /// The stages of a composition by the loops of a dense field.
    fn looped_stages<T: RuntimeFloat>(&self, kind: StepKind, own: &[Vec<T>]) -> Option<CodedStages<T>> {
        let packed = |own: &Vec<T>| -> Option<Vec<T::Word>> {
            self.packed(&own.iter().flat_map(|number| number.words()).collect::<Vec<_>>())
        };
        let constants = own.iter().map(packed).collect::<Option<_>>()?;
        let loops = OnceLock::from(Some(Arc::new(OrbitCode::loops(kind))));
        Some(CodedStages::new(loops, kind, constants))
    }

    /// The stages of a composition as code, where there is some and they are all of one form; `own`
    /// are the parameters and ε of those that differ.
    pub(crate) fn coded_stages<T: RuntimeFloat>(
        &self,
        kind: StepKind,
        own: &[Vec<T>],
    ) -> Option<CodedStages<T>> {
        if self.has_loops(kind) {
            return self.looped_stages(kind, own);
        }
        let kind = self.kind_at(kind, own.iter().map(|constants| super::split(constants).1))?;
        let (step, mut registers) = (self.steps().form(kind.is_general), Vec::new());
        let code = match step.has_lanes() {
            true => Some(self.codes.orbit(self, kind, own.len() > 1)?).into(),
            false if kind.has_eliminating_code(self) => OnceLock::new(),
            false => return None,
        };
        let mut prepared = |own: &Vec<T>| match step.prepared(own, &mut registers) {
            Some(prepared) => prepared.iter().flat_map(T::words).collect(),
            // Elimination takes the parameters and ε.
            None => own.iter().flat_map(|number| number.words()).collect(),
        };
        let constants = own.iter().map(&mut prepared).collect();
        Some(CodedStages::new(code, kind, constants))
    }
}
