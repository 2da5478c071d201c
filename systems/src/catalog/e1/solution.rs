//! Orbits and trajectories of E1, which are rational functions of time.

use kahan_core::nalgebra::SVector;
use kahan_core::{Scalar, vector};

use super::E1;
use crate::solution::{ReciprocalFlow, ReciprocalMap, ReciprocalOrbit, ReciprocalTrajectory};

/// An orbit of the map of E1 (Hone and Petrera, Theorem 3, i = 1), exact over big rationals. With N
/// = n + τ and β = Ĥ = y/x, where β, γ and τ are constants, the point after n steps is
///
///   x = 1/(2εN), y = β/(2εN), z = 2γεN − (β²/ε + γε)/(2N).
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
pub type Solution<T> = ReciprocalOrbit<E1, T>;

impl<T: Scalar> ReciprocalMap<T> for E1 {
    fn integral(x: T, y: T, _: T) -> T {
        y / x
    }

    fn point(orbit: Solution<T>, double: T) -> SVector<T, 3> {
        let Solution { eps, beta, gamma, .. } = orbit;
        let x = T::one() / (eps.clone() * double.clone());
        let square = beta.clone() * beta.clone();
        let z = gamma.clone() * eps.clone() * double.clone() - (square / eps.clone() + gamma * eps) / double;
        vector![x.clone(), beta * x, z]
    }
}

/// A trajectory of E1 (Hone and Petrera, Table 5, i = 1), exact over big rationals. With T = t + α
/// and β = H = y/x, where α, β and γ are constants, the point at time t is
///
///   x = 1/T, y = β/T, z = γT − β²/T.
pub type FlowSolution<T> = ReciprocalTrajectory<E1, T>;

impl<T: Scalar> ReciprocalFlow<T> for E1 {
    fn beta(x: T, y: T) -> T {
        y / x
    }

    fn point(trajectory: &FlowSolution<T>, time: T) -> SVector<T, 3> {
        let FlowSolution { beta, gamma, .. } = trajectory.clone();
        let x = T::one() / time.clone();
        let y = beta.clone() * x.clone();
        vector![x, y.clone(), gamma * time - beta * y]
    }
}
