//! Derivatives of maps that `kahan!` generates. Maps in `f64` have a Jacobian. Maps in dual numbers
//! also have derivatives with respect to ε or a parameter.

use kahan_core::nalgebra::{DMatrix, SVector};

use kahan_core::{Dual, ExtendScalars, KahanAt, KahanMap};

use super::{Differentiable, Parametric};

impl<M, const N: usize> Differentiable for KahanAt<M, f64, N>
where
    M: KahanMap<f64, N> + ExtendScalars<f64, N>,
{
    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        let jacobian = self.jacobian(&SVector::from_column_slice(x));
        DMatrix::from_fn(N, N, |i, j| jacobian[(i, j)])
    }
}

impl<M, const N: usize> Differentiable for KahanAt<M, Dual<f64, 1>, N>
where
    M: KahanMap<Dual<f64, 1>, N> + ExtendScalars<Dual<f64, 1>, N>,
{
    fn derivative(&self, x: &[f64]) -> DMatrix<f64> {
        let jacobian = self.jacobian(&fixed(x));
        DMatrix::from_fn(N, N, |i, j| jacobian[(i, j)].value)
    }
}

impl<M, const N: usize> Parametric for KahanAt<M, Dual<f64, 1>, N>
where
    M: KahanMap<Dual<f64, 1>, N> + ExtendScalars<Dual<f64, 1>, N>,
{
    fn by_parameter(&self, x: &[f64]) -> Vec<f64> {
        self.step(&fixed(x)).iter().map(|entry| entry.gradient[0]).collect()
    }
}

fn fixed<const N: usize>(x: &[f64]) -> SVector<Dual<f64, 1>, N> {
    SVector::from_fn(|i, _| Dual::from_value(x[i]))
}
