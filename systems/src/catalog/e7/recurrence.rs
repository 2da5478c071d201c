//! Orbits of the map of E7 by rational recurrences, exact over big rationals.

use kahan_core::nalgebra::SVector;
use kahan_core::{Scalar, vector};

use crate::solution::{OutOfDomain, integer, require};

/// An orbit of the map of E7 in the variables Y = y/x and Z = z/x (Hone and Petrera, Section 6).
/// With N = n + τ and x = 1/(2εN), the recurrences are
///
///   Y_{n+1} = Y_n (N + 1 − ξ/2)/(N + ξ/2), (N − 1/2) Z_{n+1} = (N + 3/2) Z_n + 2ξ Y_n Y_{n+1}.
#[derive(Clone, Debug, PartialEq)]
pub struct Recurrence<T> {
    /// Half the time step, ε.
    pub eps: T,
    /// The parameter ξ of the system.
    pub xi: T,
    /// The constant τ = 1/(2εx₀) in N = n + τ, where x₀ is x at n = 0.
    pub tau: T,
    /// The value Y₀ = y₀/x₀ at n = 0.
    pub slope_y: T,
    /// The value Z₀ = z₀/x₀ at n = 0.
    pub slope_z: T,
}

impl<T: Scalar> Recurrence<T> {
    /// Returns the orbit through `point` at n = 0. Fails if εx = 0.
    pub fn through(xi: &T, point: &SVector<T, 3>, eps: &T) -> Result<Self, OutOfDomain> {
        let [x, y, z] = point.clone().into();
        let scaled = eps.clone() * x.clone();
        require(!scaled.is_zero(), "eps x != 0")?;
        let tau = T::one() / (integer::<T>(2) * scaled);
        Ok(Self { eps: eps.clone(), xi: xi.clone(), tau, slope_y: y / x.clone(), slope_z: z / x })
    }

    /// Returns the point after n steps; n may be negative. The cost is |n| steps. At a pole on the
    /// way, exact scalars panic and floats become infinite or NaN.
    pub fn at(&self, n: i64) -> SVector<T, 3> {
        let half = T::one() / integer(2);
        let half_xi = self.xi.clone() * half.clone();
        let (mut y, mut z) = (self.slope_y.clone(), self.slope_z.clone());
        for j in if n < 0 { n..0 } else { 0..n } {
            // Backward steps invert the recurrence, and the last step comes first.
            let index = if n < 0 { n - 1 - j } else { j };
            let shifted = integer::<T>(index) + self.tau.clone();
            let top = shifted.clone() + T::one() - half_xi.clone();
            let bottom = shifted.clone() + half_xi.clone();
            let before = shifted.clone() - half.clone();
            let after = shifted + integer::<T>(3) * half.clone();
            let next = if n < 0 { y.clone() * bottom / top } else { y.clone() * top / bottom };
            let product = integer::<T>(2) * self.xi.clone() * y * next.clone();
            z = if n < 0 { (before * z - product) / after } else { (after * z + product) / before };
            y = next;
        }
        let x = T::one() / (integer::<T>(2) * self.eps.clone() * (integer::<T>(n) + self.tau.clone()));
        vector![x.clone(), y * x.clone(), z * x]
    }
}
