//! Kahan's map as the linear system A(x,ε)·x̃ = b(x,ε), solved by `nalgebra`'s LU decompositions.

use kahan_core::prelude::*;
use nalgebra::{Const, DMatrix, DVector, DimMin};

/// Returns a step that uses the LU decomposition of an `SMatrix` with partial pivoting.
pub(crate) fn of_static_size<M, const N: usize>(map: M, eps: f64) -> impl Fn([f64; N]) -> [f64; N]
where
    M: KahanMap<f64, N>,
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    move |x| {
        let x = SVector::from(x);
        solved(map.matrix(&x, eps).lu().solve(&map.rhs(&x, eps))).into()
    }
}

/// Returns a step that uses the LU decomposition of a `DMatrix`, which allocates memory.
pub(crate) fn of_dynamic_size<M, const N: usize>(map: M, eps: f64) -> impl Fn([f64; N]) -> [f64; N]
where
    M: KahanMap<f64, N>,
{
    move |x| {
        let x = SVector::from(x);
        let (matrix, rhs) = (map.matrix(&x, eps), map.rhs(&x, eps));
        let matrix = DMatrix::from_column_slice(N, N, matrix.as_slice());
        let next = solved(matrix.lu().solve(&DVector::from_column_slice(rhs.as_slice())));
        std::array::from_fn(|i| next[i])
    }
}

/// Returns the solution. Panics if the matrix is singular, which does not occur in the benchmarks.
fn solved<X>(solution: Option<X>) -> X {
    solution.expect("the chains stay away from poles")
}
