//! The palindrome of steps that a composition is.
//!
//! In: prepared steps. Out: each of them in its turn.
//! Those that differ lie in an array of fixed size, so nothing is allocated.

use core::array::from_fn;

use crate::map::Sealed;
use crate::{Method, Scalar};

use super::Composition;

/// The stages of a [`Composition`](crate::Composition).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Composed {}

impl Sealed for Composed {}

impl Method for Composed {
    type Stages<P: Clone> = Palindrome<P>;

    #[inline(always)]
    fn distinct<P: Clone>(stages: &Palindrome<P>) -> &[P] {
        &stages.steps[..stages.len]
    }

    #[inline(always)]
    fn map<P: Clone, Q: Clone>(stages: &Palindrome<P>, replace: impl Fn(&P) -> Q) -> Palindrome<Q> {
        let Palindrome { steps, len, composition } = stages;
        Palindrome { steps: steps.each_ref().map(replace), len: *len, composition: *composition }
    }

    #[inline(always)]
    fn at<T: Scalar, P: Clone>(stages: &Palindrome<P>, eps: &T, prepare: impl Fn(&T) -> P) -> Palindrome<P> {
        stages.composition.stages_of(eps, |eps| prepare(&eps))
    }

    #[inline(always)]
    fn are_alike<P: Clone>(a: &Palindrome<P>, b: &Palindrome<P>) -> bool {
        a.composition == b.composition
    }

    #[inline(always)]
    fn join<P: Clone, Q: Clone, const W: usize>(
        each: [&Palindrome<P>; W],
        join: impl Fn([&P; W]) -> Q,
    ) -> Palindrome<Q> {
        let Palindrome { len, composition, .. } = *each[0];
        Palindrome::new(composition, len, |k| join(each.map(|stages| &stages.steps[k])))
    }
}

/// Up to 17 steps that read the same from either end.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Palindrome<P> {
    /// The first `len` are run; the others repeat the middle one.
    steps: [P; MOST],
    len: usize,
    composition: Composition,
}

/// The most steps that differ.
const MOST: usize = 9;

impl<P> Palindrome<P> {
    /// The most steps that differ.
    pub const MOST: usize = MOST;

    /// The palindrome of 2·`len` − 1 steps whose k-th is `step(k)`, `len` from 1 to
    /// [`MOST`](Self::MOST).
    #[inline]
    pub(super) fn new(composition: Composition, len: usize, step: impl Fn(usize) -> P) -> Self {
        Self { steps: from_fn(|k| step(k.min(len - 1))), len, composition }
    }
}
