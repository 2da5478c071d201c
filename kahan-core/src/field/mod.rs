//! The vector field, given by four functions from which all formulas of the method follow.
//!
//! In: a state. Out: f, f′, and the two symmetric forms that equal Q and f on the diagonal. If
//! coefficients depend on ε, these functions take them at ε = 0.

pub(crate) mod couplings;
pub(crate) mod linear;
mod named;

use nalgebra::{SMatrix, SVector};

use crate::Scalar;

pub use named::{Integrals, Named};

/// A quadratic vector field f(x) = Q(x) + Bx + c on Tᴺ.
///
/// [`kahan!`](crate::kahan!) implements it; handwritten methods must all describe one field.
pub trait QuadraticField<T: Scalar, const N: usize> {
    /// Returns f(x), the right-hand side of ẋ = f(x).
    fn field(&self, x: &SVector<T, N>) -> SVector<T, N>;

    /// Returns f′(x), with ∂fᵢ/∂xⱼ in row i, column j.
    fn field_jacobian(&self, x: &SVector<T, N>) -> SMatrix<T, N, N>;

    /// Returns Q(x,y) = ½[Q(x+y) − Q(x) − Q(y)]; Q(x,x) is the quadratic part of f.
    fn bilinear(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N>;

    /// Returns Q(x,y) + ½B(x+y) + c, symmetric; it is f(x) for y = x, (x̃ − x)/(2ε) for y = x̃.
    fn polarized(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N>;
}
