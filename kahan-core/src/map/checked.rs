//! The step that looks at its result: what maps written by hand and exact scalars have for a stable
//! tier.
//!
//! In: a point, ε, and the fast step's increment. Out: a finite x̃, or the reason why there is
//! none. First the fast step; if that left the scalar's range, elimination with partial pivoting,
//! whose intermediate numbers stay near the size of its input. Neither comes with a bound on the
//! error.

use nalgebra::{SMatrix, SVector};

use crate::field::linear::{determinant, increment_by_elimination};
use crate::{KahanMap, Pivot, PreparedStep, Quotients, Scalar, SingularStep};

/// x̃ from the fast step, `prepared` from `map` at `eps`, or by elimination.
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
        // No determinant can be told either.
        return Err(SingularStep::new(f64::NAN, eps.approximate()));
    }
    let increment = increment_by_elimination(matrix, map.field_at(x, eps), eps).ok_or_else(singular)?;
    let next = advance(x, &increment);
    if is_finite(&next) { Ok(next) } else { Err(singular()) }
}

/// Whether a finite increment conceals an overflow, which it can because 1/∞ is 0.
///
/// A denominator that overflows makes its components' increments 0; with an inner one, all of them
/// or, where the matrix is too large to eliminate, the one whose pivot overflowed. (Every other
/// overflow leaves ∞ or no number.) Where f(x) is 0, an increment of 0 conceals nothing.
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

/// x + increment.
fn advance<T: Scalar, const N: usize>(x: &SVector<T, N>, increment: &SVector<T, N>) -> SVector<T, N> {
    SVector::from_fn(|i, _| x[i].clone() + increment[i].clone())
}

/// Whether no pivot of A(x,ε) can overflow: partial pivoting makes entries grow at most by the
/// factor 2ᴺ⁻¹.
fn can_eliminate<T: Pivot, const N: usize>(matrix: &SMatrix<T, N, N>) -> bool {
    matrix.iter().all(|entry| {
        let grown = (1..N).fold(entry.clone(), |size, _| size.clone() + size);
        grown.is_finite_number()
    })
}

fn is_finite<T: Pivot, const N: usize>(x: &SVector<T, N>) -> bool {
    x.iter().all(T::is_finite_number)
}
