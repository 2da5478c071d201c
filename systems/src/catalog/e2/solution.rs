//! The orbits of dE2: rational functions of n.

use kahan_core::nalgebra::SVector;
use kahan_core::{Scalar, vector};

use crate::solution::{OutOfDomain, integer, shift_and_divisor};

/// An orbit of dE2 (Theorem 3, i = 2), exact over big rationals: with N = n + τ,
///
/// x = 1/(2εN), y = 2βε(N − 1/(4N)), z = ε(2N − 1/(2N))(γ − β²ε²(4N² − 1)).
#[derive(Clone, Debug, PartialEq)]
pub struct Solution<T> {
    /// ε, half the time step.
    pub eps: T,
    /// τ = 1/(2εx₀), the shift of n.
    pub tau: T,
    /// β, the value of the integral Ĥ = xy/(1 − ε²x²).
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
            beta: x.clone() * y.clone() / divisor.clone(),
            gamma: (x * z + y.clone() * y) / divisor,
        })
    }

    /// The point n steps on, or back for n < 0. At n = −τ the orbit has a pole: a panic for exact
    /// scalars, a result that is not finite for floats.
    pub fn at(&self, n: i64) -> SVector<T, 3> {
        let Self { eps, tau, beta, gamma } = self.clone();
        let double = integer::<T>(2) * (integer::<T>(n) + tau);
        let x = T::one() / (eps.clone() * double.clone());
        // 2N − 1/(2N)
        let spread = double.clone() - T::one() / double.clone();
        let y = beta.clone() * eps.clone() * spread.clone();
        let square = beta.clone() * eps.clone() * beta * eps.clone();
        let z = eps * spread * (gamma - square * (double.clone() * double - T::one()));
        vector![x, y, z]
    }
}
