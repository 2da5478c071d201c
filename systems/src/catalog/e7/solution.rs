//! Orbits of the map of E7 by the Gamma function.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::{OutOfDomain, shift_and_divisor, square_less_one};
use crate::special::{Real, centered_gamma_ratio};

/// An orbit of the map of E7 (Hone and Petrera, Section 6.1). The point after n steps is
///
///   x = 1/(2εN), y = τβ g_n G₀/(2εN),
///   z = τγ(4N²−1)/(2ε(4τ²−1)N) + 2τ²β²ξ(4N²−1)G₀²W_n/(εN),
///
/// where N = n + τ, β = 2εy₀, γ = 2εz₀, g_n = Γ(N+1−ξ/2)/Γ(N+ξ/2), G₀ = Γ(τ+ξ/2)/Γ(τ+1−ξ/2), and
/// W_n = Σ_{0≤j<n} (2(M+1)−ξ) Γ(M+1−ξ/2)²/((2M+3)(2M+ξ)(4M²−1) Γ(M+ξ/2)²) with M = j + τ.
///
/// In `f64` the error is at most 16(1 + |n|) ulp of the point's norm, multiplied by max(1, |ε|r),
/// where r is this norm. The integrals are [`integral_h`](super::integral_h) and
/// [`integral_k`](super::integral_k). [`Recurrence`](super::Recurrence) computes orbits without Γ.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution<T> {
    /// Half the time step, ε.
    pub eps: T,
    /// The parameter ξ of the system.
    pub xi: T,
    /// The constant τ = 1/(2εx₀) in N = n + τ, where x₀ is x at n = 0.
    pub tau: T,
    /// The constant β = 2εy₀, where y₀ is y at n = 0.
    pub beta: T,
    /// The constant γ = 2εz₀, where z₀ is z at n = 0.
    pub gamma: T,
}

impl<T: Real> Solution<T> {
    /// Returns the orbit through `point` at n = 0. Fails if εx = 0, or if ε²x² = 1.
    pub fn through(xi: &T, point: &SVector<T, 3>, eps: &T) -> Result<Self, OutOfDomain> {
        let [x, y, z] = (*point).into();
        let (tau, _) = shift_and_divisor(&x, eps)?;
        let double = T::from_int(2) * *eps;
        Ok(Self { tau, beta: double * y, gamma: double * z, xi: *xi, eps: *eps })
    }

    /// Returns the point after n steps; n may be negative. The cost is a sum of |n| terms. At a
    /// pole, the point is not finite.
    pub fn at(&self, n: i64) -> SVector<T, 3> {
        let Self { eps, xi, tau, beta, gamma } = self;
        let shifted = T::from_int(n) + *tau;
        let x = T::one() / (T::from_int(2) * *eps * shifted);
        let y = *tau * *beta * self.gamma_quotient(&shifted) * x;
        let four = T::from_int(4);
        let first = *tau * *gamma / square_less_one(*tau);
        let second = four * (*tau * *beta).square() * *xi * self.scaled_sum(n);
        vector![x, y, x * square_less_one(shifted) * (first + second)]
    }

    /// Returns the quotient of y/x after n steps and y/x at n = 0. `shifted` is N = n + τ.
    fn gamma_quotient(&self, shifted: &T) -> T {
        let sigma = (self.xi - T::one()) * T::half();
        centered_gamma_ratio(&self.tau, &sigma) / centered_gamma_ratio(shifted, &sigma)
    }

    /// Returns G₀² W_n with G₀ and W_n as in the formula for orbits. For n < 0, W_n is minus the
    /// sum over n ≤ j < 0. A recurrence gives the quotients of Γ without overflow.
    fn scaled_sum(&self, n: i64) -> T {
        let Self { xi, tau, .. } = self;
        let (range, sign) = if n < 0 { (n..0, -T::one()) } else { (0..n, T::one()) };
        let two = T::from_int(2);
        let mut quotient =
            if range.is_empty() { T::one() } else { self.gamma_quotient(&(T::from_int(range.start) + *tau)) };
        let mut sum = T::zero();
        for j in range {
            let double = two * (T::from_int(j) + *tau);
            let top = double + two - *xi;
            let bottom = double + *xi;
            let divisor = (double + T::from_int(3)) * bottom * (double.square() - T::one());
            sum += top * quotient.square() / divisor;
            quotient = quotient * top / bottom;
        }
        sign * sum
    }
}
