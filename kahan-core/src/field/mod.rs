//! The vector field, as the four functions from which all formulas of the method are made.
//!
//! In: a state. Out: f, f′, and the two symmetric forms with diagonals Q and f. Implementations do
//! not depend on ε; coefficients that do are those at ε = 0.

pub(crate) mod couplings;
pub(crate) mod linear;
mod named;

use nalgebra::{SMatrix, SVector};

use crate::Scalar;

pub use named::{Integrals, Named};

/// A quadratic vector field f(x) = Q(x) + Bx + c on Tᴺ, without poles in x.
///
/// [`kahan!`](crate::kahan!) implements it; by hand, all four methods must describe one field.
pub trait QuadraticField<T: Scalar, const N: usize> {
    /// Returns f(x), the right-hand side of ẋ = f(x).
    fn field(&self, x: &SVector<T, N>) -> SVector<T, N>;

    /// Returns f′(x), with ∂fᵢ/∂xⱼ in row i, column j.
    fn field_jacobian(&self, x: &SVector<T, N>) -> SMatrix<T, N, N>;

    /// Returns Q(x,y) = ½[Q(x+y) − Q(x) − Q(y)]; Q(x,x) is the quadratic part of f.
    fn bilinear(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N>;

    /// Returns Q(x,y) + ½B(x+y) + c, symmetric: f(x) at (x,x), and (x̃ − x)/(2ε) at (x,x̃).
    fn polarized(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N>;
}
