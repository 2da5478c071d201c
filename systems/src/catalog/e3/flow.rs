//! Trajectories of E3 by hyperbolic functions.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::{OutOfDomain, require};
use crate::special::Real;

/// A trajectory of E3 (Hone and Petrera, Table 5, i = 3). With T = t + α, the point at time t is
///
///   x = λ cos θ sech λT, y = λ sin θ sech λT, z = λ tanh λT.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowSolution<T> {
    /// The time shift α in T = t + α.
    pub alpha: T,
    /// The constant λ = √(x² + y² + z²) > 0. The integral K is λ²/2.
    pub lambda: T,
    /// The angle θ of the vector (x, y). The integral H is tan θ.
    pub theta: T,
}

impl<T: Real> FlowSolution<T> {
    /// Returns the trajectory through `point` at t = 0. Fails at the fixed points x = y = 0.
    pub fn through(point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        let [x, y, z] = (*point).into();
        let radius_square = x.square() + y.square();
        require(radius_square.is_positive(), "x^2 + y^2 > 0")?;
        let lambda = (radius_square + z.square()).sqrt();
        // At t = 0, sinh λα = z/r with r² = x² + y².
        Ok(Self { alpha: (z / radius_square.sqrt()).asinh() / lambda, theta: y.atan2(&x), lambda })
    }

    /// Returns the point at any real time t.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        let Self { alpha, lambda, theta } = self;
        let phase = *lambda * (*t + *alpha);
        let (sine, cosine) = theta.sin_cos();
        let radius = *lambda / phase.cosh();
        vector![radius * cosine, radius * sine, *lambda * phase.tanh()]
    }
}
