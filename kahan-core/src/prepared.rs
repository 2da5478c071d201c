//! A map at a fixed ε.
//!
//! In: a map and ε, once. Out: steps that take a state only.
//! It owns both, borrows nothing, allocates nothing and holds no `dyn`.

use nalgebra::{SMatrix, SVector};

use crate::{KahanMap, Orbit, Pivot, Scalar, SingularStep};

/// The Kahan map M at one ε, half the time step; made by [`KahanMap::at`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KahanAt<M, T, const N: usize> {
    map: M,
    eps: T,
}

impl<M, T, const N: usize> KahanAt<M, T, N>
where
    M: KahanMap<T, N>,
    T: Scalar,
{
    pub(crate) fn new(map: M, eps: T) -> Self {
        Self { map, eps }
    }

    /// The map.
    pub fn map(&self) -> &M {
        &self.map
    }

    /// ε, half the time step.
    pub fn eps(&self) -> &T {
        &self.eps
    }

    /// x̃, as [`KahanMap::step`].
    ///
    /// # Panics
    /// At a pole, for exact scalars.
    #[inline]
    pub fn step(&self, x: &SVector<T, N>) -> SVector<T, N> {
        self.map.step(x, self.eps.clone())
    }

    /// x̃ or why there is none, as [`KahanMap::try_step`].
    ///
    /// # Errors
    /// [`SingularStep`] at a pole, at a point that is not finite, and beyond the scalar's range.
    pub fn try_step(&self, x: &SVector<T, N>) -> Result<SVector<T, N>, SingularStep>
    where
        T: Pivot,
    {
        self.map.try_step(x, self.eps.clone())
    }

    /// ∂x̃/∂x, as [`KahanMap::jacobian`].
    ///
    /// # Panics
    /// At a pole, for exact scalars.
    pub fn jacobian(&self, x: &SVector<T, N>) -> SMatrix<T, N, N> {
        self.map.jacobian(x, self.eps.clone())
    }

    /// The orbit that begins with `x`; it owns a copy of the map.
    pub fn orbit(&self, x: SVector<T, N>) -> Orbit<M, T, N>
    where
        M: Clone,
    {
        Orbit::new(self.map.clone(), x, self.eps.clone())
    }
}
