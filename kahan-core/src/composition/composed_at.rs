//! A composition at a fixed ε, and what it has in common with the map at a fixed ε.
//!
//! In: a map, a composition and ε, once. Out: steps that take a state only, orbits, and the stages
//! for ensembles.

use core::fmt;

use nalgebra::SVector;

use crate::step::error::pole;
use crate::{FloatScalar, KahanAt, KahanMap, Method, Orbit, PreparedStep, Scalar, Single};

use super::Composition;
use super::stages::{Composed, Palindrome};

/// A [`Composition`] of the map M at one ε, half the time step; made by [`KahanAt::composed`].
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_core::{Composition, Ensemble};
///
/// kahan! {
///     /// Predator and prey.
///     pub struct LotkaVolterra;
///     xdot = x*(1 - y);
///     ydot = y*(x - 1);
/// }
///
/// let map = LotkaVolterra.at(0.05).composed(Composition::KAHAN_LI_8);
/// let mut ponds = Ensemble::new(vec![vector![1.5, 1.0], vector![0.7, 0.7]]);
/// ponds.advance(&map, 100);
///
/// let alone = map.orbit(vector![1.5, 1.0]).nth(100).unwrap();
/// assert!((ponds.point(0).unwrap() - alone).norm() < 1e-12);
/// ```
#[derive(Clone)]
pub struct ComposedAt<M, T, const N: usize>
where
    M: KahanMap<T, N>,
    T: Scalar,
{
    map: M,
    eps: T,
    composition: Composition,
    stages: Palindrome<M::Prepared>,
}

impl<M, T, const N: usize> KahanAt<M, T, N>
where
    M: KahanMap<T, N>,
    T: FloatScalar,
{
    /// The composition of this map at its ε: a step of it takes the same time 2ε.
    pub fn composed(&self, composition: Composition) -> ComposedAt<M, T, N> {
        let (map, eps) = (self.map().clone(), *self.eps());
        let stages = composition.stages_of(&map, eps);
        ComposedAt { map, eps, composition, stages }
    }
}

impl<M, T, const N: usize> ComposedAt<M, T, N>
where
    M: KahanMap<T, N>,
    T: FloatScalar,
{
    /// The map that is composed.
    pub fn map(&self) -> &M {
        &self.map
    }

    /// ε, half the time step of the composition.
    pub fn eps(&self) -> &T {
        &self.eps
    }

    /// The composition.
    pub fn composition(&self) -> Composition {
        self.composition
    }

    /// The state one time step of 2ε later, by all stages in order; not finite where a stage meets
    /// a pole.
    #[inline]
    pub fn step(&self, x: &SVector<T, N>) -> SVector<T, N> {
        let mut next = *x;
        let stages = Composed::run(&self.stages, |step| {
            next = step.next(&next)?;
            Some(())
        });
        match stages {
            Some(()) => next,
            None => pole(&self.eps),
        }
    }

    /// The orbit that begins with `x`; it owns a copy of the stages.
    #[inline]
    pub fn orbit(&self, x: SVector<T, N>) -> Orbit<M, T, N, Composed> {
        Orbit::begin(self.map.clone(), self.eps, self.stages.clone(), x)
    }
}

impl<M, T, const N: usize> fmt::Debug for ComposedAt<M, T, N>
where
    M: KahanMap<T, N> + fmt::Debug,
    T: Scalar,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ComposedAt")
            .field("map", &self.map)
            .field("eps", &self.eps)
            .field("composition", &self.composition)
            .finish_non_exhaustive()
    }
}

/// A map at a fixed ε, as ensembles advance by it: [`KahanAt`] or [`ComposedAt`].
pub trait PreparedMap<T: Scalar, const N: usize>: sealed::Sealed {
    /// One prepared step of the map.
    type Step: PreparedStep<T, N>;

    /// What a time step is made of.
    type Method: Method<Stages<Self::Step>: Sync>;

    /// The prepared steps of one time step.
    #[doc(hidden)]
    fn stages(&self) -> &<Self::Method as Method>::Stages<Self::Step>;

    /// ε, half the time step.
    #[doc(hidden)]
    fn half_step(&self) -> &T;
}

mod sealed {
    use super::ComposedAt;
    use crate::{KahanAt, KahanMap, Scalar};

    pub trait Sealed {}

    impl<M: KahanMap<T, N>, T: Scalar, const N: usize> Sealed for KahanAt<M, T, N> {}
    impl<M: KahanMap<T, N>, T: Scalar, const N: usize> Sealed for ComposedAt<M, T, N> {}
}

impl<M, T, const N: usize> PreparedMap<T, N> for KahanAt<M, T, N>
where
    M: KahanMap<T, N, Prepared: Sync>,
    T: Scalar,
{
    type Step = M::Prepared;

    type Method = Single;

    fn stages(&self) -> &M::Prepared {
        self.prepared()
    }

    fn half_step(&self) -> &T {
        self.eps()
    }
}

impl<M, T, const N: usize> PreparedMap<T, N> for ComposedAt<M, T, N>
where
    M: KahanMap<T, N, Prepared: Sync>,
    T: Scalar,
{
    type Step = M::Prepared;

    type Method = Composed;

    fn stages(&self) -> &Palindrome<M::Prepared> {
        &self.stages
    }

    fn half_step(&self) -> &T {
        &self.eps
    }
}
