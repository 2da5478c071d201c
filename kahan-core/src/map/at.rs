//! A map prepared at a fixed ε.
//!
//! Steps take only a state. Over floats `step` neither allocates nor dispatches; `try_step` may
//! allocate.

use core::fmt;

use nalgebra::{SMatrix, SVector};

use crate::step::advance_by;
use crate::step::error::pole;
use crate::{PreparedStep, Scalar, SingularStep, Step, Stopped, Workspace};

use super::{KahanMap, Orbit, Pivot};

/// The Kahan map M at one fixed ε, half the time step; see [`KahanMap::at`].
///
/// Everything that depends only on ε and the parameters is computed once. The type can be named,
/// for example in a field:
///
/// ```
/// use kahan_core::KahanAt;
/// use kahan_core::prelude::*;
///
/// kahan! {
///     /// Predator and prey, at any rate of change.
///     pub struct Prey { rate }
///     xdot = rate*x*(1 - y);
///     ydot = rate*y*(x - 1);
/// }
///
/// struct Pond {
///     map: KahanAt<Prey<f64>, f64, 2>,
///     state: SVector<f64, 2>,
/// }
///
/// let mut pond = Pond { map: Prey { rate: 0.5 }.at(0.125), state: vector![1.5, 1.0] };
/// for _ in 0..100 {
///     pond.state = pond.map.step(&pond.state);
/// }
/// assert!(pond.state.iter().all(|entry| *entry > 0.0));
/// ```
#[derive(Clone, Copy)]
pub struct KahanAt<M: KahanMap<T, N>, T: Scalar, const N: usize> {
    pub(crate) map: M,
    pub(crate) eps: T,
    pub(crate) prepared: M::Prepared,
}

impl<M: KahanMap<T, N>, T: Scalar, const N: usize> KahanAt<M, T, N> {
    #[inline]
    pub(crate) fn new(map: M, eps: T) -> Self {
        let prepared = map.prepare(&eps);
        Self { map, eps, prepared }
    }

    /// Returns the map M.
    pub fn map(&self) -> &M {
        &self.map
    }

    /// Returns ε, half the time step.
    pub fn eps(&self) -> &T {
        &self.eps
    }

    /// Returns the orbit that starts at `x`. The orbit owns a copy of the prepared step.
    #[inline]
    pub fn orbit(&self, x: SVector<T, N>) -> Orbit<Self> {
        Orbit::new(self.clone(), x)
    }

    /// Returns the prepared step, for callers that add the increment to the state themselves.
    pub fn prepared(&self) -> &M::Prepared {
        &self.prepared
    }

    /// Returns x̃, the state after one step, with the bits of [`KahanMap::step`].
    ///
    /// # Panics
    /// If the scalar is exact and `x` is a pole.
    #[inline]
    pub fn step(&self, x: &SVector<T, N>) -> SVector<T, N> {
        match self.prepared.next(x) {
            Some(next) => next,
            None => pole(&self.eps),
        }
    }

    /// Returns x̃ with an error bound, or the reason for failure; see [`KahanMap::try_step`].
    ///
    /// # Errors
    /// Returns the errors of [`KahanMap::try_step`].
    #[inline(always)]
    pub fn try_step(&self, x: &SVector<T, N>) -> Result<SVector<T, N>, SingularStep>
    where
        T: Pivot,
    {
        self.map.try_prepared(&self.prepared, x, &self.eps)
    }

    /// Returns the derivative ∂x̃/∂x of the next state by the state; see [`KahanMap::jacobian`].
    ///
    /// # Panics
    /// If the scalar is exact and `x` is a pole.
    pub fn jacobian(&self, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        self.map.jacobian(x, self.eps.clone())
    }
}

impl<M: KahanMap<T, N>, T: Scalar, const N: usize> Step for KahanAt<M, T, N> {
    type Scalar = T;
    type State = SVector<T, N>;

    fn dimension(&self) -> usize {
        N
    }

    fn eps(&self) -> &T {
        &self.eps
    }

    #[inline]
    fn advance(&self, x: &mut [T], steps: u64, _workspace: &mut Workspace) -> Result<(), Stopped> {
        advance_by(x, steps, &self.eps, |state| self.prepared.next(state))
    }

    fn part(&self, eps: &T, x: &mut [T], workspace: &mut Workspace) -> Result<(), Stopped> {
        Self::new(self.map.clone(), eps.clone()).advance(x, 1, workspace)
    }

    #[inline(always)]
    fn next(&self, x: &SVector<T, N>, _workspace: &mut Workspace) -> Option<SVector<T, N>> {
        self.prepared.next(x)
    }
}

impl<M: KahanMap<T, N> + PartialEq, T: Scalar, const N: usize> PartialEq for KahanAt<M, T, N> {
    fn eq(&self, other: &Self) -> bool {
        self.map == other.map && self.eps == other.eps
    }
}

impl<M: KahanMap<T, N> + fmt::Debug, T: Scalar, const N: usize> fmt::Debug for KahanAt<M, T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("KahanAt").field("map", &self.map).field("eps", &self.eps).finish_non_exhaustive()
    }
}
