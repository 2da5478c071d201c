//! What observers need of a map: tangent vectors carried along.
//!
//! In: a map at its ε. Out: traits that prepared maps have, and that other owners of a map can
//! have; the number of variables need not be known while compiling.

use core::array::from_fn;
use core::fmt::Debug;

use nalgebra::{SMatrix, SVector};

use crate::composition::Composed;
#[cfg(feature = "std")]
use crate::ensemble::columns::GROUP;
use crate::field::linear::determinant;
use crate::{Composition, FloatScalar, Lift, Method, Scalar, TangentAt};
#[cfg(feature = "std")]
use crate::{EnsembleScalar, PreparedStep};

#[cfg(feature = "std")]
use super::{Grouped, SideBySide, lanes::ByOneMap};

/// A space of points and vectors, which a map acts on.
pub trait Points<T> {
    /// A point, or a tangent vector: an array where the number of variables is known while
    /// compiling.
    type Point: Clone + Debug + AsRef<[T]> + AsMut<[T]>;

    /// The point whose entry i is `entry(i)`.
    fn point(&self, entry: impl FnMut(usize) -> T) -> Self::Point;
}

/// A map that carries tangent vectors along: v ↦ J(x)·v, J = ∂x̃/∂x.
pub trait Tangent<T>: Points<T> + Clone {
    /// ε, half the time step, as a number for reports.
    fn half_step(&self) -> f64;

    /// Replaces the tangent vector `v` at the point `x` by J(x)·v.
    ///
    fn carry(&self, x: &[T], v: &mut Self::Point);

    /// The same where x̃ is known, as observers know it, and that saves work; what depends on both
    /// points alone is computed once for several vectors, likewise.
    #[inline(always)]
    fn carry_to(&self, x: &[T], _next: &[T], v: &mut Self::Point) {
        self.carry(x, v);
    }

    /// det J(x)
    fn det_jacobian(&self, x: &[T]) -> T;

    /// Carries the vectors of a group of trajectories, each by its own map, from the first of its
    /// points to the last, and writes the squares of their lengths after each step, if there is
    /// room for them. It may end early after a step that takes one of these out of the range that
    /// vectors are kept in, and returns the steps taken; `None` where it cannot. Bits are those of
    /// [`carry_to`](Self::carry_to).
    #[cfg(feature = "std")]
    #[doc(hidden)]
    fn carry_side_by_side<P: Grouped<T>>(_maps: [&Self; GROUP], _work: SideBySide<'_, T, P>) -> Option<usize>
    where
        T: EnsembleScalar,
    {
        None
    }
}

impl<T, M: Points<T>> Points<T> for &M {
    type Point = M::Point;

    fn point(&self, entry: impl FnMut(usize) -> T) -> Self::Point {
        M::point(self, entry)
    }
}

impl<T, M: Tangent<T>> Tangent<T> for &M {
    fn half_step(&self) -> f64 {
        M::half_step(self)
    }

    #[inline(always)]
    fn carry(&self, x: &[T], v: &mut Self::Point) {
        M::carry(self, x, v);
    }

    #[inline(always)]
    fn carry_to(&self, x: &[T], next: &[T], v: &mut Self::Point) {
        M::carry_to(self, x, next, v);
    }

    #[inline(always)]
    fn det_jacobian(&self, x: &[T]) -> T {
        M::det_jacobian(self, x)
    }

    #[cfg(feature = "std")]
    fn carry_side_by_side<P: Grouped<T>>(maps: [&Self; GROUP], work: SideBySide<'_, T, P>) -> Option<usize>
    where
        T: EnsembleScalar,
    {
        M::carry_side_by_side(maps.map(|map| *map), work)
    }
}

impl<M, T, K, const N: usize> Points<T> for TangentAt<M, T, N, K>
where
    M: Lift<T, N>,
    T: Scalar,
    K: Method,
{
    type Point = [T; N];

    fn point(&self, entry: impl FnMut(usize) -> T) -> [T; N] {
        from_fn(entry)
    }
}

/// Of the map itself and of compositions. A slice of another length than the number of variables
/// panics.
impl<M, T, K, const N: usize> Tangent<T> for TangentAt<M, T, N, K>
where
    M: Lift<T, N>,
    T: FloatScalar,
    K: Method,
{
    fn half_step(&self) -> f64 {
        self.eps().approximate()
    }

    #[inline(always)]
    fn carry(&self, x: &[T], v: &mut [T; N]) {
        // Floats have a value at every point.
        if let Some(carried) = TangentAt::carry(self, &entries(x), &SVector::from(*v)) {
            [*v] = carried.data.0;
        }
    }

    #[inline(always)]
    fn carry_to(&self, x: &[T], next: &[T], v: &mut [T; N]) {
        if let Some(carried) = TangentAt::carry_to(self, &entries(x), &entries(next), &SVector::from(*v)) {
            [*v] = carried.data.0;
        }
    }

    /// By the tangent vectors of all variables.
    #[inline]
    fn det_jacobian(&self, x: &[T]) -> T {
        let mut columns = [[T::zero(); N]; N];
        for (i, column) in columns.iter_mut().enumerate() {
            column[i] = T::one();
            Tangent::carry(self, x, column);
        }
        determinant::<T, N>(SMatrix::from_fn(|i, j| columns[j][i]))
    }

    #[cfg(feature = "std")]
    fn carry_side_by_side<P: Grouped<T>>(maps: [&Self; GROUP], work: SideBySide<'_, T, P>) -> Option<usize>
    where
        T: EnsembleScalar,
    {
        // The vectors of different maps have different constants.
        let are_one = maps.iter().all(|map| core::ptr::eq(*map, maps[0]));
        let has_lanes = <M::Prepared as PreparedStep<_, N>>::HAS_LANES;
        let level = work.level;
        if are_one && has_lanes { T::over_lanes(ByOneMap { map: maps[0], work }, level) } else { None }
    }
}

/// The point at this slice.
#[inline(always)]
fn entries<T: FloatScalar, const N: usize>(x: &[T]) -> SVector<T, N> {
    match <[T; N]>::try_from(x) {
        Ok(entries) => entries.into(),
        Err(_) => panic!("a point of {} numbers for a map of {N} variables", x.len()),
    }
}

impl<M, T, const N: usize> TangentAt<M, T, N>
where
    M: Lift<T, N>,
    T: FloatScalar,
{
    /// What carries tangent vectors along a composition of the map, through all of its stages.
    pub fn composed(&self, composition: Composition) -> TangentAt<M, T, N, Composed> {
        TangentAt::new(&self.map, &self.eps, composition.stages_of(&self.eps, |eps| eps))
    }
}
