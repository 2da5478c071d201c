//! The step that looks at its result.
//!
//! In: a point, ε, and the fast step's increment. Out: a finite x̃, or the reason why there is none.
//! First the fast step; if that left the scalar's range, elimination with partial pivoting, whose intermediate
//! numbers stay near the size of its input. Neither comes with a bound on the error.

use nalgebra::{SMatrix, SVector};

use crate::linear::{advance, determinant, increment_by_elimination};
use crate::{Pivot, SingularStep};

/// x̃ from the fast `increment`, or from A(x,ε) = `matrix()` and f(x) = `field()`, which are asked for when needed.
pub(crate) fn try_step<T: Pivot, const N: usize>(
    x: &SVector<T, N>,
    eps: &T,
    increment: Option<SVector<T, N>>,
    matrix: impl Fn() -> SMatrix<T, N, N>,
    field: impl Fn() -> SVector<T, N>,
) -> Result<SVector<T, N>, SingularStep> {
    let singular = || SingularStep::new(determinant(matrix()).approximate(), eps.approximate());

    let increment = increment.ok_or_else(singular)?;
    let next = advance(x, &increment);
    let hides_an_overflow = || {
        let zeros = increment.iter().filter(|entry| entry.is_zero()).count();
        zeros > 0 && (zeros == N || !can_eliminate(&matrix())) && !field().iter().all(T::is_zero)
    };
    // A finite increment may conceal an overflow, because 1/∞ is 0. A denominator that overflows makes the whole
    // increment 0, where f(x) is not; a pivot that overflows, which only a matrix too large to eliminate has, makes
    // its own component 0. (Every other overflow leaves ∞ or no number.)
    if is_finite(&next) && !hides_an_overflow() {
        return Ok(next);
    }
    let matrix = matrix();
    if !can_eliminate(&matrix) {
        // No determinant can be told either.
        return Err(SingularStep::new(f64::NAN, eps.approximate()));
    }
    let increment = increment_by_elimination(matrix, field(), eps).ok_or_else(singular)?;
    let next = advance(x, &increment);
    if is_finite(&next) { Ok(next) } else { Err(singular()) }
}

/// Whether no pivot of A(x,ε) can overflow: partial pivoting makes entries grow at most by the factor 2ᴺ⁻¹.
fn can_eliminate<T: Pivot, const N: usize>(matrix: &SMatrix<T, N, N>) -> bool {
    matrix.iter().all(|entry| {
        let grown = (1..N).fold(entry.clone(), |size, _| size.clone() + size);
        grown.is_finite_number()
    })
}

fn is_finite<T: Pivot, const N: usize>(x: &SVector<T, N>) -> bool {
    x.iter().all(T::is_finite_number)
}
