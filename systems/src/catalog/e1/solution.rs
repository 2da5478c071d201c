//! The orbits of dE1: rational functions of n.

use kahan_core::nalgebra::SVector;
use kahan_core::{Scalar, vector};

use crate::solution::{OutOfDomain, integer, shift_and_divisor};

/// An orbit of dE1 (Theorem 3, i = 1), exact over big rationals: with N = n + τ,
///
/// x = 1/(2εN), y = β/(2εN), z = 2γεN − (β²/ε + γε)/(2N).
///
/// ```
/// use kahan_core::prelude::*;
/// use kahan_systems::{E1, e1};
///
/// let (start, eps) = (vector![0.5, 1.0, -0.25], 0.125);
/// let solution = e1::Solution::through(&start, &eps).unwrap();
/// let third = E1.orbit(start, eps).nth(3).unwrap();
/// assert!((solution.at(3) - third).norm() < 1e-15);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Solution<T> {
    /// ε, half the time step.
    pub eps: T,
    /// τ = 1/(2εx₀), the shift of n.
    pub tau: T,
    /// β, the value of the integral Ĥ = y/x.
    pub beta: T,
    /// γ, the value of the integral K̂ = (xz + y²)/(1 − ε²x²).
    pub gamma: T,
}

impl<T: Scalar> Solution<T> {
    /// The orbit with this point at n = 0; ε is half the time step.
    ///
    /// # Errors
    /// Unless εx ≠ 0 and ε²x² ≠ 1.
    pub fn through(point: &SVector<T, 3>, eps: &T) -> Result<Self, OutOfDomain> {
        let [x, y, z] = point.clone().into();
        let (tau, divisor) = shift_and_divisor(&x, eps)?;
        Ok(Self {
            eps: eps.clone(),
            tau,
            beta: y.clone() / x.clone(),
            gamma: (x * z + y.clone() * y) / divisor,
        })
    }

    /// The point n steps on, or back for n < 0. At n = −τ the orbit has a pole: a panic for exact
    /// scalars, a result that is not finite for floats.
    pub fn at(&self, n: i64) -> SVector<T, 3> {
        let Self { eps, tau, beta, gamma } = self.clone();
        let shifted = integer::<T>(n) + tau;
        let double = integer::<T>(2) * shifted;
        let x = T::one() / (eps.clone() * double.clone());
        let square = beta.clone() * beta.clone();
        let z = gamma.clone() * eps.clone() * double.clone() - (square / eps.clone() + gamma * eps) / double;
        vector![x.clone(), beta * x, z]
    }
}
