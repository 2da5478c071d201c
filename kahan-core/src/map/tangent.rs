//! The derivative of a map at its ε, along one direction at a time.
//!
//! In: a map at its ε, once; then points x and tangent vectors v. Out: J(x)·v, J = ∂x̃/∂x, by the
//! linear equation that it solves, or by the closed form of the step over numbers along a line.
//! Products are never fused, so a vector has the same bits on every level of instructions and in
//! every build.

use core::array::from_fn;
use core::fmt;

use nalgebra::SVector;

use crate::field::linear::vector;
use crate::scalar::Along;
use crate::{KahanAt, KahanMap, Lift, PreparedStep, Quotients, Scalar, Single};

use super::Method;

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
}

impl<M, T, const N: usize> KahanAt<M, T, N>
where
    M: Lift<T, N>,
    T: Scalar,
{
    /// What carries tangent vectors along this map: v ↦ J(x)·v with J = ∂x̃/∂x.
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
        Self { map: map.clone(), eps: eps.clone(), parts }
    }

    /// ε, half the time step.
    pub fn eps(&self) -> &T {
        &self.eps
    }

    /// J(x)·v; `None` at a pole of an exact scalar.
    #[inline(always)]
    pub fn carry(&self, x: &SVector<T, N>, v: &SVector<T, N>) -> Option<SVector<T, N>> {
        let (mut x, mut v) = (x.clone(), v.clone());
        for eps in K::in_order(&self.parts) {
            let y = unfused_step(&self.map, eps, &x)?;
            v = self.map.carry_tangent(eps, &x, &y, &v)?;
            x = y;
        }
        Some(v)
    }

    /// The same where x̃ is known, as an orbit's next point is: about half of the work then.
    #[inline(always)]
    pub fn carry_to(
        &self,
        x: &SVector<T, N>,
        next: &SVector<T, N>,
        v: &SVector<T, N>,
    ) -> Option<SVector<T, N>> {
        carry_to::<K, M, T, N>(&self.map, &self.parts, x, next, v)
    }
}

/// J(x)·v of a map with these ε of its stages, for the point after the last of them.
#[inline(always)]
pub(crate) fn carry_to<K, M, T, const N: usize>(
    map: &M,
    parts: &K::Stages<T>,
    x: &SVector<T, N>,
    next: &SVector<T, N>,
    v: &SVector<T, N>,
) -> Option<SVector<T, N>>
where
    K: Method,
    M: Lift<T, N>,
    T: Scalar,
{
    let (mut x, mut v) = (x.clone(), v.clone());
    let mut left = K::in_order(parts).count();
    for eps in K::in_order(parts) {
        left -= 1;
        let y = if left == 0 { next.clone() } else { unfused_step(map, eps, &x)? };
        v = map.carry_tangent(eps, &x, &y, &v)?;
        x = y;
    }
    Some(v)
}

/// The step over numbers along a line, and the point and the vector that each of them is made of.
#[inline(always)]
fn step_along<M, T, const N: usize>(
    map: &M,
    eps: &T,
    mut along: SVector<Along<T>, N>,
) -> Option<SVector<Along<T>, N>>
where
    M: Lift<T, N>,
    T: Scalar,
{
    let lifted = map.lift::<Along<T>>(|parameter| Along::lift(parameter.clone()));
    let quotients: Quotients<_, N> = lifted.prepare(&Along::lift(eps.clone())).quotients(&along)?;
    // In its place: over lanes, compilers call what builds an array.
    for i in 0..N {
        along[i] = quotients.sum(i, along[i].clone());
    }
    Some(along)
}

/// x̃ by products that are never fused.
#[inline(always)]
fn unfused_step<M, T, const N: usize>(map: &M, eps: &T, x: &SVector<T, N>) -> Option<SVector<T, N>>
where
    M: Lift<T, N>,
    T: Scalar,
{
    let next = step_along(map, eps, vector(from_fn(|i| Along::lift(x[i].clone()))))?;
    Some(vector(from_fn(|i| next[i].value.clone())))
}

/// J(x)·v by numbers along v.
#[inline(always)]
pub(super) fn carry_along<M, T, const N: usize>(
    map: &M,
    eps: &T,
    x: &SVector<T, N>,
    v: &SVector<T, N>,
) -> Option<SVector<T, N>>
where
    M: Lift<T, N>,
    T: Scalar,
{
    let along = vector(from_fn(|i| Along { value: x[i].clone(), slope: Some(v[i].clone()) }));
    let next = step_along(map, eps, along)?;
    Some(vector(from_fn(|i| next[i].clone().into_slope())))
}

impl<M, T, K, const N: usize> Clone for TangentAt<M, T, N, K>
where
    M: Lift<T, N>,
    T: Scalar,
    K: Method,
{
    fn clone(&self) -> Self {
        Self { map: self.map.clone(), eps: self.eps.clone(), parts: self.parts.clone() }
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
