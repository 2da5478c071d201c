//! Steps of single states by machine code, or for dense fields by loops over the terms.
//!
//! In: a `StepKind` (the precision and the formula), with the parameters and ε of each stage. Out:
//! states after some steps. If the code rejects a step, the caller's interpreter repeats up to 64
//! steps.

use std::sync::{Arc, OnceLock};

use kahan_core::__private::LARGEST_FACTOR;
use kahan_core::num_traits::Zero;
use kahan_core::{Composition, Scalar};

use crate::follow::is_finite;
use crate::machine_code::{OrbitCode, StepKind};

use super::Engine;
use super::dense::advance_columns as advance_dense_columns;
use super::distinct_coefficients;
use super::floats::{MachineFloat, RuntimeFloat};
use super::group_code::GroupCodeCell;
use super::scratch::{Scratch, with_scratch};

pub(super) const GUARDED: u64 = 64;

/// The code of an orbit, compiled at first use; `Some(None)` after a failed compilation.
type OrbitCodeCell<W> = OnceLock<Option<Arc<OrbitCode<W>>>>;

/// The code of a palindromic composition, and the constants of its stages up to the middle one.
#[derive(Clone, Debug)]
pub(crate) struct CompiledStages<T: RuntimeFloat> {
    /// The code for plain steps, then the code for steps with compensated summation.
    codes: [Arc<OrbitCodeCell<T::Word>>; 2],
    pub(super) kind: StepKind,
    pub(super) constants: Arc<[Vec<T::Word>]>,
    pub(super) abreast: Arc<GroupCodeCell<T::Word>>,
}

impl<T: RuntimeFloat> CompiledStages<T> {
    fn new(code: OrbitCodeCell<T::Word>, kind: StepKind, constants: Arc<[Vec<T::Word>]>) -> Self {
        let codes = [Arc::new(code), Arc::default()];
        CompiledStages { codes, kind, constants, abreast: Arc::default() }
    }

    /// Returns the number of distinct stages; `None` unless it and `kind` are equal for `all`.
    pub(super) fn is_like_all(&self, all: &[&Self]) -> Option<usize> {
        let count = self.constants.len();
        let is_like = |own: &&Self| own.kind == self.kind && own.constants.len() == count;
        all.iter().all(is_like).then_some(count)
    }

    pub(crate) fn has_loops(&self) -> bool {
        self.compiled().is_some_and(OrbitCode::has_loops)
    }

    fn compiled(&self) -> Option<&OrbitCode<T::Word>> {
        self.codes[0].get()?.as_deref()
    }

    /// Advances columns by code that loops over a field's terms. `alone` repeats rejected steps.
    pub(crate) fn advance_columns(
        &self,
        columns: &mut [&mut [T::Word]],
        steps: u64,
        alone: impl FnMut(&mut [T::Word], u64),
    ) {
        advance_dense_columns(self.kind, columns, &self.constants, steps, alone);
    }

    /// Returns code for `steps` steps; `None` if compiling fails, or does not pay for so few steps.
    pub(crate) fn code(&self, engine: &Engine, carries: bool, steps: u64) -> Option<&OrbitCode<T::Word>> {
        let once = &self.codes[usize::from(carries)];
        let kind = StepKind { compensated: carries, ..self.kind };
        let may_wait = kind.fuses == StepKind::INTERPRETER_FUSES;
        if once.get().is_none() && may_wait && !engine.codes.is_worth_compiling(steps, engine) {
            return None;
        }
        let compile = || match engine.has_loops(kind) {
            true => Some(Arc::new(OrbitCode::loops(kind))),
            false => engine.codes.orbit(engine, kind, self.constants.len() > 1),
        };
        once.get_or_init(compile).as_deref()
    }

    /// Advances a state by `steps` steps of `code`; `interpret` repeats rejected steps.
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

    /// Makes one step at another ε, without allocation. Returns `false` and changes nothing if the
    /// code is not compiled, may reject a step, or is not valid at this ε.
    pub(crate) fn has_stepped_at(
        &self,
        engine: &Engine,
        (parameters, eps): (&[T], T),
        composition: Composition,
        state: &mut [T],
    ) -> bool {
        let code = self.compiled().filter(|code| !code.is_guarded() && !code.has_loops());
        let (Some(code), Some(words)) = (code, T::as_words(state)) else { return false };
        let stages = || distinct_coefficients(&composition).map(|gamma| self.kind.stage_eps(gamma, eps));
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

    fn has_advanced(&self, code: &OrbitCode<T::Word>, [state, carry]: [&mut [T]; 2], steps: u64) -> bool {
        if carry.is_empty()
            && !code.is_guarded()
            && let Some(words) = T::as_words(state)
        {
            code.advance(words, &self.constants, steps);
            return true;
        }
        // The state is moved out of the scratch memory, because the loops for dense fields borrow
        // this memory themselves.
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

impl<T: MachineFloat> CompiledStages<T> {
    pub(crate) fn has_stepped(&self, state: &[T], next: &mut [T]) -> bool {
        let Some(code) = self.compiled().filter(|code| !code.is_guarded()) else { return false };
        code.step(state, &self.constants, next);
        true
    }
}

impl Engine {
    fn looped_stages<T: RuntimeFloat>(&self, kind: StepKind, own: &[Vec<T>]) -> Option<CompiledStages<T>> {
        let packed = |own: &Vec<T>| -> Option<Vec<T::Word>> {
            self.packed(&own.iter().flat_map(|number| number.words()).collect::<Vec<_>>())
        };
        let constants = own.iter().map(packed).collect::<Option<_>>()?;
        let loops = OnceLock::from(Some(Arc::new(OrbitCode::loops(kind))));
        Some(CompiledStages::new(loops, kind, constants))
    }

    /// Returns the stages of a composition as code; `None` if there is no code, or if the stages
    /// need different formulas.
    pub(crate) fn coded_stages<T: RuntimeFloat>(
        &self,
        kind: StepKind,
        own: &[Vec<T>],
    ) -> Option<CompiledStages<T>> {
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
            None => own.iter().flat_map(|number| number.words()).collect(),
        };
        let constants = own.iter().map(&mut prepared).collect();
        Some(CompiledStages::new(code, kind, constants))
    }
}
