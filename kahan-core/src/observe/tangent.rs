//! Maps that propagate tangent vectors, and the map of a point with its tangent vectors.

#[cfg(feature = "std")]
use std::vec::Vec;

use core::array::from_fn;

use nalgebra::{SMatrix, SVector};

use crate::composition::{Composed, Staged};
#[cfg(feature = "std")]
use crate::ensemble::columns::GROUP;
use crate::field::linear::{determinant, vector};
use crate::map::{push_forward, push_forward_to};
use crate::step::check_length;
#[cfg(feature = "std")]
use crate::{EnsembleScalar, KahanMap, PreparedStep, StateVector, Stopped, Workspace};
use crate::{ExtendScalars, FloatScalar, KahanAt, Scalar, Step};

#[cfg(feature = "std")]
use super::{Grouped, SideBySide, lanes::ByOneMap};

/// A map that also propagates tangent vectors, v ↦ J(x)·v with J = ∂x̃/∂x.
///
/// Prepared maps, their compositions, maps read at run time, and references implement this trait.
///
/// # Panics
/// The methods panic if the length of a slice is not the number of variables.
#[diagnostic::on_unimplemented(
    message = "`{Self}` carries no tangent vectors along",
    label = "not a prepared map of `kahan!`, a composition of one, or a map that is read at run time",
    note = "observers of derivatives take the map itself, `Lyapunov::new(&map)`, as it is without rounding errors or vectors beside its points; chains carry none"
)]
pub trait TangentMap: Step<Scalar: FloatScalar> + Clone {
    /// Replaces the tangent vector `v` at `x` by J(x)·v, where J is the derivative of a step.
    fn push_forward(&self, x: &[Self::Scalar], v: &mut Self::State);

    /// Replaces `v` by J(x)·v as [`push_forward`](Self::push_forward) does. Implementations that
    /// use the next state `_next` need half the work.
    #[inline(always)]
    fn push_forward_to(&self, x: &[Self::Scalar], _next: &[Self::Scalar], v: &mut Self::State) {
        self.push_forward(x, v);
    }

    /// Returns det J(x), where J is the derivative of a step.
    fn det_jacobian(&self, x: &[Self::Scalar]) -> Self::Scalar;

    /// Propagates the vectors of a group of trajectories in lanes. Writes squared lengths if `work`
    /// has room for them.
    ///
    /// Returns the number of steps taken. The propagation ends early if a vector needs scaling.
    /// Returns `None` if the trajectories have different maps, or if the step cannot run in lanes.
    #[cfg(feature = "std")]
    #[doc(hidden)]
    fn push_forward_group<P: Grouped<Self::Scalar>>(
        _maps: [&Self; GROUP],
        _work: SideBySide<'_, Self::Scalar, P>,
    ) -> Option<usize>
    where
        Self::Scalar: EnsembleScalar,
    {
        None
    }
}

impl<M: TangentMap> TangentMap for &M {
    #[inline(always)]
    fn push_forward(&self, x: &[M::Scalar], v: &mut M::State) {
        M::push_forward(self, x, v);
    }

    #[inline(always)]
    fn push_forward_to(&self, x: &[M::Scalar], next: &[M::Scalar], v: &mut M::State) {
        M::push_forward_to(self, x, next, v);
    }

    #[inline(always)]
    fn det_jacobian(&self, x: &[M::Scalar]) -> M::Scalar {
        M::det_jacobian(self, x)
    }

    #[cfg(feature = "std")]
    fn push_forward_group<P: Grouped<M::Scalar>>(
        maps: [&Self; GROUP],
        work: SideBySide<'_, M::Scalar, P>,
    ) -> Option<usize>
    where
        M::Scalar: EnsembleScalar,
    {
        M::push_forward_group(maps.map(|map| *map), work)
    }
}

// A macro, because `impl<S: Staged<T, N>> TangentMap for S` would not determine N.
macro_rules! implement_for_stages {
    ($map:ty) => {
        impl<M, T, const N: usize> TangentMap for $map
        where
            M: ExtendScalars<T, N>,
            T: FloatScalar,
        {
            #[inline(always)]
            fn push_forward(&self, x: &[T], v: &mut SVector<T, N>) {
                let stages = self.stages(|at| (&at.map, &at.eps));
                if let Some(carried) = push_forward(Self::in_order(&stages).copied(), &point(x), v) {
                    *v = carried;
                }
            }

            #[inline(always)]
            fn push_forward_to(&self, x: &[T], next: &[T], v: &mut SVector<T, N>) {
                let stages = self.stages(|at| (&at.map, &at.eps));
                if let Some(carried) =
                    push_forward_to(Self::in_order(&stages).copied(), &point(x), &point(next), v)
                {
                    *v = carried;
                }
            }

            #[inline]
            fn det_jacobian(&self, x: &[T]) -> T {
                let mut columns = [vector([T::zero(); N]); N];
                for (i, column) in columns.iter_mut().enumerate() {
                    column[i] = T::one();
                    self.push_forward(x, column);
                }
                determinant::<T, N>(SMatrix::from_fn(|i, j| columns[j][i]))
            }

            #[cfg(feature = "std")]
            fn push_forward_group<P: Grouped<T>>(
                maps: [&Self; GROUP],
                work: SideBySide<'_, T, P>,
            ) -> Option<usize>
            where
                T: EnsembleScalar,
            {
                // Lanes use one set of constants; therefore all trajectories must have one map.
                let are_one = maps.iter().all(|map| core::ptr::eq(*map, maps[0]));
                let has_lanes = <<M as KahanMap<T, N>>::Prepared as PreparedStep<_, N>>::HAS_LANES;
                let level = work.level;
                if are_one && has_lanes {
                    T::over_lanes(ByOneMap { map: maps[0], work }, level)
                } else {
                    None
                }
            }
        }
    };
}

