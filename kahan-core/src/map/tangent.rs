//! Derivatives of one or more steps along a direction v: J(x)·v with the Jacobian J = ∂x̃/∂x.
//!
//! Products are never fused with sums, and therefore all builds give equal bits.

use core::array::from_fn;

use nalgebra::SVector;

use crate::field::linear::vector;
use crate::scalar::DirectionalDual;
use crate::{ExtendScalars, KahanMap, PreparedStep, Quotients, Scalar};

/// Returns J·v, where J is the derivative of all `stages` together. A stage is a map with its ε.
/// Returns `None` at a pole of an exact scalar.
#[inline(always)]
pub(crate) fn push_forward<'a, M: ExtendScalars<T, N> + 'a, T: Scalar, const N: usize>(
    stages: impl Iterator<Item = (&'a M, &'a T)>,
    x: &SVector<T, N>,
    v: &SVector<T, N>,
) -> Option<SVector<T, N>> {
    let (mut x, mut v) = (x.clone(), v.clone());
    for (map, eps) in stages {
        let y = unfused_step(map, eps, &x)?;
        v = map.carry_tangent(eps, &x, &y, &v)?;
        x = y;
    }
    Some(v)
}

/// Returns the result of [`push_forward`]. The caller knows `next`, the point after all stages.
#[inline(always)]
pub(crate) fn push_forward_to<'a, M: ExtendScalars<T, N> + 'a, T: Scalar, const N: usize>(
    mut stages: impl Iterator<Item = (&'a M, &'a T)>,
    x: &SVector<T, N>,
    next: &SVector<T, N>,
    v: &SVector<T, N>,
) -> Option<SVector<T, N>> {
    let (mut x, mut v) = (x.clone(), v.clone());
    let (mut map, mut eps) = stages.next()?;
    for following in stages {
        let y = unfused_step(map, eps, &x)?;
        v = map.carry_tangent(eps, &x, &y, &v)?;
        x = y;
        (map, eps) = following;
    }
    map.carry_tangent(eps, &x, next, &v)
}

#[inline(always)]
fn step_along<M: ExtendScalars<T, N>, T: Scalar, const N: usize>(
    map: &M,
    eps: &T,
    mut along: SVector<DirectionalDual<T>, N>,
) -> Option<SVector<DirectionalDual<T>, N>> {
    let extended =
        map.extend_scalars::<DirectionalDual<T>>(|parameter| DirectionalDual::from_value(parameter.clone()));
    let quotients: Quotients<_, N> =
        extended.prepare(&DirectionalDual::from_value(eps.clone())).quotients(&along)?;
    // Updates in place, because compilers do not inline `from_fn` for arrays of lanes.
    for i in 0..N {
        along[i] = quotients.sum(i, along[i].clone());
    }
    Some(along)
}

#[inline(always)]
fn unfused_step<M: ExtendScalars<T, N>, T: Scalar, const N: usize>(
    map: &M,
    eps: &T,
    x: &SVector<T, N>,
) -> Option<SVector<T, N>> {
    let next = step_along(map, eps, vector(from_fn(|i| DirectionalDual::from_value(x[i].clone()))))?;
    Some(vector(from_fn(|i| next[i].value.clone())))
}

#[inline(always)]
pub(super) fn carry_along<M: ExtendScalars<T, N>, T: Scalar, const N: usize>(
    map: &M,
    eps: &T,
    x: &SVector<T, N>,
    v: &SVector<T, N>,
) -> Option<SVector<T, N>> {
    let along = vector(from_fn(|i| DirectionalDual { value: x[i].clone(), slope: Some(v[i].clone()) }));
    let next = step_along(map, eps, along)?;
    Some(vector(from_fn(|i| next[i].clone().into_slope())))
}
