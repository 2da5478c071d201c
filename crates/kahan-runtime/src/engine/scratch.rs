//! Workspace to compute in: each thread has its own, keeps it, and waits for nobody.
//!
//! In: work. Out: the same work with vectors that have been grown by the work before, so that steps
//! allocate nothing once a thread has made the first.

use core::cell::Cell;
use std::thread::LocalKey;

use kahan_core::__private::dense;

use super::couplings::Factors;

/// The vectors that steps over V are computed in; what they hold between two calls means nothing.
#[derive(Clone, Debug)]
pub struct Scratch<V> {
    /// The registers of lines.
    pub(crate) registers: Vec<V>,
    pub(crate) workspace: Workspace<V>,
    /// The parameters and ε.
    pub(super) constants: Vec<V>,
    /// What the line of a step is given.
    pub(crate) given: Vec<V>,
    /// The state, where it is not the caller's.
    pub(super) state: Vec<V>,
    /// The constants of the stages of one step at another ε.
    pub(super) stages: Vec<Vec<V>>,
    /// Columns before steps that a guard may refuse, and the guard.
    pub(super) guarded: Vec<V>,
    /// For the loops of dense fields.
    pub(super) dense: dense::Workspace<V>,
}

/// Where a step leaves what it is about to add.
#[derive(Clone, Debug)]
pub(crate) struct Workspace<V> {
    /// Numerators, then their reciprocals.
    pub(super) outcome: Vec<V>,
    /// A(x,ε), row by row.
    pub(super) matrix: Vec<V>,
    /// The entries of f′ in many variables, and the factors of A.
    pub(super) slopes: Vec<V>,
    pub(super) factors: Factors<V>,
    /// Whether it has turned out to be singular.
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

/// The scratch of a thread; `None` while it is lent, and before its first use.
pub(super) type Kept<V> = Cell<Option<Box<Scratch<V>>>>;

/// How a thread finds its scratch.
pub(super) type Local<V> = &'static LocalKey<Kept<V>>;

/// Does the work with the scratch of this thread; a thread that is ending gets a new one.
pub(crate) fn with_scratch<V, R>(local: Local<V>, work: impl FnOnce(&mut Scratch<V>) -> R) -> R {
    let mut scratch = local.try_with(Cell::take).ok().flatten().unwrap_or_default();
    let result = work(&mut scratch);
    let _ = local.try_with(|kept| kept.set(Some(scratch)));
    result
}
