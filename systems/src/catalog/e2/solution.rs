//! Orbits and trajectories of E2, which are rational functions of time.

use kahan_core::nalgebra::SVector;
use kahan_core::{Scalar, vector};

use super::E2;
use crate::solution::{ReciprocalFlow, ReciprocalMap, ReciprocalOrbit, ReciprocalTrajectory};

/// An orbit of the map of E2 (Hone and Petrera, Theorem 3, i = 2), exact over big rationals. With
/// N = n + τ and β = Ĥ = xy/(1 − ε²x²), where β, γ and τ are constants, the point after n steps is
///
///   x = 1/(2εN), y = 2βε(N − 1/(4N)), z = ε(2N − 1/(2N))(γ − β²ε²(4N² − 1)).
pub type Solution<T> = ReciprocalOrbit<E2, T>;

impl<T: Scalar> ReciprocalMap<T> for E2 {
    fn integral(x: T, y: T, divisor: T) -> T {
        x * y / divisor
    }

    fn point(orbit: Solution<T>, double: T) -> SVector<T, 3> {
        let Solution { eps, beta, gamma, .. } = orbit;
        let x = T::one() / (eps.clone() * double.clone());
        // The variable `spread` is 2N − 1/(2N).
        let spread = double.clone() - T::one() / double.clone();
        let y = beta.clone() * eps.clone() * spread.clone();
        let square = beta.clone() * eps.clone() * beta * eps.clone();
        let z = eps * spread * (gamma - square * (double.clone() * double - T::one()));
        vector![x, y, z]
    }
}

/// A trajectory of E2 (Hone and Petrera, Table 5, i = 2), exact over big rationals. With T = t + α
/// and β = H = xy, where α, β and γ are constants, the point at time t is
///
///   x = 1/T, y = βT, z = T(γ − β²T²).
pub type FlowSolution<T> = ReciprocalTrajectory<E2, T>;

impl<T: Scalar> ReciprocalFlow<T> for E2 {
    fn beta(x: T, y: T) -> T {
        x * y
    }

    fn point(trajectory: &FlowSolution<T>, time: T) -> SVector<T, 3> {
        let FlowSolution { beta, gamma, .. } = trajectory.clone();
        let y = beta * time.clone();
        vector![T::one() / time.clone(), y.clone(), time * (gamma - y.clone() * y)]
    }
}
