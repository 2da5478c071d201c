//! What a step is made of, for those who run its parts in a way of their own: in lanes, or with
//! tangent vectors.
//!
//! In: a map at its ε, or a composition of one. Out: a thing for each of its stages, in their
//! order.

use nalgebra::SVector;

use crate::{KahanAt, KahanMap, Scalar, Step};

use super::Composed;
use super::composed::Palindrome;

/// A map at its ε each of whose steps is one or several of Kahan's.
pub trait Staged<T: Scalar, const N: usize>: Step<Scalar = T, State = SVector<T, N>> + Clone {
    /// The map of all stages.
    type Map: KahanMap<T, N>;
    /// A thing for each stage.
    type Stages<P>: InOrder<P>;

    /// What is made of each stage.
    fn stages<'a, P>(&'a self, of: impl Fn(&'a KahanAt<Self::Map, T, N>) -> P) -> Self::Stages<P>;

    /// What is made of the stages that stand at the same place in each of several maps; `None`
    /// where these have different compositions.
    #[cfg(feature = "std")]
    fn joined<P, const W: usize>(
        each: [&Self; W],
        of: impl Fn([&KahanAt<Self::Map, T, N>; W]) -> P,
    ) -> Option<Self::Stages<P>>;
}

/// Things that follow on each other.
pub trait InOrder<P> {
    /// Each of them in its turn.
    fn in_order<'a>(&'a self) -> impl Iterator<Item = &'a P>
    where
        P: 'a;
}

impl<P> InOrder<P> for [P; 1] {
    #[inline(always)]
    fn in_order<'a>(&'a self) -> impl Iterator<Item = &'a P>
    where
        P: 'a,
    {
        self.iter()
    }
}

impl<P> InOrder<P> for Palindrome<P> {
    #[inline(always)]
    fn in_order<'a>(&'a self) -> impl Iterator<Item = &'a P>
    where
        P: 'a,
    {
        self.iter()
    }
}

impl<M, T, const N: usize> Staged<T, N> for KahanAt<M, T, N>
where
    M: KahanMap<T, N>,
    T: Scalar,
{
    type Map = M;
    type Stages<P> = [P; 1];

    #[inline(always)]
    fn stages<'a, P>(&'a self, of: impl Fn(&'a Self) -> P) -> [P; 1] {
        [of(self)]
    }

    #[cfg(feature = "std")]
    #[inline(always)]
    fn joined<P, const W: usize>(each: [&Self; W], of: impl Fn([&Self; W]) -> P) -> Option<[P; 1]> {
        Some([of(each)])
    }
}

impl<M, T, const N: usize> Staged<T, N> for Composed<KahanAt<M, T, N>>
where
    M: KahanMap<T, N>,
    T: Scalar,
{
    type Map = M;
    type Stages<P> = Palindrome<P>;

    #[inline(always)]
    fn stages<'a, P>(&'a self, of: impl Fn(&'a KahanAt<M, T, N>) -> P) -> Palindrome<P> {
        self.stages.map(of)
    }

    #[cfg(feature = "std")]
    #[inline(always)]
    fn joined<P, const W: usize>(
        each: [&Self; W],
        of: impl Fn([&KahanAt<M, T, N>; W]) -> P,
    ) -> Option<Palindrome<P>> {
        let first = each.first()?;
        let are_alike = each.iter().all(|map| map.composition == first.composition);
        are_alike.then(|| Palindrome::new(first.stages.len, |k| of(each.map(|map| &map.stages.steps[k]))))
    }
}
