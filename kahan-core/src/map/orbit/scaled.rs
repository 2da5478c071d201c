//! Orbits of homogeneous quadratic fields, computed in variables X = εx whose map is free of ε.

use core::array::from_fn;

use crate::field::linear::vector;
use crate::{FloatScalar, KahanAt, KahanMap, PointOf, StateVector, Step};

use super::{Compensated, Increments, Orbit};

/// The orbit of a homogeneous field f in scaled variables; see [`Orbit::scaled`].
///
/// The map of a homogeneous f has the symmetry (x, ε) ↦ (λx, ε/λ). Hence the scaled variable X = εx
/// is stepped at ε = 1, and x = X/ε is yielded.
#[derive(Clone, Debug)]
#[must_use = "an orbit computes nothing until it is iterated"]
pub struct Scaled<S: Step> {
    orbit: Orbit<S>,
    eps: S::Scalar,
}

impl<M: KahanMap<T, N>, T: FloatScalar, const N: usize> Orbit<KahanAt<M, T, N>> {
    /// Continues this orbit in variables scaled by ε. Returns `None` if the field has linear or
    /// constant terms, or coefficients that depend on ε.
    ///
    /// Scaling helps in long runs if powers of ε round badly and no [short
    /// ε](crate::nearest_short_eps) is possible. Each yielded point has two more roundings, which
    /// do not accumulate. The cost is one division per component.
    ///
    /// ```
    /// use kahan_core::prelude::*;
    ///
    /// kahan! {
    ///     /// A free rigid body.
    ///     pub struct Top;
    ///     xdot = y*z;
    ///     ydot = -2*z*x;
    ///     zdot = x*y;
    /// }
    ///
    /// let start = vector![0.5, 1.0, 0.25];
    /// let x = Top.orbit(start, 0.05).scaled().unwrap().compensated().nth(1000).unwrap();
    /// let same = Top.orbit(start, 0.05).compensated().nth(1000).unwrap();
    /// assert!((x - same).amax() < 1e-13);
    /// ```
    pub fn scaled(self) -> Option<Scaled<KahanAt<M, T, N>>> {
        let KahanAt { map, eps, .. } = &self.map;
        let origin = vector(from_fn(|_| T::zero()));
        let is_zero = |entry: &T| entry.is_zero();
        let is_homogeneous =
            map.field(&origin).iter().all(is_zero) && map.field_jacobian(&origin).iter().all(is_zero);
        if map.has_coefficients_of_eps() || !is_homogeneous {
            return None;
        }
        let eps = *eps;
        let orbit = self.with_map(|at| at.map.at(T::one()), |state| state.map(|entry| eps * entry));
        Some(Scaled { orbit, eps })
    }
}

impl<S: Step<Scalar: FloatScalar>> Scaled<S> {
    /// Returns ε, half the time step between yielded points.
    pub fn eps(&self) -> S::Scalar {
        self.eps
    }

    /// Returns the orbit of X = εx at ε = 1, for example to evaluate integrals at its points.
    pub fn into_inner(self) -> Orbit<S> {
        self.orbit
    }

    /// Adds compensated summation; see [`Orbit::compensated`].
    pub fn compensated(self) -> Scaled<Compensated<S>>
    where
        S: Increments,
    {
        Scaled { orbit: self.orbit.compensated(), eps: self.eps }
    }
}

impl<S: Step<Scalar: FloatScalar>> Iterator for Scaled<S> {
    type Item = PointOf<S>;

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        self.nth(0)
    }

    #[inline]
    fn nth(&mut self, n: usize) -> Option<Self::Item> {
        let mut point = self.orbit.nth(n)?;
        for entry in point.as_mut_slice() {
            *entry /= self.eps;
        }
        Some(point)
    }
}
