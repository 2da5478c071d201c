//! The interface for generated code, which is neither public nor stable and changes with the macro.
//!
//! Generated code names items of this crate through this module, and items of `core` through it or
//! by absolute paths. Therefore it works without a prelude, and beside user types called `Option`
//! or `Clone`.

pub use core;
pub use core::clone::Clone;
pub use core::ops::Fn;
pub use core::option::Option::{self, None, Some};
pub use core::primitive::{bool, f32, f64, str, usize};
pub use core::result::Result;

pub use kahan_derive;
pub use nalgebra::{SMatrix, SVector};
pub use num_traits::PrimInt;
#[cfg(feature = "std")]
pub use std::vec::{self, Vec};

/// Elimination for fields with many nonlinear terms, used by `kahan-runtime`.
#[cfg(feature = "std")]
pub mod dense {
    pub use crate::dense::{Workspace, assemble, coefficients, pack, points, velocities, velocity};
}
/// SIMD lanes as scalars, used by `kahan-runtime`.
#[cfg(feature = "std")]
pub use crate::ensemble::{
    lanes::{InLanes, Lanes, OverLanes},
    register_pair::RegisterPair,
};
pub use crate::field::couplings::{CouplingRow, Couplings, LARGEST_FACTOR};
pub use crate::field::linear::{components, vector};
/// Elimination for fields whose step has no closed formula, used by `kahan-runtime`.
pub use crate::field::linear::{determinant, determinant_and_adjugate_product, solve};
#[cfg(feature = "std")]
pub use crate::supernodes::{PanelWorkspace, Supernodes};
/// The solver of lattice systems (chains of sites), used by `kahan-runtime`.
#[cfg(feature = "std")]
pub mod chain {
    pub use crate::lattice::{Gathered, SiteLine, StencilMenu};
}
#[cfg(feature = "std")]
pub use crate::lattice::{Boundary, LatticeMap, LatticeScalar, Sizes, Stencil};
pub use crate::map::{CoupledField, CoupledStep, Postfix, slopes_matrix, stable_step};
pub use crate::scalar::embed::{components_in_f64, elementary, embedded, projected};
pub use crate::scalar::tuning::fenced;
pub use crate::step::error::pole;
pub use crate::step::{Kernel, Padded, StepOfOneOrbit, StepOverEps, StraightStep};
pub use crate::undeclared::{IntegerParameters, WithoutDensity, WithoutIntegrals};
pub use crate::{
    Constant, Elimination, EmbedScalar, ExtendScalars, Integrals, KahanMap, Named, Pivot, PreparedStep,
    QuadraticField, Quotients, Scalar, SingularStep, StepCost,
};

use core::cmp::Ordering;

use crate::scalar::Dual;

#[inline(always)]
pub fn integer<T: Scalar>(n: i64) -> T {
    T::constant(&Constant::integer(n))
}

/// Returns p/q as a scalar. Neither |p| nor q may exceed 2²⁴.
#[inline(always)]
pub fn ratio<T: Scalar>(p: i64, q: i64) -> T {
    T::constant(&Constant::ratio(p, q))
}

/// Stores a result. For scalars other than floats the store is not inlined: thousands of inlined
/// stores in one function would take minutes to compile.
#[inline(always)]
pub fn put<T: Scalar>(place: &mut T, result: T) {
    #[inline(never)]
    fn called<T>(place: &mut T, result: T) {
        *place = result;
    }
    if crate::scalar::tuning::is_float::<T>() { *place = result } else { called(place, result) }
}

/// Functions that generated code imports so that they hide a user's constants. Otherwise a constant
/// `x` would turn the argument `x` of a generated method into a pattern.
pub mod arguments {
    pub fn x() {}
    pub fn y() {}
    pub fn eps() {}
    pub fn prepared() {}
    pub fn convert() {}
    pub fn constants() {}
    pub fn index() {}
    pub fn c() {}
    pub fn f() {}
    pub fn a() {}
    pub fn s() {}
}

/// Returns whether a step may divide by ε. This depends on the scalar and on |ε|.
pub fn may_divide_by<T: Scalar>(eps: &T) -> bool {
    crate::scalar::tuning::may_divide_by(eps)
}

#[inline]
pub fn matrix<T: Scalar, const N: usize>(rows: [[T; N]; N]) -> SMatrix<T, N, N> {
    SMatrix::from_fn(|i, j| rows[i][j].clone())
}

/// Returns the Jacobian ∂x̃/∂x of a step, computed with dual numbers.
///
/// # Panics
/// If the scalar is exact and `x` is a pole.
#[inline]
pub fn jacobian_by_duals<M, T, const N: usize>(map: &M, x: &SVector<T, N>, eps: &T) -> SMatrix<T, N, N>
where
    M: ExtendScalars<T, N>,
    T: Scalar,
{
    let state = SVector::from_fn(|i, _| Dual::coordinate(x[i].clone(), i));
    let extended = map.extend_scalars::<Dual<T, N>>(|parameter| Dual::from_value(parameter.clone()));
    let step = extended.prepare(&Dual::from_value(eps.clone()));
    let Some(increment) = step.increment(&state) else { pole(eps) };
    SMatrix::from_fn(|i, j| {
        let slope = increment[i].gradient[j].clone();
        if i == j { T::one() + slope } else { slope }
    })
}

/// Returns the antisymmetric matrix with these entries above the diagonal, given row by row.
pub fn antisymmetric<T: Scalar, const N: usize, const ABOVE: usize>(above: [T; ABOVE]) -> SMatrix<T, N, N> {
    let place = |i: usize, j: usize| i * (2 * N - i - 1) / 2 + (j - i - 1);
    SMatrix::from_fn(|i, j| match i.cmp(&j) {
        Ordering::Less => above[place(i, j)].clone(),
        Ordering::Equal => T::zero(),
        Ordering::Greater => -above[place(j, i)].clone(),
    })
}
