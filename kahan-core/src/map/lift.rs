//! The same system over another scalar.
//!
//! In: a system whose parameters are numbers of one scalar, and a way to put each of them into
//! another. Out: the system over that one. This is how a step is repeated in a wider precision, in
//! dual numbers, or with an error bound beside each value.

use crate::{KahanMap, Scalar};

/// A system that exists over every scalar, as all do that [`kahan!`](crate::kahan) writes.
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_core::Lift;
///
/// kahan! {
///     /// A particle that meets resistance.
///     pub struct Drag { k }
///     xdot = v;
///     vdot = -k*v^2;
/// }
///
/// let single = Drag { k: 0.25_f32 };
/// let double = single.lift(|k| f64::from(*k));
/// assert_eq!(double, Drag { k: 0.25_f64 });
/// ```
pub trait Lift<T: Scalar, const N: usize>: KahanMap<T, N> {
    /// The system over the scalar U.
    type Lifted<U: Scalar>: Lift<U, N>;

    /// The system with each parameter put into U by `lift`. Parameters only: what is written in the
    /// field are exact numbers, which every scalar rounds for itself.
    fn lift<U: Scalar>(&self, lift: impl Fn(&T) -> U) -> Self::Lifted<U>;
}
