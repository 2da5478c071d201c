//! The trajectories of E8: powers and logarithms of t.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::{OutOfDomain, require};
use crate::special::Real;

/// A trajectory of E8 (Table 5, i = 8): with T = t + α and L = β − ln|T|, x = 1/T, y = L/T, z = γT
/// − L²/T.
///
/// The paper has T > 0; the absolute value extends it to x < 0.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowSolution<T> {
    /// α = 1/x₀, the shift of time.
    pub alpha: T,
    /// β = y/x + ln|T|, constant; H = x e^(−y/x) = ±e^(−β).
    pub beta: T,
    /// γ, the value of K = xz + y².
    pub gamma: T,
}

impl<T: Real> FlowSolution<T> {
    /// The trajectory with this point at t = 0.
    ///
    /// # Errors
    /// Unless x ≠ 0.
    pub fn through(point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        let [x, y, z] = point.clone().into();
        require(!x.is_zero(), "x != 0")?;
        Ok(Self {
            alpha: T::one() / x.clone(),
            beta: y.clone() / x.clone() - x.abs().ln(),
            gamma: x * z + y.square(),
        })
    }

    /// The point at time t; not a number at the pole t = −α and beyond it (but for x), where no
    /// trajectory leads.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        let Self { alpha, beta, gamma } = self;
        let time = t.clone() + alpha.clone();
        let slope = beta.clone() - (time.clone() * alpha.sign()).ln();
        let x = T::one() / time.clone();
        let y = slope.clone() * x.clone();
        vector![x, y.clone(), gamma.clone() * time - slope * y]
    }
}
