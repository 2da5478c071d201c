//! Trajectories of E7 by powers of t, whose exponents contain ξ.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::{OutOfDomain, require};
use crate::special::Real;

/// A trajectory of E7 (Hone and Petrera, Table 5, i = 7). With T = t + α, the point at time t is
///
///   x = 1/T, y = β|T|^(−ξ), z = T(γ − β²|T|^(−2ξ)).
///
/// The formula of the paper requires T > 0. Absolute values extend the formula to x < 0.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowSolution<T> {
    /// The parameter ξ of the system.
    pub xi: T,
    /// The time shift α = 1/x₀, where x₀ is x at t = 0.
    pub alpha: T,
    /// The value β of the integral H = y|x|^(−ξ).
    pub beta: T,
    /// The value γ of the integral K = xz + y².
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

    /// Returns the point at time t. At the pole t = −α and beyond, the point is NaN.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        let Self { xi, alpha, beta, gamma } = self;
        let time = *t + *alpha;
        let size = time * alpha.sign();
        let y = *beta * size.power_real(&-*xi);
        let x = T::one() / time;
        // Beyond the pole, `size` is negative. This factor then makes the point NaN for every ξ.
        let defined = if size.is_positive() { T::one() } else { T::zero() / T::zero() };
        vector![x * defined, y * defined, time * (*gamma - y.square()) * defined]
    }
}
