//! The stages of a step, for code that runs stages in SIMD lanes or with tangent vectors.

use nalgebra::SVector;

use crate::{KahanAt, KahanMap, Scalar, Step};

use super::Composed;
use super::composed::Palindrome;

/// A prepared map whose step consists of one or more Kahan steps.
pub(crate) trait Staged<T: Scalar, const N: usize>:
    Step<Scalar = T, State = SVector<T, N>> + Clone
{
    type Map: KahanMap<T, N>;
    type Stages<P>;

    fn stages<'a, P>(&'a self, of: impl Fn(&'a KahanAt<Self::Map, T, N>) -> P) -> Self::Stages<P>;

    fn in_order<'a, P: 'a>(stages: &'a Self::Stages<P>) -> impl Iterator<Item = &'a P>;

    /// For every k, calls the function `of` with the k-th stages of all maps in `each`. Returns
    /// `None` if the compositions of the maps differ.
    #[cfg(feature = "std")]
    fn zip_stages<P, const W: usize>(
        each: [&Self; W],
        of: impl Fn([&KahanAt<Self::Map, T, N>; W]) -> P,
    ) -> Option<Self::Stages<P>>;
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

    #[inline(always)]
    fn in_order<'a, P: 'a>(stages: &'a [P; 1]) -> impl Iterator<Item = &'a P> {
        stages.iter()
    }

    #[cfg(feature = "std")]
    #[inline(always)]
    fn zip_stages<P, const W: usize>(each: [&Self; W], of: impl Fn([&Self; W]) -> P) -> Option<[P; 1]> {
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

    #[inline(always)]
    fn in_order<'a, P: 'a>(stages: &'a Palindrome<P>) -> impl Iterator<Item = &'a P> {
        stages.in_order()
    }

    #[cfg(feature = "std")]
    #[inline(always)]
    fn zip_stages<P, const W: usize>(
        each: [&Self; W],
        of: impl Fn([&KahanAt<M, T, N>; W]) -> P,
    ) -> Option<Palindrome<P>> {
        let first = each.first()?;
        let are_alike = each.iter().all(|map| map.composition == first.composition);
        are_alike.then(|| Palindrome::new(first.stages.len, |k| of(each.map(|map| &map.stages.steps[k]))))
    }
}
