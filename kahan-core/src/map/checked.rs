//! The checked step, which implements `try_step` for handwritten maps, and for scalars other than
//! `f32`, `f64` and `Dd`.
//!
//! A successful step returns a finite x̃ without an error bound. If the fast step overflows,
//! elimination with partial pivoting is tried, unless it may overflow, too.

use nalgebra::{SMatrix, SVector};

use crate::field::linear::{determinant, increment_by_elimination};
use crate::{KahanMap, Pivot, PreparedStep, Quotients, Scalar, SingularStep};

pub(crate) fn checked_step<M: KahanMap<T, N>, T: Pivot, const N: usize>(
    map: &M,
    prepared: &M::Prepared,
    x: &SVector<T, N>,
    eps: &T,
) -> Result<SVector<T, N>, SingularStep> {
    let matrix = || map.matrix(x, eps.clone());
    let singular = || SingularStep::new(determinant(matrix()).approximate(), eps.approximate());

    let quotients = prepared.quotients(x).ok_or_else(singular)?;
    let next = quotients.clone().added_to(x);
    if is_finite(&next) && !hides_an_overflow(map, &quotients, x, eps) {
        return Ok(next);
    }
    let matrix = matrix();
    if !can_eliminate(&matrix) {
        return Err(SingularStep::new(f64::NAN, eps.approximate()));
    }
    let increment = increment_by_elimination(matrix, map.field_at(x, eps), eps).ok_or_else(singular)?;
    let next = advance(x, &increment);
    if is_finite(&next) { Ok(next) } else { Err(singular()) }
}

/// Returns whether zeros in a finite increment may come from an overflow. A denominator that
/// overflows gives 0, because 1/∞ = 0. If f(x) = 0, zeros are correct.
fn hides_an_overflow<M: KahanMap<T, N>, T: Pivot, const N: usize>(
    map: &M,
    quotients: &Quotients<T, N>,
    x: &SVector<T, N>,
    eps: &T,
) -> bool {
    let zeros = quotients.increment().iter().filter(|entry| entry.is_zero()).count();
    let denominator_overflows = || quotients.reciprocals.iter().flatten().any(T::is_zero);
    let pivot_overflows = || !can_eliminate(&map.matrix(x, eps.clone()));
    zeros > 0
        && (zeros == N || denominator_overflows() || pivot_overflows())
        && !map.field_at(x, eps).iter().all(T::is_zero)
}

fn advance<T: Scalar, const N: usize>(x: &SVector<T, N>, increment: &SVector<T, N>) -> SVector<T, N> {
    SVector::from_fn(|i, _| x[i].clone() + increment[i].clone())
}

/// Returns whether elimination cannot overflow. Partial pivoting enlarges the entries of an N × N
/// matrix at most by the factor 2ᴺ⁻¹.
fn can_eliminate<T: Pivot, const N: usize>(matrix: &SMatrix<T, N, N>) -> bool {
    matrix.iter().all(|entry| {
        let grown = (1..N).fold(entry.clone(), |size, _| size.clone() + size);
        grown.is_finite_number()
    })
}

fn is_finite<T: Pivot, const N: usize>(x: &SVector<T, N>) -> bool {
    x.iter().all(T::is_finite_number)
}
