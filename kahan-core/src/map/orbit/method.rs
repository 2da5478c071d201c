//! What a step of an orbit is made of: one step of the map here, several of them in a composition.
//!
//! In: prepared steps. Out: each of them in its turn.

use crate::Scalar;

use super::sealed::Sealed;

/// What a step of an [`Orbit`](crate::Orbit) is made of: [`Single`] or
/// [`Composed`](crate::Composed).
pub trait Method: Sealed {
    /// The prepared steps p₁, …, pₘ, run as p₁, …, pₘ₋₁, pₘ, pₘ₋₁, …, p₁.
    #[doc(hidden)]
    type Stages<P: Clone>: Clone;

    /// p₁, …, pₘ, at least one.
    #[doc(hidden)]
    fn distinct<P: Clone>(stages: &Self::Stages<P>) -> &[P];

    /// Each step replaced.
    #[doc(hidden)]
    fn map<P: Clone, Q: Clone>(stages: &Self::Stages<P>, replace: impl Fn(&P) -> Q) -> Self::Stages<Q>;

    /// The same steps at another ε, each prepared from its own.
    #[doc(hidden)]
    fn at<T: Scalar, P: Clone>(
        stages: &Self::Stages<P>,
        eps: &T,
        prepare: impl Fn(&T) -> P,
    ) -> Self::Stages<P>;

    /// Whether they are of one composition.
    #[doc(hidden)]
    fn are_alike<P: Clone>(a: &Self::Stages<P>, b: &Self::Stages<P>) -> bool;

    /// One step of the steps that stand at the same place, for each place.
    #[doc(hidden)]
    fn join<P: Clone, Q: Clone, const W: usize>(
        each: [&Self::Stages<P>; W],
        join: impl Fn([&P; W]) -> Q,
    ) -> Self::Stages<Q>;

    /// Every stage in order.
    #[doc(hidden)]
    #[inline(always)]
    fn in_order<'a, P: Clone + 'a>(stages: &'a Self::Stages<P>) -> impl Iterator<Item = &'a P> {
        let distinct = Self::distinct(stages);
        let last = 2 * distinct.len() - 2;
        (0..=last).map(move |k| &distinct[k.min(last - k)])
    }

    /// Runs every stage in order, until one has no value.
    #[doc(hidden)]
    #[inline(always)]
    fn run<P: Clone>(stages: &Self::Stages<P>, mut run: impl FnMut(&P) -> Option<()>) -> Option<()> {
        for step in Self::in_order(stages) {
            run(step)?;
        }
        Some(())
    }
}

/// One step of the map, of order 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Single {}

impl Sealed for Single {}

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

    #[inline(always)]
    fn at<T: Scalar, P: Clone>(_stages: &P, eps: &T, prepare: impl Fn(&T) -> P) -> P {
        prepare(eps)
    }

    #[inline(always)]
    fn are_alike<P: Clone>(_a: &P, _b: &P) -> bool {
        true
    }

    #[inline(always)]
    fn join<P: Clone, Q: Clone, const W: usize>(each: [&P; W], join: impl Fn([&P; W]) -> Q) -> Q {
        join(each)
    }
}
