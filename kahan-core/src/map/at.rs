//! A map, or a composition of it, at a fixed ε.
//!
//! In: a map and ε, once. Out: steps that take a state only. It owns map, ε and what depends on
//! nothing else, borrows nothing, allocates nothing and holds no `dyn`.

use core::fmt;

use nalgebra::{SMatrix, SVector};

use crate::step::error::pole;
use crate::{PreparedStep, Scalar, SingularStep};

use super::{KahanMap, Method, Orbit, Pivot, Single};

/// The Kahan map M at one ε, half the time step; made by [`KahanMap::at`]. A step of it is one of
/// the map, or, of a [`composed`](Self::composed) one, several.
///
/// What depends on ε and the parameters alone is computed once, when this is made; quotients are
/// left to the step, where a zero below shows as a pole. Its type can be written out, so a struct
/// of yours can hold it:
///
/// ```
/// use kahan_core::KahanAt;
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// Predator and prey, at any rate of change.
///     pub struct Prey { rate }
///     xdot = rate*x*(1 - y);
///     ydot = rate*y*(x - 1);
/// }
///
/// struct Pond {
///     map: KahanAt<Prey<f64>, f64, 2>,
///     state: SVector<f64, 2>,
/// }
///
/// let mut pond = Pond { map: Prey { rate: 0.5 }.at(0.125), state: vector![1.5, 1.0] };
/// for _ in 0..100 {
///     pond.state = pond.map.step(&pond.state);
/// }
/// assert!(pond.state.iter().all(|entry| *entry > 0.0));
/// ```
#[derive(Clone, Copy)]
pub struct KahanAt<M, T, const N: usize, K = Single>
where
    M: KahanMap<T, N>,
    T: Scalar,
    K: Method,
{
    pub(crate) map: M,
    pub(crate) eps: T,
    pub(crate) stages: K::Stages<M::Prepared>,
}

impl<M, T, K, const N: usize> KahanAt<M, T, N, K>
where
    M: KahanMap<T, N>,
    T: Scalar,
    K: Method,
{
    /// The map.
    pub fn map(&self) -> &M {
        &self.map
    }

    /// ε, half the time step.
    pub fn eps(&self) -> &T {
        &self.eps
    }

    /// The orbit that begins with `x`; it owns a copy of the prepared step.
    #[inline]
    pub fn orbit(&self, x: SVector<T, N>) -> Orbit<M, T, N, K> {
        Orbit::begin(self.map.clone(), self.eps.clone(), self.stages.clone(), x)
    }
}

impl<M, T, const N: usize> KahanAt<M, T, N>
where
    M: KahanMap<T, N>,
    T: Scalar,
{
    #[inline]
    pub(crate) fn new(map: M, eps: T) -> Self {
        let stages = map.prepare(&eps);
        Self { map, eps, stages }
    }

    /// The prepared step, for code that finishes steps in its own way (in lanes, compensated).
    pub fn prepared(&self) -> &M::Prepared {
        &self.stages
    }

    /// x̃, as [`KahanMap::step`] and bit for bit the same.
    ///
    /// # Panics
    /// At a pole, for exact scalars.
    #[inline]
    pub fn step(&self, x: &SVector<T, N>) -> SVector<T, N> {
        match self.stages.next(x) {
            Some(next) => next,
            None => pole(&self.eps),
        }
    }

    /// x̃ with a promise or why there is none, as [`KahanMap::try_step`].
    ///
    /// # Errors
    /// [`SingularStep`] at a pole, at a point that is not finite, and beyond the scalar's range.
    #[inline(always)]
    pub fn try_step(&self, x: &SVector<T, N>) -> Result<SVector<T, N>, SingularStep>
    where
        T: Pivot,
    {
        self.map.try_prepared(&self.stages, x, &self.eps)
    }

    /// ∂x̃/∂x, as [`KahanMap::jacobian`].
    ///
    /// # Panics
    /// At a pole, for exact scalars.
    pub fn jacobian(&self, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        self.map.jacobian(x, self.eps.clone())
    }
}

/// Two are equal where map and ε are; the rest follows from them.
impl<M, T, const N: usize> PartialEq for KahanAt<M, T, N>
where
    M: KahanMap<T, N> + PartialEq,
    T: Scalar,
{
    fn eq(&self, other: &Self) -> bool {
        self.map == other.map && self.eps == other.eps
    }
}

impl<M, T, K, const N: usize> fmt::Debug for KahanAt<M, T, N, K>
where
    M: KahanMap<T, N> + fmt::Debug,
    T: Scalar,
    K: Method,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("KahanAt").field("map", &self.map).field("eps", &self.eps).finish_non_exhaustive()
    }
}
