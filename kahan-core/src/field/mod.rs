//! The vector field, as the four objects that every formula of the method is made of.
//!
//! In: a state. Out: f, f′, and the two symmetric forms whose diagonal is Q and f. An
//! implementation is free of ε: what depends on the step belongs to [`KahanMap`](crate::KahanMap).
//! Where coefficients depend on ε, the field is the one at ε = 0, which the map approximates.

pub(crate) mod couplings;
pub(crate) mod linear;
mod named;

use nalgebra::{SMatrix, SVector};

use crate::Scalar;

pub use named::{Integrals, Named};

/// A quadratic vector field f(x) = Q(x) + Bx + c on Tᴺ.
///
/// [`kahan!`](crate::kahan!) implements it; by hand, all four methods must describe the same field.
/// None of them divides by a state, so none has a pole.
pub trait QuadraticField<T: Scalar, const N: usize> {
    /// f(x), the right-hand side of ẋ = f(x).
    fn field(&self, x: &SVector<T, N>) -> SVector<T, N>;

    /// f′(x), with the entry ∂fᵢ/∂xⱼ in row i, column j.
    fn field_jacobian(&self, x: &SVector<T, N>) -> SMatrix<T, N, N>;

    /// Q(x,y) = ½[Q(x+y) − Q(x) − Q(y)], symmetric and linear in each argument; Q(x,x) is the
    /// quadratic part of f.
    fn bilinear(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N>;

    /// Q(x,y) + ½B(x+y) + c, symmetric; at (x,x) it is f(x), at (x,x̃) the increment of Kahan's map
    /// over 2ε.
    fn polarized(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N>;
}
