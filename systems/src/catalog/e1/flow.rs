//! The trajectories of E1: rational functions of t.

use kahan_core::nalgebra::SVector;
use kahan_core::{Scalar, vector};

use crate::solution::{OutOfDomain, require};

/// A trajectory of E1 (Table 5, i = 1), exact over big rationals: with T = t + α, x = 1/T, y = β/T,
/// z = γT − β²/T.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowSolution<T> {
    /// α = 1/x₀, the shift of time.
    pub alpha: T,
    /// β, the value of H = y/x.
    pub beta: T,
    /// γ, the value of K = xz + y².
    pub gamma: T,
}

impl<T: Scalar> FlowSolution<T> {
    /// The trajectory with this point at t = 0.
    ///
    /// # Errors
    /// Unless x ≠ 0.
    pub fn through(point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        let [x, y, z] = point.clone().into();
        require(!x.is_zero(), "x != 0")?;
        Ok(Self { alpha: T::one() / x.clone(), beta: y.clone() / x.clone(), gamma: x * z + y.clone() * y })
    }

    /// The point at time t. At t = −α the trajectory has a pole: a panic for exact scalars, a
    /// result that is not finite for floats; beyond it the formula continues analytically.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        let Self { alpha, beta, gamma } = self.clone();
        let time = t.clone() + alpha;
        let x = T::one() / time.clone();
        let y = beta.clone() * x.clone();
        vector![x, y.clone(), gamma * time - beta * y]
    }
}
