//! What a step is made of: one step of the map, or a palindrome of them.
//!
//! In: prepared steps. Out: each of them in its turn.
//! The different steps of a palindrome lie in an array of fixed size, so nothing is allocated.

use core::array::from_fn;

/// What a step of an [`Orbit`](crate::Orbit) is made of: [`Single`] or [`Composed`].
pub trait Method: sealed::Sealed {
    /// The prepared steps p₁, …, pₘ, run as p₁, …, pₘ₋₁, pₘ, pₘ₋₁, …, p₁.
    #[doc(hidden)]
    type Stages<P: Clone>: Clone;

    /// p₁, …, pₘ, at least one.
    #[doc(hidden)]
    fn distinct<P: Clone>(stages: &Self::Stages<P>) -> &[P];

    /// Each step replaced.
    #[doc(hidden)]
    fn map<P: Clone, Q: Clone>(stages: &Self::Stages<P>, replace: impl Fn(&P) -> Q) -> Self::Stages<Q>;

    /// Runs every stage in order, until one has no value.
    #[doc(hidden)]
    #[inline(always)]
    fn run<P: Clone>(stages: &Self::Stages<P>, mut run: impl FnMut(&P) -> Option<()>) -> Option<()> {
        let distinct = Self::distinct(stages);
        let last = 2 * distinct.len() - 2;
        for k in 0..=last {
            run(&distinct[k.min(last - k)])?;
        }
        Some(())
    }
}

/// One step of the map, of order 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Single {}

/// The stages of a [`Composition`](crate::Composition).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Composed {}

mod sealed {
    pub trait Sealed {}

    impl Sealed for super::Single {}
    impl Sealed for super::Composed {}
}

impl Method for Single {
    type Stages<P: Clone> = P;

    #[inline(always)]
    fn distinct<P: Clone>(stages: &P) -> &[P] {
        core::slice::from_ref(stages)
    }

    #[inline(always)]
    fn map<P: Clone, Q: Clone>(stages: &P, replace: impl Fn(&P) -> Q) -> Q {
        replace(stages)
    }
}

impl Method for Composed {
    type Stages<P: Clone> = Palindrome<P>;

    #[inline(always)]
    fn distinct<P: Clone>(stages: &Palindrome<P>) -> &[P] {
        &stages.steps[..stages.len]
    }

    #[inline(always)]
    fn map<P: Clone, Q: Clone>(stages: &Palindrome<P>, replace: impl Fn(&P) -> Q) -> Palindrome<Q> {
        Palindrome { steps: stages.steps.each_ref().map(replace), len: stages.len }
    }
}

/// Up to 17 steps that read the same from either end.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Palindrome<P> {
    /// The first `len` are run; the others repeat the middle one.
    steps: [P; MOST],
    len: usize,
}

/// The most steps that differ.
const MOST: usize = 9;

impl<P> Palindrome<P> {
    /// The most steps that differ.
    pub const MOST: usize = MOST;

    /// The palindrome of 2·`len` − 1 steps whose k-th is `step(k)`, `len` from 1 to [`MOST`](Self::MOST).
    #[inline]
    pub(super) fn new(len: usize, step: impl Fn(usize) -> P) -> Self {
        Self { steps: from_fn(|k| step(k.min(len - 1))), len }
    }
}
