//! The workspace of each thread, reused from step to step.
//!
//! In: work as a closure. Out: its result. Vectors keep their capacity, so that steps do not
//! allocate after a thread's first one.

use core::cell::Cell;
use std::thread::LocalKey;

use kahan_core::__private::dense;

use super::couplings::Factors;

/// Vectors for steps over V, without meaning between two uses.
#[derive(Clone, Debug)]
pub struct Scratch<V> {
    pub(crate) registers: Vec<V>,
    pub(crate) workspace: Workspace<V>,
    pub(super) constants: Vec<V>,
    /// The registers of a step that do not depend on the state.
    pub(crate) given: Vec<V>,
    /// A copy of the caller's state.
    pub(super) state: Vec<V>,
    pub(super) stages: Vec<Vec<V>>,
    /// Copies of columns before steps that a guard may reject, followed by the guard.
    pub(super) guarded: Vec<V>,
    pub(super) dense: dense::Workspace<V>,
}

/// The increments of a step, and the matrix they come from.
#[derive(Clone, Debug)]
pub(crate) struct Workspace<V> {
    pub(super) outcome: Vec<V>,
    pub(super) matrix: Vec<V>,
    pub(super) slopes: Vec<V>,
    pub(super) factors: Factors<V>,
    pub(super) is_singular: bool,
}

impl<V> Default for Scratch<V> {
    fn default() -> Self {
        let [registers, outcome, matrix, slopes, constants, given, state, guarded] =
            [const { Vec::new() }; 8];
        Scratch {
            registers,
            workspace: Workspace { outcome, matrix, slopes, factors: Factors::default(), is_singular: false },
            constants,
            given,
            state,
            stages: Vec::new(),
            guarded,
            dense: dense::Workspace::default(),
        }
    }
}

/// The scratch of a thread; `None` while in use, and before first use.
pub(super) type ScratchCell<V> = Cell<Option<Box<Scratch<V>>>>;

pub(super) type ScratchKey<V> = &'static LocalKey<ScratchCell<V>>;

/// Runs `work` with this thread's scratch, or with a new one while the thread is ending.
pub(crate) fn with_scratch<V, R>(local: ScratchKey<V>, work: impl FnOnce(&mut Scratch<V>) -> R) -> R {
    let mut scratch = local.try_with(Cell::take).ok().flatten().unwrap_or_default();
    let result = work(&mut scratch);
    let _ = local.try_with(|kept| kept.set(Some(scratch)));
    result
}
