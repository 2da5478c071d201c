//! An interpreted system as a Kahan map: every object by its program, or from the field where that
//! is beyond the budget of terms.

use kahan_core::__private::jacobian_by_duals;
use kahan_core::nalgebra::{SMatrix, SVector};
use kahan_core::{KahanMap, Lift, Pivot, QuadraticField, Scalar, SingularStep};

use super::unplanned::Unplanned;
use super::{Interpreted, InterpretedStep};

/// The values, and 0 for each variable that stands still.
fn vector<T: Scalar, const N: usize>(values: &[T]) -> SVector<T, N> {
    SVector::from_fn(|i, _| values.get(i).cloned().unwrap_or_else(T::zero))
}

/// Numerators and the denominator behind them.
fn fraction<T: Scalar, const N: usize>(values: &[T]) -> (SVector<T, N>, T) {
    let (denominator, numerators) =
        values.split_last().unwrap_or_else(|| unreachable!("a map has a denominator"));
    (vector(numerators), denominator.clone())
}

impl<T: Scalar, const N: usize> QuadraticField<T, N> for Interpreted<T, N> {
    fn field(&self, x: &SVector<T, N>) -> SVector<T, N> {
        vector(&self.values(&self.code.field, x, &[], None))
    }

    fn field_jacobian(&self, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        let (entries, own) = (self.values(&self.code.field_jacobian, x, &[], None), self.code.states.len());
        SMatrix::from_fn(|i, j| if i.max(j) < own { entries[i * own + j].clone() } else { T::zero() })
    }

    fn bilinear(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N> {
        vector(&self.values(&self.code.bilinear, x, y.as_slice(), None))
    }

    fn polarized(&self, x: &SVector<T, N>, y: &SVector<T, N>) -> SVector<T, N> {
        vector(&self.values(&self.code.polarized, x, y.as_slice(), None))
    }
}

impl<T: Scalar, const N: usize> KahanMap<T, N> for Interpreted<T, N> {
    type Prepared = InterpretedStep<T, N>;

    fn prepare(&self, eps: &T) -> Self::Prepared {
        InterpretedStep::new(self.clone(), eps.clone())
    }

    fn try_prepared(
        &self,
        prepared: &Self::Prepared,
        x: &SVector<T, N>,
        eps: &T,
    ) -> Result<SVector<T, N>, SingularStep>
    where
        T: Pivot,
    {
        T::stable_step(self, prepared, x, eps)
    }

    fn jacobian(&self, x: &SVector<T, N>, eps: T) -> SMatrix<T, N, N> {
        match &self.code.step {
            Some(_) => jacobian_by_duals(self, x, &eps),
            None => Unplanned(self.clone()).jacobian(x, eps),
        }
    }

    fn det_matrix(&self, x: &SVector<T, N>, eps: T) -> T {
        match &self.code.det_matrix {
            Some(program) => self.values(program, x, &[], Some(&eps)).swap_remove(0),
            None => Unplanned(self.clone()).det_matrix(x, eps),
        }
    }

    fn rational_map(&self, x: &SVector<T, N>, eps: T) -> (SVector<T, N>, T) {
        match &self.code.rational_map {
            Some(program) => fraction(&self.values(program, x, &[], Some(&eps))),
            None => Unplanned(self.clone()).rational_map(x, eps),
        }
    }

    fn reduced_map(&self, x: &SVector<T, N>, eps: T) -> (SVector<T, N>, T) {
        match &self.code.reduced_map {
            Some(program) => fraction(&self.values(program, x, &[], Some(&eps))),
            None => self.rational_map(x, eps),
        }
    }
}

impl<T: Scalar, const N: usize> Lift<T, N> for Interpreted<T, N> {
    type Lifted<U: Scalar> = Interpreted<U, N>;

    fn lift<U: Scalar>(&self, lift: impl Fn(&T) -> U) -> Interpreted<U, N> {
        self.over(lift)
    }
}
