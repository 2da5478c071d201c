//! The step that looks at its result.
//!
//! In: a point and ε. Out: a finite x̃, or the reason why there is none.
//! First the fast step; if that left the scalar's range, elimination with partial pivoting, whose intermediate
//! numbers stay near the size of its input. Neither comes with a bound on the error.

use nalgebra::SVector;

use crate::__private::increment_by_elimination;
use crate::map::advance;
use crate::{KahanMap, Pivot, SingularStep};

pub(crate) fn try_step<M, T, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: T,
) -> Result<SVector<T, N>, SingularStep>
where
    M: KahanMap<T, N> + ?Sized,
    T: Pivot,
{
    let singular = || SingularStep::new(map.det_matrix(x, eps.clone()).approximate(), eps.approximate());

    let increment = map.increment(x, &eps).ok_or_else(singular)?;
    let next = advance(x, &increment);
    if is_finite(&next) && !hides_an_overflow(map, x, &increment, &eps) {
        return Ok(next);
    }
    if !can_eliminate(map, x, &eps) {
        // No determinant can be told either.
        return Err(SingularStep::new(f64::NAN, eps.approximate()));
    }
    let increment = increment_by_elimination(map, x, &eps).ok_or_else(singular)?;
    let next = advance(x, &increment);
    if is_finite(&next) { Ok(next) } else { Err(singular()) }
}

/// Whether a finite increment may conceal an overflow, because 1/∞ is 0.
///
/// A denominator that overflows makes the whole increment 0, where f(x) is not; a pivot that overflows, which only a
/// matrix too large to eliminate has, makes its own component 0. (Every other overflow leaves ∞ or no number.)
fn hides_an_overflow<M, T, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    increment: &SVector<T, N>,
    eps: &T,
) -> bool
where
    M: KahanMap<T, N> + ?Sized,
    T: Pivot,
{
    let zeros = increment.iter().filter(|entry| entry.is_zero()).count();
    zeros > 0 && (zeros == N || !can_eliminate(map, x, eps)) && !map.field(x).iter().all(T::is_zero)
}

/// Whether no pivot of A(x,ε) can overflow: partial pivoting makes entries grow at most by the factor 2ᴺ⁻¹.
fn can_eliminate<M, T, const N: usize>(map: &M, x: &SVector<T, N>, eps: &T) -> bool
where
    M: KahanMap<T, N> + ?Sized,
    T: Pivot,
{
    map.matrix(x, eps.clone()).iter().all(|entry| {
        let grown = (1..N).fold(entry.clone(), |size, _| size.clone() + size);
        grown.is_finite_number()
    })
}

fn is_finite<T: Pivot, const N: usize>(x: &SVector<T, N>) -> bool {
    x.iter().all(T::is_finite_number)
}
