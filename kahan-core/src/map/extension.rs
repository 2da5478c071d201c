//! Systems over another scalar: wider numbers, dual numbers, or numbers with error bounds.

use nalgebra::SVector;

use crate::{KahanMap, Scalar};

use super::tangent::carry_along;

/// A system that exists over every scalar; [`kahan!`](crate::kahan) implements it.
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_core::ExtendScalars;
///
/// kahan! {
///     /// A particle slowed by a resistance kv².
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

    /// Returns the system over the scalar U. The function `convert` converts each parameter, and
    /// exact literals of the system are rounded to U.
    fn extend_scalars<U: Scalar>(&self, convert: impl Fn(&T) -> U) -> Self::Extended<U>;

    /// Returns J(x)·v, where J is the map's Jacobian and `y` is the next state x̃. Returns `None`
    /// at a pole of an exact scalar.
    ///
    /// If det A = 0 only at poles, generated code solves A·(ṽ − v) = 2εf′((x + x̃)/2)·v, where ṽ =
    /// J(x)·v and A = I − εf′(x). Otherwise generated code differentiates the step and ignores `y`.
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
