//! The vector field f, as four functions from which all formulas of the method follow.
//!
//! If coefficients of f depend on ε, these functions take the coefficients at ε = 0, and `KahanMap`
//! has functions for other ε.

pub(crate) mod couplings;
pub(crate) mod linear;
mod named;

use nalgebra::{SMatrix, SVector};

use crate::Scalar;

pub use named::{Integrals, Named};

/// A quadratic vector field f(x) = Q(x) + Bx + c on Tᴺ.
///
/// [`kahan!`](crate::kahan!) implements this trait.
pub trait QuadraticField<T: Scalar, const N: usize> {
    /// Returns f(x), the right-hand side of the equation ẋ = f(x).
    fn field(&self, x: &SVector<T, N>) -> SVector<T, N>;

    /// Returns the derivative f′(x). The entry in row i, column j is ∂fᵢ/∂xⱼ.
    fn field_jacobian(&self, x: &SVector<T, N>) -> SMatrix<T, N, N>;

    /// Returns Q(x,y) = ½[Q(x+y) − Q(x) − Q(y)], where Q(x) = Q(x,x) is the quadratic part of f.
    fn bilinear(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N>;

    /// Returns the symmetric form Q(x,y) + ½B(x+y) + c. For y = x the form is f(x); for y = x̃ it
    /// is (x̃ − x)/(2ε).
    fn polarized(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N>;
}
