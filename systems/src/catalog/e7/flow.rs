//! Trajectories of E7, by powers of t with exponents in ξ.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::{OutOfDomain, require};
use crate::special::Real;

/// A trajectory of E7 (Table 5, i = 7). With T = t + α:
///
///   x = 1/T, y = β|T|^(−ξ), z = T(γ − β²|T|^(−2ξ)).
///
/// The paper has T > 0; absolute values extend the formula to x < 0.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowSolution<T> {
    /// The parameter ξ of the system.
    pub xi: T,
    /// The time shift α = 1/x₀.
    pub alpha: T,
    /// β, the value of H = y|x|^(−ξ).
    pub beta: T,
    /// γ, the value of K = xz + y².
    pub gamma: T,
}

impl<T: Real> FlowSolution<T> {
    /// Returns the trajectory through `point` at t = 0. Fails if x = 0.
    pub fn through(xi: &T, point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        let [x, y, z] = (*point).into();
        require(!x.is_zero(), "x != 0")?;
        Ok(Self {
            xi: *xi,
            alpha: T::one() / x,
            beta: y * x.abs().power_real(&-*xi),
            gamma: x * z + y.square(),
        })
    }

    /// Returns the point at time t; NaN at the pole t = −α and beyond it.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        let Self { xi, alpha, beta, gamma } = self;
        let time = *t + *alpha;
        // Becomes negative beyond the pole, where most powers are undefined.
        let size = time * alpha.sign();
        let y = *beta * size.power_real(&-*xi);
        let x = T::one() / time;
        // Some exponents allow negative bases, so NaN is set explicitly beyond the pole.
        let defined = if size.is_positive() { T::one() } else { T::zero() / T::zero() };
        vector![x * defined, y * defined, time * (*gamma - y.square()) * defined]
    }
}
