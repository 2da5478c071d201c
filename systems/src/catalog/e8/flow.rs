//! Trajectories of E8 by powers and logarithms of t.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use super::E8;
use crate::solution::{ReciprocalFlow, ReciprocalTrajectory};
use crate::special::Real;

/// A trajectory of E8 (Hone and Petrera, Table 5, i = 8). With T = t + α, β = y/x + ln|T| and L = β
/// − ln|T|, where α, β and γ are constants, the point at time t and the integral H are
///
///   x = 1/T, y = L/T, z = γT − L²/T, with H = x e^(−y/x) = ±e^(−β).
///
/// Absolute values extend the formula of the paper to x < 0. The trajectory ends at the pole;
/// beyond the pole, y and z are NaN.
pub type FlowSolution<T> = ReciprocalTrajectory<E8, T>;

impl<T: Real> ReciprocalFlow<T> for E8 {
    fn beta(x: T, y: T) -> T {
        y / x - x.abs().ln()
    }

    fn point(trajectory: &FlowSolution<T>, time: T) -> SVector<T, 3> {
        let FlowSolution { alpha, beta, gamma, .. } = trajectory;
        let slope = *beta - (time * alpha.sign()).ln();
        let x = T::one() / time;
        let y = slope * x;
        vector![x, y, *gamma * time - slope * y]
    }
}
