//! Trajectories of E5 by hyperbolic functions.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::{OutOfDomain, require};
use crate::special::Real;

/// A trajectory of E5 (Hone and Petrera, Table 5, i = 5). With T = t + α and the sign s of x, the
/// point at time t is
///
///   x = sλ sech λT, y = −λ tanh λT, z = s(μ cosh λT + λ sech λT).
#[derive(Clone, Debug, PartialEq)]
pub struct FlowSolution<T> {
    /// The time shift α in T = t + α.
    pub alpha: T,
    /// The constant λ = √(x² + y²) > 0. The integral H is λ²/2.
    pub lambda: T,
    /// The constant μ. The integral K is λ(μ + λ).
    pub mu: T,
    /// The sign s = ±1 of x. Table 5 has s = 1, but (x, y, z) → (−x, y, −z) is a symmetry.
    pub sign: T,
}

impl<T: Real> FlowSolution<T> {
    /// Returns the trajectory through `point` at t = 0. Fails in the invariant plane x = 0.
    pub fn through(point: &SVector<T, 3>) -> Result<Self, OutOfDomain> {
        let [x, y, z] = (*point).into();
        require(!x.is_zero(), "x != 0")?;
        let sign = x.sign();
        let lambda = (x.square() + y.square()).sqrt();
        // At t = 0, sinh λα = −y/|x| and cosh λα = λ/|x|.
        let phase = -(y / x.abs()).asinh();
        let mu = sign * (z - x) * x.abs() / lambda;
        Ok(Self { alpha: phase / lambda, lambda, mu, sign })
    }

    /// Returns the point at any real time t.
    pub fn at(&self, t: &T) -> SVector<T, 3> {
        let Self { alpha, lambda, mu, sign } = self;
        let phase = *lambda * (*t + *alpha);
        let cosine = phase.cosh();
        let x = *sign * *lambda / cosine;
        vector![x, -*lambda * phase.tanh(), *sign * *mu * cosine + x]
    }
}
