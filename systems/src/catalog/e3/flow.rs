//! The trajectories of E3: hyperbolic functions.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::{OutOfDomain, require};
use crate::special::Real;

/// A trajectory of E3 (Table 5, i = 3): x = λ cos θ sech λT, y = λ sin θ sech λT, z = λ tanh λT
/// with T = t + α.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowSolution<T> {
    /// α, the shift of time.
    pub alpha: T,
    /// λ = √(x² + y² + z²) > 0; K = λ²/2.
    pub lambda: T,
    /// θ, the angle of (x, y); H = tan θ.
    pub theta: T,
}

impl<T: Real> FlowSolution<T> {
    /// The trajectory with this point at t = 0.
    ///
    /// # Errors
    /// Unless x² + y² > 0: a point (0, 0, z) is a fixed point.
    pub fn through(point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        let [x, y, z] = (*point).into();
        let radius_square = x.square() + y.square();
        require(radius_square.is_positive(), "x^2 + y^2 > 0")?;
        let lambda = (radius_square + z.square()).sqrt();
        // sinh λα = z/r
        Ok(Self { alpha: (z / radius_square.sqrt()).asinh() / lambda, theta: y.atan2(&x), lambda })
    }

    /// The point at time t, any real number.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        let Self { alpha, lambda, theta } = self;
        let phase = *lambda * (*t + *alpha);
        let (sine, cosine) = theta.sin_cos();
        let radius = *lambda / phase.cosh();
        vector![radius * cosine, radius * sine, *lambda * phase.tanh()]
    }
}