implement_for_stages!(KahanAt<M, T, N>);
implement_for_stages!(Composed<KahanAt<M, T, N>>);

#[inline(always)]
fn point<T: FloatScalar, const N: usize>(x: &[T]) -> SVector<T, N> {
    check_length(x.len(), N);
    vector(from_fn(|i| x[i]))
}

/// A map on points with tangent vectors; see [`KahanAt::tangent`].
/// A state is a point of n numbers, followed by k tangent vectors of n numbers. The vectors are
/// neither scaled nor orthogonalised. A [part](Step::part) of a step changes only the point.
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_core::Orbit;
///
/// kahan! {
///     /// Predator and prey.
///     pub struct LotkaVolterra;
///     xdot = x*(1 - y);
///     ydot = y*(x - 1);
/// }
///
/// let map = LotkaVolterra.at(0.05);
/// let mut orbit = Orbit::new(map.tangent(), vec![1.5_f64, 1.0, 1.0, -2.0]);
/// let state = orbit.nth(1).unwrap();
/// let v = map.jacobian(&vector![1.5, 1.0]) * vector![1.0, -2.0];
/// assert!((state[2] - v[0]).abs() < 1e-15 && (state[3] - v[1]).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Tangent<S> {
    map: S,
    #[cfg_attr(not(feature = "std"), expect(dead_code, reason = "states of any length are vectors"))]
    vectors: usize,
}

impl<S> Tangent<S> {
    /// Creates the map on points with this number of tangent vectors.
    pub const fn new(map: S, vectors: usize) -> Self {
        Self { map, vectors }
    }
}

impl<M, T, const N: usize> KahanAt<M, T, N>
where
    M: ExtendScalars<T, N>,
    T: Scalar,
{
    /// Returns the map on points with one tangent vector v, which becomes J(x)·v with J = ∂x̃/∂x.
    ///
    /// ```
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// Predator and prey.
    ///     pub struct LotkaVolterra;
    ///     xdot = x*(1 - y);
    ///     ydot = y*(x - 1);
    /// }
    ///
    /// let map = LotkaVolterra.at(0.05);
    /// let (x, v) = (vector![1.5, 1.0], vector![1.0, -2.0]);
    /// let carried = map.tangent().push_forward(&x, &v).unwrap();
    /// assert!((carried - map.jacobian(&x) * v).norm() < 1e-15);
    /// ```
    pub fn tangent(&self) -> Tangent<Self> {
        Tangent::new(self.clone(), 1)
    }
}

impl<M, T, const N: usize> Tangent<KahanAt<M, T, N>>
where
    M: ExtendScalars<T, N>,
    T: Scalar,
{
    /// Returns J(x)·v with J = ∂x̃/∂x, or `None` at a pole of an exact scalar.
    #[inline(always)]
    pub fn push_forward(&self, x: &SVector<T, N>, v: &SVector<T, N>) -> Option<SVector<T, N>> {
        push_forward([(&self.map.map, &self.map.eps)].into_iter(), x, v)
    }

    /// Returns J(x)·v as [`push_forward`](Self::push_forward) does. The known next state halves the
    /// work.
    #[inline(always)]
    pub fn push_forward_to(
        &self,
        x: &SVector<T, N>,
        next: &SVector<T, N>,
        v: &SVector<T, N>,
    ) -> Option<SVector<T, N>> {
        push_forward_to([(&self.map.map, &self.map.eps)].into_iter(), x, next, v)
    }
}

#[cfg(feature = "std")]
impl<S: TangentMap> Step for Tangent<S> {
    type Scalar = S::Scalar;
    type State = Vec<S::Scalar>;

    fn dimension(&self) -> usize {
        (1 + self.vectors) * self.map.dimension()
    }

    fn eps(&self) -> &S::Scalar {
        self.map.eps()
    }

    fn advance(&self, x: &mut [S::Scalar], steps: u64, workspace: &mut Workspace) -> Result<(), Stopped> {
        check_length(x.len(), self.dimension());
        let (point, vectors) = x.split_at_mut(self.map.dimension());
        let (mut before, mut v) = (S::State::zeros(point.len()), S::State::zeros(point.len()));
        for steps in 0..steps {
            before.as_mut_slice().copy_from_slice(point);
            self.map.advance(point, 1, workspace).map_err(|stopped| Stopped { steps, ..stopped })?;
            for vector in vectors.chunks_exact_mut(point.len()) {
                v.as_mut_slice().copy_from_slice(vector);
                self.map.push_forward_to(before.as_slice(), point, &mut v);
                vector.copy_from_slice(v.as_slice());
            }
        }
        Ok(())
    }

    fn part(&self, eps: &S::Scalar, x: &mut [S::Scalar], workspace: &mut Workspace) -> Result<(), Stopped> {
        self.map.part(eps, &mut x[..self.map.dimension()], workspace)
    }
}
