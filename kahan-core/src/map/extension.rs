//! The same system over another scalar.
//!
//! In: a system whose parameters are numbers of one scalar, and a way to put each of them into
//! another. Out: the system over that one. This is how a step is repeated in a wider precision, in
//! dual numbers, or with an error bound beside each value.

use nalgebra::SVector;

use crate::{KahanMap, Scalar};

use super::tangent::carry_along;

/// A system that exists over every scalar, as all do that [`kahan!`](crate::kahan) writes.
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_core::ExtendScalars;
///
/// kahan! {
///     /// A particle that meets resistance.
///     pub struct Drag { k }
///     xdot = v;
///     vdot = -k*v^2;
/// }
///
/// let single = Drag { k: 0.25_f32 };
/// let double = single.extend_scalars(|k| f64::from(*k));
/// assert_eq!(double, Drag { k: 0.25_f64 });
/// ```
pub trait ExtendScalars<T: Scalar, const N: usize>: KahanMap<T, N> {
    /// The system over the scalar U.
    type Extended<U: Scalar>: ExtendScalars<U, N>;

    /// The system with each parameter put into U by `convert`. Parameters only: what is written in
    /// the field are exact numbers, which every scalar rounds for itself.
    fn extend_scalars<U: Scalar>(&self, convert: impl Fn(&T) -> U) -> Self::Extended<U>;

    /// The tangent vector `v` at `x` carried to x̃, which is `y`: J(x)·v. `None` at a pole of an
    /// exact scalar.
    ///
    /// The macro writes the solution of A(x,ε)·(ṽ − v) = 2ε f′((x + x̃)/2)·v where det A is zero at
    /// poles alone. Other maps differentiate their step, and have no need of `y`.
    #[doc(hidden)]
    #[inline(always)]
    fn carry_tangent(
        &self,
        eps: &T,
        x: &SVector<T, N>,
        _y: &SVector<T, N>,
        v: &SVector<T, N>,
    ) -> Option<SVector<T, N>> {
        carry_along(self, eps, x, v)
    }
}
