//! An interpreted system without its closed forms: the defaults of [`KahanMap`], for what is beyond
//! the budget of terms.

use kahan_core::nalgebra::{SMatrix, SVector};
use kahan_core::{Elimination, KahanMap, QuadraticField, Scalar};

use super::Interpreted;

/// The same map, every object of which is computed from the field.
#[derive(Clone, Debug)]
pub(super) struct Unplanned<T, const N: usize>(pub(super) Interpreted<T, N>);

impl<T: Scalar, const N: usize> QuadraticField<T, N> for Unplanned<T, N> {
    fn field(&self, x: &SVector<T, N>) -> SVector<T, N> {
        self.0.field(x)
    }

    fn field_jacobian(&self, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        self.0.field_jacobian(x)
    }

    fn bilinear(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N> {
        self.0.bilinear(x, y)
    }

    fn polarized(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N> {
        self.0.polarized(x, y)
    }
}

impl<T: Scalar, const N: usize> KahanMap<T, N> for Unplanned<T, N> {
    type Prepared = Elimination<Self, T>;

    fn prepare(&self, eps: &T) -> Self::Prepared {
        Elimination::new(self.clone(), eps.clone())
    }

    fn has_coefficients_of_eps(&self) -> bool {
        self.0.has_coefficients_of_eps()
    }

    fn field_at(&self, x: &SVector<T, N>, eps: &T) -> SVector<T, N> {
        self.0.field_at(x, eps)
    }

    fn field_jacobian_at(&self, x: &SVector<T, N>, eps: &T) -> SMatrix<T, N, N> {
        self.0.field_jacobian_at(x, eps)
    }

    fn polarized_at(&self, x: &SVector<T, N>, y: &SVector<T, N>, eps: &T) -> SVector<T, N> {
        self.0.polarized_at(x, y, eps)
    }
}
