//! The derivative of a prepared map, along one direction at a time.
//!
//! In: a map at its ε, once; then points x and tangent vectors v. Out: J(x)·v, J = ∂x̃/∂x, by the
//! closed form of the step over numbers along a line. Their products are never fused, so a vector
//! has the same bits on every level of instructions and in every build.

use core::array::from_fn;
use core::fmt;

use nalgebra::SVector;

use crate::field::linear::vector;
use crate::scalar::Along;
use crate::{KahanAt, KahanMap, Lift, PreparedStep, Scalar, Single};

use super::Method;

/// The type of the step that a tangent vector takes: the prepared step over numbers along a line,
/// here or over another scalar U.
pub(crate) type TangentStep<M, T, const N: usize, U = T> =
    <<M as Lift<T, N>>::Lifted<Along<U>> as KahanMap<Along<U>, N>>::Prepared;

/// What carries tangent vectors along a [`KahanAt`]; made by [`KahanAt::tangent`].
pub struct TangentAt<M, T, const N: usize, K = Single>
where
    M: Lift<T, N>,
    T: Scalar,
    K: Method,
{
    pub(crate) map: M,
    pub(crate) eps: T,
    /// ε of each stage.
    pub(crate) parts: K::Stages<T>,
    stages: K::Stages<TangentStep<M, T, N>>,
}

impl<M, T, const N: usize> KahanAt<M, T, N>
where
    M: Lift<T, N>,
    T: Scalar,
{
    /// What carries tangent vectors along this map: v ↦ J(x)·v with J = ∂x̃/∂x.
    ///
    /// All that depends on ε and the parameters alone is computed here, once.
    ///
    /// ```
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// Predator and prey.
    ///     pub struct LotkaVolterra;
    ///     xdot = x*(1 - y);
    ///     ydot = y*(x - 1);
    /// }
    ///
    /// let map = LotkaVolterra.at(0.05);
    /// let (x, v) = (vector![1.5, 1.0], vector![1.0, -2.0]);
    /// let carried = map.tangent().carry(&x, &v).unwrap();
    /// assert!((carried - map.jacobian(&x) * v).norm() < 1e-15);
    /// ```
    pub fn tangent(&self) -> TangentAt<M, T, N> {
        TangentAt::new(&self.map, &self.eps, self.eps.clone())
    }
}

impl<M, T, K, const N: usize> TangentAt<M, T, N, K>
where
    M: Lift<T, N>,
    T: Scalar,
    K: Method,
{
    /// From the stages' ε.
    pub(crate) fn new(map: &M, eps: &T, parts: K::Stages<T>) -> Self {
        let stages = tangent_stages::<M, T, K, T, N>(map, &parts, T::clone);
        Self { map: map.clone(), eps: eps.clone(), parts, stages }
    }

    /// ε, half the time step.
    pub fn eps(&self) -> &T {
        &self.eps
    }

    /// J(x)·v; `None` at a pole of an exact scalar.
    #[inline(always)]
    pub fn carry(&self, x: &SVector<T, N>, v: &SVector<T, N>) -> Option<SVector<T, N>> {
        carry::<K, _, T, N>(&self.stages, x, v)
    }
}

/// The steps of a map at these ε over numbers of U along a line, into which `lift` puts each number.
#[inline(always)]
pub(crate) fn tangent_stages<M, T, K, U, const N: usize>(
    map: &M,
    eps: &K::Stages<T>,
    lift: impl Fn(&T) -> U,
) -> K::Stages<TangentStep<M, T, N, U>>
where
    M: Lift<T, N>,
    T: Scalar,
    K: Method,
    U: Scalar,
{
    let lifted = map.lift::<Along<U>>(|parameter| Along::lift(lift(parameter)));
    K::map(eps, |eps| lifted.prepare(&Along::lift(lift(eps))))
}

/// A tangent vector at a point, all stages later; `None` at a pole of an exact scalar.
#[inline(always)]
pub(crate) fn carry<K, S, T, const N: usize>(
    stages: &K::Stages<S>,
    x: &SVector<T, N>,
    v: &SVector<T, N>,
) -> Option<SVector<T, N>>
where
    K: Method,
    S: PreparedStep<Along<T>, N>,
    T: Scalar,
{
    let mut along: SVector<Along<T>, N> =
        vector(from_fn(|i| Along { value: x[i].clone(), slope: Some(v[i].clone()) }));
    for step in K::in_order(stages) {
        let quotients = step.quotients(&along)?;
        // In its place: over lanes, compilers call what builds an array.
        for i in 0..N {
            along[i] = quotients.sum(i, along[i].clone());
        }
    }
    Some(vector(from_fn(|i| along[i].clone().into_slope())))
}

impl<M, T, K, const N: usize> Clone for TangentAt<M, T, N, K>
where
    M: Lift<T, N>,
    T: Scalar,
    K: Method,
{
    fn clone(&self) -> Self {
        Self {
            map: self.map.clone(),
            eps: self.eps.clone(),
            parts: self.parts.clone(),
            stages: self.stages.clone(),
        }
    }
}

impl<M, T, K, const N: usize> fmt::Debug for TangentAt<M, T, N, K>
where
    M: Lift<T, N> + fmt::Debug,
    T: Scalar,
    K: Method,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("TangentAt").field("map", &self.map).field("eps", &self.eps).finish_non_exhaustive()
    }
}
