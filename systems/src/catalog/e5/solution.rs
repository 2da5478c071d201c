//! Orbits of the map of E5 by hyperbolic functions, on two real branches.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::{Branch, OutOfDomain, alternating, require};
use crate::special::Real;

/// An orbit of the map of E5 (Hone and Petrera, Theorem 3, i = 5). With T = 2δn + κ and a sign s,
/// the point after n steps and the integrals Ĥ and K̂ are
///
/// * on the inner branch, |εy| < 1: x = s sinh δ/(ε cosh T), y = −tanh δ tanh T/ε, z = s[μ cosh T +
///   (1/ε + μ sinh δ) sinh δ/cosh T], with Ĥ = tanh² δ/(2ε²), K̂ = μ sinh δ/ε + tanh² δ/ε²;
/// * on the outer branch, |εy| > 1 (not in the paper): x = s(−1)ⁿ cosh δ/(ε sinh T), y = −coth δ
///   coth T/ε, z = s(−1)ⁿ[μ sinh T + (1/ε + μ cosh δ) cosh δ/sinh T], with Ĥ = coth² δ/(2ε²), K̂ =
///   μ cosh δ/ε + coth² δ/ε².
///
/// The constant δ has the sign of ε. In `f64` the error is at most 4 ulp of the point's norm r,
/// multiplied by the condition number (1 + |T|) max(1, |ε|r).
#[derive(Clone, Debug, PartialEq)]
pub struct Solution<T> {
    /// Half the time step, ε.
    pub eps: T,
    /// The constant δ in T = 2δn + κ.
    pub delta: T,
    /// The constant κ in T = 2δn + κ.
    pub kappa: T,
    /// The constant μ, which determines the integral K̂.
    pub mu: T,
    /// The sign s of x (inner branch) or of εx sinh κ (outer branch). Theorem 3 has s = 1.
    pub sign: T,
    /// The branch: inner if |εy| < 1, outer if |εy| > 1.
    pub branch: Branch,
}

impl<T: Real> Solution<T> {
    /// Returns the orbit through `point` at n = 0. Fails if ε = 0, if x = 0, or if ε²y² = 1, where
    /// det A = 0 for one sign of ε.
    pub fn through(point: &SVector<T, 3>, eps: &T) -> Result<Self, OutOfDomain> {
        let [x, y, z] = (*point).into();
        require(!eps.is_zero(), "eps != 0")?;
        require(!x.is_zero(), "x != 0")?;
        let scaled = *eps * y;
        let inner = (T::one() - scaled) * (T::one() + scaled);
        require(!inner.is_zero(), "eps^2 y^2 != 1")?;
        let width = inner.abs().sqrt();
        let norm = (x.square() + y.square()).sqrt();
        let stretched = (T::one() + eps.square() * x.square()).sqrt();
        let eps = *eps;
        Ok(if inner.is_positive() {
            // sinh²δ = ε²(x² + y²)/(1 − ε²y²), sinh²κ = y²(1 + ε²x²)/(x²(1 − ε²y²))
            let sine_delta = eps * norm / width;
            let kappa = -(y * stretched / (x.abs() * width)).asinh();
            let sign = x.sign();
            // The constant μ follows from z − x = s μ (cosh κ + sinh²δ/cosh κ).
            let cosine = kappa.cosh();
            let mu = sign * (z - x) * cosine / (cosine.square() + sine_delta.square());
            Self { delta: sine_delta.asinh(), kappa, mu, sign, branch: Branch::Inner, eps }
        } else {
            // w = ε²y² − 1: sinh²δ = (1 + ε²x²)/w, cosh²δ = ε²(x² + y²)/w, sinh²κ = (x² + y²)/(x²w)
            let cosine_delta_square = (eps * norm / width).square();
            let sine_kappa = -(y.sign() * norm / (x.abs() * width));
            let sign = (x * eps * sine_kappa).sign();
            let mu = sign * (z - x) * sine_kappa / (sine_kappa.square() + cosine_delta_square);
            Self {
                delta: (eps.sign() * stretched / width).asinh(),
                kappa: sine_kappa.asinh(),
                mu,
                sign,
                branch: Branch::Outer,
                eps,
            }
        })
    }

    /// Returns the point after n steps; n may be negative. The point is not finite at a pole.
    pub fn at(&self, n: i64) -> SVector<T, 3> {
        let Self { eps, delta, kappa, mu, sign, branch } = self;
        let argument = T::from_int(2 * n) * *delta + *kappa;
        let (sine_delta, cosine_delta) = delta.sinh_cosh();
        let (sine, cosine) = argument.sinh_cosh();
        let product = delta.tanh() * argument.tanh();
        let (sign, top, bottom, height) = match branch {
            Branch::Inner => (*sign, sine_delta, cosine, product),
            Branch::Outer => (*sign * alternating::<T>(n), cosine_delta, sine, T::one() / product),
        };
        let quotient = top / bottom;
        let z = *mu * bottom + (T::one() / *eps + *mu * top) * quotient;
        vector![sign * quotient / *eps, -height / *eps, sign * z]
    }
}
