//! Orbits of the map of E3 by hyperbolic functions, on two real branches.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::{Branch, OutOfDomain, alternating, require};
use crate::special::Real;

/// An orbit of the map of E3 (Hone and Petrera, Theorem 3, i = 3). With T = 2δn + κ, the point
/// after n steps is
///
/// * on the inner branch, |εz| < 1: (x, y) = (cos θ, sin θ) sinh δ/(ε cosh T), z = tanh δ tanh T/ε,
///   where the integral K̂ is tanh² δ/(2ε²);
/// * on the outer branch, |εz| > 1 (not in the paper): (x, y) = (−1)ⁿ (cos θ, sin θ) cosh δ/(ε sinh
///   T), z = coth δ coth T/ε, where the integral K̂ is coth² δ/(2ε²).
///
/// On both branches the integral Ĥ is tan θ, and δ has the sign of ε. In `f64` the error is at most
/// 4 ulp of the point's norm r, multiplied by the condition number (1 + |T|) max(1, |ε|r).
#[derive(Clone, Debug, PartialEq)]
pub struct Solution<T> {
    /// Half the time step, ε.
    pub eps: T,
    /// The constant δ in T = 2δn + κ.
    pub delta: T,
    /// The constant κ in T = 2δn + κ.
    pub kappa: T,
    /// The angle θ of (x, y) at n = 0, or of −(x, y) on the outer branch if εz < 0.
    pub theta: T,
    /// The branch: inner if |εz| < 1, outer if |εz| > 1.
    pub branch: Branch,
}

impl<T: Real> Solution<T> {
    /// Returns the orbit through `point` at n = 0. Fails if ε = 0, if x² + y² = 0 (a fixed point)
    /// or if ε²z² = 1 (det A = 0, or the next point is fixed).
    pub fn through(point: &SVector<T, 3>, eps: &T) -> Result<Self, OutOfDomain> {
        let [x, y, z] = (*point).into();
        let radius_square = x.square() + y.square();
        require(!eps.is_zero(), "eps != 0")?;
        require(radius_square.is_positive(), "x^2 + y^2 > 0")?;
        let scaled = *eps * z;
        // 1 − ε²z² without cancellation.
        let inner = (T::one() - scaled) * (T::one() + scaled);
        require(!inner.is_zero(), "eps^2 z^2 != 1")?;
        let width = inner.abs().sqrt();
        let norm = (radius_square + z.square()).sqrt();
        let radius = radius_square.sqrt();
        let stretched = (T::one() + eps.square() * radius_square).sqrt();
        let eps = *eps;
        Ok(if inner.is_positive() {
            Self {
                // With r² = x² + y², R² = r² + z² and w = 1 − ε²z²: sinh²δ = ε²R²/w, sinh²κ =
                // z²(1 + ε²r²)/(r²w).
                delta: (eps * norm / width).asinh(),
                kappa: (z * stretched / (radius * width)).asinh(),
                theta: y.atan2(&x),
                branch: Branch::Inner,
                eps,
            }
        } else {
            let sign = (eps * z).sign();
            Self {
                // With r² = x² + y² and R² = r² + z², sinh²δ = (1 + ε²r²)/(ε²z² − 1) and sinh²κ =
                // R²/(r²(ε²z² − 1)).
                delta: (eps.sign() * stretched / width).asinh(),
                kappa: (z.sign() * norm / (radius * width)).asinh(),
                theta: (sign * y).atan2(&(sign * x)),
                branch: Branch::Outer,
                eps,
            }
        })
    }

    /// Returns the point after n steps; n may be negative. The point is not finite at a pole.
    pub fn at(&self, n: i64) -> SVector<T, 3> {
        let Self { eps, delta, kappa, theta, branch } = self;
        let argument = T::from_int(2 * n) * *delta + *kappa;
        let (sine_delta, cosine_delta) = delta.sinh_cosh();
        let (sine, cosine) = theta.sin_cos();
        let product = delta.tanh() * argument.tanh();
        let (radius, height) = match branch {
            Branch::Inner => (sine_delta / argument.cosh(), product),
            Branch::Outer => (alternating::<T>(n) * cosine_delta / argument.sinh(), T::one() / product),
        };
        let radius = radius / *eps;
        vector![radius * cosine, radius * sine, height / *eps]
    }
}
