//! The only door that generated code goes through: not public, not stable, versioned with the macro.
//!
//! In: what the macro alone knows, a field's formulas. Out: the objects of the traits, by code that is written and
//! tested once, here. Generated code names nothing by any other path, so that it works in scopes without a prelude
//! and beside user types called `Option` or `Clone`.

use core::array::from_fn;

pub use core;
pub use core::clone::Clone;
pub use core::option::Option;

pub use kahan_derive;
pub use nalgebra::{SMatrix, SVector};

use nalgebra::ArrayStorage;

pub use crate::scalar::Dual;
pub use crate::{Constant, Integrals, KahanMap, Named, Pivot, QuadraticField, Scalar};

use crate::error::pole;
use crate::linear;

/// The entries of a state, to be bound to names by a pattern.
#[inline]
pub fn components<T, const N: usize>(state: &SVector<T, N>) -> [&T; N] {
    from_fn(|i| &state[i])
}

/// A vector from its entries.
#[inline]
pub fn vector<T, const N: usize>(entries: [T; N]) -> SVector<T, N> {
    SVector::from_array_storage(ArrayStorage([entries]))
}

/// The integer `n` as a scalar.
#[inline]
pub fn integer<T: Scalar>(n: i64) -> T {
    T::constant(&Constant::integer(n))
}

/// The quotient `p`/`q` as a scalar, both at most 2²⁴ in size.
#[inline]
pub fn ratio<T: Scalar>(p: i64, q: i64) -> T {
    T::constant(&Constant::ratio(p, q))
}

/// A matrix from its rows.
#[inline]
pub fn matrix<T: Scalar, const N: usize>(rows: [[T; N]; N]) -> SMatrix<T, N, N> {
    SMatrix::from_fn(|i, j| rows[i][j].clone())
}

/// x̃ − x = 2ε·n/D from the numerators n of A⁻¹f and their common denominator D, with one reciprocal.
///
/// The products 2ε·nᵢ do not wait for the reciprocal, and 2ε/D, which may underflow where the increment does not,
/// is never formed.
#[inline]
pub fn increment_from_quotient<T: Scalar, const N: usize>(
    numerators: SVector<T, N>,
    denominator: T,
    eps: &T,
) -> Option<SVector<T, N>> {
    let reciprocal = denominator.reciprocal()?;
    let dt = eps.clone() + eps.clone();
    Some(SVector::from_fn(|i, _| dt.clone() * numerators[i].clone() * reciprocal.clone()))
}

/// x̃ − x = 2ε·A(x,ε)⁻¹·f(x) by elimination with partial pivoting, for fields without a closed form of usable size.
#[inline]
pub fn increment_by_elimination<M, T, const N: usize>(
    map: &M,
    x: &SVector<T, N>,
    eps: &T,
) -> Option<SVector<T, N>>
where
    M: KahanMap<T, N>,
    T: Scalar,
{
    linear::increment_by_elimination(map.matrix(x, eps.clone()), map.field(x), eps)
}

/// ∂x̃/∂x = I + ∂(x̃ − x)/∂x, by running the increment's closed form once over dual numbers.
///
/// # Panics
/// At a pole of an exact scalar.
#[inline]
pub fn jacobian_of_reduced<T, const N: usize>(
    dual_increment: impl FnOnce(&SVector<Dual<T, N>, N>, &Dual<T, N>) -> Option<SVector<Dual<T, N>, N>>,
    x: &SVector<T, N>,
    eps: &T,
) -> SMatrix<T, N, N>
where
    T: Scalar,
{
    let state = SVector::from_fn(|i, _| Dual::coordinate(x[i].clone(), i));
    let Some(increment) = dual_increment(&state, &Dual::lift(eps.clone())) else { pole(eps) };
    SMatrix::from_fn(|i, j| {
        let slope = increment[i].gradient[j].clone();
        if i == j { T::one() + slope } else { slope }
    })
}
