//! Scratch memory of each thread.
//!
//! Vectors keep their capacity, so that later steps of a map on the same thread seldom allocate.
//! Sparse elimination with row exchanges allocates each time.

use core::cell::Cell;
use std::thread::LocalKey;

use kahan_core::__private::dense;

use super::couplings::Factors;

/// Vectors for steps over V; their contents have no meaning between two uses.
#[derive(Clone, Debug)]
pub struct Scratch<V> {
    pub(crate) registers: Vec<V>,
    pub(crate) workspace: Workspace<V>,
    pub(super) constants: Vec<V>,
    /// The registers of a step that depend only on parameters and ε, not on the state.
    pub(crate) given: Vec<V>,
    pub(super) state: Vec<V>,
    pub(super) stages: Vec<Vec<V>>,
    /// Copies of states, made before steps that may be rejected.
    pub(super) guarded: Vec<V>,
    pub(super) dense: dense::Workspace<V>,
}

/// The increments of a step, and the matrix from which the increments were computed.
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

/// The scratch memory of a thread; `None` before the first use, and while it is taken out.
pub(super) type ScratchCell<V> = Cell<Option<Box<Scratch<V>>>>;

pub(super) type ScratchKey<V> = &'static LocalKey<ScratchCell<V>>;

/// Runs `work` with this thread's scratch memory, or with new memory while the thread is ending.
pub(crate) fn with_scratch<V, R>(local: ScratchKey<V>, work: impl FnOnce(&mut Scratch<V>) -> R) -> R {
    let mut scratch = local.try_with(Cell::take).ok().flatten().unwrap_or_default();
    let result = work(&mut scratch);
    let _ = local.try_with(|kept| kept.set(Some(scratch)));
    result
}
