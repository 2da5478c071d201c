//! The trajectories of E7: powers of t with the exponent ξ.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::{OutOfDomain, require};
use crate::special::Real;

/// A trajectory of E7 (Table 5, i = 7): with T = t + α, x = 1/T, y = β|T|^(−ξ), z = T(γ −
/// β²|T|^(−2ξ)).
///
/// The paper has T > 0; the absolute value extends it to x < 0.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowSolution<T> {
    /// ξ, the parameter of the system.
    pub xi: T,
    /// α = 1/x₀, the shift of time.
    pub alpha: T,
    /// β, the value of H = y|x|^(−ξ).
    pub beta: T,
    /// γ, the value of K = xz + y².
    pub gamma: T,
}

impl<T: Real> FlowSolution<T> {
    /// The trajectory of E7 with this ξ that has this point at t = 0.
    ///
    /// # Errors
    /// Unless x ≠ 0.
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

    /// The point at time t; not a number at the pole t = −α and beyond it, where no trajectory
    /// leads.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        let Self { xi, alpha, beta, gamma } = self;
        let time = *t + *alpha;
        // Negative beyond the pole, so that the power has no value there.
        let size = time * alpha.sign();
        let y = *beta * size.power_real(&-*xi);
        let x = T::one() / time;
        // A base that is not positive has a value for some exponents; beyond the pole there is none
        // to give.
        let defined = if size.is_positive() { T::one() } else { T::zero() / T::zero() };
        vector![x * defined, y * defined, time * (*gamma - y.square()) * defined]
    }
}
