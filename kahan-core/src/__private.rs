//! The only door that generated code goes through: not public, not stable, versioned with the macro.
//!
//! In: what the macro alone knows, a field's formulas. Out: the objects of the traits, by code that is written and
//! tested once, here. Generated code names nothing by any other path, so that it works in scopes without a prelude
//! and beside user types called `Option` or `Clone`.

pub use core;
pub use core::clone::Clone;
pub use core::option::Option;

pub use kahan_derive;
pub use nalgebra::{SMatrix, SVector};

pub use crate::field::linear::{components, vector};
pub use crate::scalar::Dual;
pub use crate::step::Apart;
pub use crate::undeclared::{Integer, IntegerParameters, WithoutDensity, WithoutIntegrals};
pub use crate::{
    Constant, Elimination, Integrals, KahanMap, Lift, Named, Pivot, PreparedStep, QuadraticField, Quotients,
    Scalar, SingularStep, StepCost, WideStep,
};

use core::array::from_fn;

use crate::step::error::pole;

/// The integer `n` as a scalar.
#[inline(always)]
pub fn integer<T: Scalar>(n: i64) -> T {
    T::constant(&Constant::integer(n))
}

/// The quotient `p`/`q` as a scalar, both at most 2²⁴ in size.
#[inline(always)]
pub fn ratio<T: Scalar>(p: i64, q: i64) -> T {
    T::constant(&Constant::ratio(p, q))
}

/// x̃ − x of a step at an ε that does not allow the faster one; no numbers where there is none.
///
/// It is called, so that the faster one stays small enough to be inlined, and sees a copy of the state, so that a loop can keep the
/// state in registers.
#[cold]
#[inline(never)]
pub fn general_increment<S, T, const N: usize>(step: &S, state: SVector<T, N>) -> [T; N]
where
    S: PreparedStep<T, N>,
    T: Scalar,
{
    let increment = step.increment(&state).unwrap_or_else(|| vector(from_fn(|_| T::zero() / T::zero())));
    let [entries] = increment.data.0;
    entries
}

/// Whether a step with this ε may divide by it, and what it divides by: ε, or 1 where nobody takes the quotients.
#[inline(always)]
pub fn divisor<T: Scalar>(eps: &T) -> (bool, T) {
    let is_inverse = eps.has_inverse_step();
    (is_inverse, if is_inverse { eps.clone() } else { T::one() })
}

/// A matrix from its rows.
#[inline]
pub fn matrix<T: Scalar, const N: usize>(rows: [[T; N]; N]) -> SMatrix<T, N, N> {
    SMatrix::from_fn(|i, j| rows[i][j].clone())
}

/// ∂x̃/∂x = I + ∂(x̃ − x)/∂x, by one increment of the map over dual numbers.
///
/// # Panics
/// At a pole of an exact scalar.
#[inline]
pub fn jacobian_by_duals<M, T, const N: usize>(map: &M, x: &SVector<T, N>, eps: &T) -> SMatrix<T, N, N>
where
    M: Lift<T, N>,
    T: Scalar,
{
    let state = SVector::from_fn(|i, _| Dual::coordinate(x[i].clone(), i));
    let lifted = map.lift::<Dual<T, N>>(|parameter| Dual::lift(parameter.clone()));
    let step = lifted.prepare(&Dual::lift(eps.clone()));
    let Some(increment) = step.increment(&state) else { pole(eps) };
    SMatrix::from_fn(|i, j| {
        let slope = increment[i].gradient[j].clone();
        if i == j { T::one() + slope } else { slope }
    })
}

/// The step with a promise, as far as the scalar can give one.
///
/// # Errors
/// As [`KahanMap::try_step`].
#[inline(always)]
pub fn stable_step<M, T, const N: usize>(
    map: &M,
    prepared: &M::Prepared,
    x: &SVector<T, N>,
    eps: &T,
) -> Result<SVector<T, N>, SingularStep>
where
    M: Lift<T, N>,
    T: Pivot,
{
    T::stable_step(map, prepared, x, eps)
}
