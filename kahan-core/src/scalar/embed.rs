//! Initial values of the variables by which a `lift` block makes a system quadratic.

use nalgebra::SVector;

use crate::Scalar;

/// A scalar that the `embed` method of a lift accepts, `f32` or `f64`. Elementary functions are
/// computed in `f64`.
#[diagnostic::on_unimplemented(
    message = "`embed` has values in `f32` and `f64`, not in `{Self}`",
    note = "embed a point of `f64`, then convert the numbers of the result"
)]
pub trait EmbedScalar: Scalar + Copy {
    /// Returns the number converted to `f64`.
    fn widened(self) -> f64;
    /// Returns the nearest number of this type.
    fn narrowed(value: f64) -> Self;
}

impl EmbedScalar for f64 {
    fn widened(self) -> f64 {
        self
    }
    fn narrowed(value: f64) -> Self {
        value
    }
}

impl EmbedScalar for f32 {
    fn widened(self) -> f64 {
        self.into()
    }
    fn narrowed(value: f64) -> Self {
        value as f32
    }
}

/// Elementary functions for initial values, with equal bits on every processor.
pub mod elementary {
    pub use libm::{
        acosh, asin, asinh, atan, atanh, cbrt, cos, cosh, exp, log, pow, sin, sinh, sqrt, tan, tanh,
    };

    /// Returns base^exponent by repeated squaring.
    #[must_use]
    pub fn power(base: f64, exponent: i32) -> f64 {
        let power = num_traits::pow(base, exponent.unsigned_abs() as usize);
        if exponent < 0 { 1.0 / power } else { power }
    }
}

/// Returns the components of a point as `f64`.
pub fn components_in_f64<T: EmbedScalar, const N: usize>(x: &SVector<T, N>) -> [f64; N] {
    core::array::from_fn(|i| x[i].widened())
}

/// Creates the point of a lift, which consists of the states and the new variables.
pub fn embedded<T: EmbedScalar, const N: usize, const NEW: usize, const M: usize>(
    x: &SVector<T, N>,
    new: [f64; NEW],
) -> SVector<T, M> {
    SVector::from_fn(|i, _| if i < N { x[i] } else { T::narrowed(new[i - N]) })
}

/// Returns the states, which are the first components of a lift's point.
pub fn projected<T: Scalar, const M: usize, const N: usize>(x: &SVector<T, M>) -> SVector<T, N> {
    SVector::from_fn(|i, _| x[i].clone())
}
