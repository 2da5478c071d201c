//! Orbits of the map of E8 by the digamma function.

use kahan_core::nalgebra::SVector;
use kahan_core::vector;

use crate::solution::{OutOfDomain, shift_and_divisor};
use crate::special::{Real, digamma};

/// An orbit of the map of E8 (Hone and Petrera, Section 6.2, with erratum A3 corrected). With
/// N = n + τ, β = 2εy₀, γ = 2εz₀, U_n = ψ(N+1/2) − ψ(τ+1/2) and the sum V_n of [`sum`](Self::sum),
/// the point after n steps is
///
///   x = 1/(2εN), y = (τβ − U_n)/(2εN),
///   z = τ[4n(n+2τ)(β²τ+β+γ) + 4τ²γ − γ]/(2ε(4τ²−1)N) − 4(4N²−1)V_n/(2εN).
///
/// In `f64` the error is at most 24(1 + |n|) ulp of the point's norm r, multiplied by max(1, |ε|r).
#[derive(Clone, Debug, PartialEq)]
pub struct Solution<T> {
    /// Half the time step, ε.
    pub eps: T,
    /// The constant τ = 1/(2εx₀) in N = n + τ, where x₀ is x at n = 0.
    pub tau: T,
    /// The constant β = 2εy₀, where y₀ is y at n = 0.
    pub beta: T,
    /// The constant γ = 2εz₀, where z₀ is z at n = 0.
    pub gamma: T,
}

/// Up to this |n|, U_n is added term by term. The difference of two values of ψ would lose digits.
const SUMMED: i64 = 256;

impl<T: Real> Solution<T> {
    /// Returns the orbit through `point` at n = 0. Fails if εx = 0, or if ε²x² = 1.
    pub fn through(point: &SVector<T, 3>, eps: &T) -> Result<Self, OutOfDomain> {
        let [x, y, z] = (*point).into();
        let (tau, _) = shift_and_divisor(&x, eps)?;
        let double = T::from_int(2) * *eps;
        Ok(Self { tau, beta: double * y, gamma: double * z, eps: *eps })
    }

    /// Returns the point after n steps; n may be negative. The cost is a sum of |n| terms. At a
    /// pole, the point is not finite.
    pub fn at(&self, n: i64) -> SVector<T, 3> {
        let Self { eps, tau, beta, gamma } = self;
        let shifted = T::from_int(n) + *tau;
        let four = T::from_int(4);
        let x = T::one() / (T::from_int(2) * *eps * shifted);
        let y = (*tau * *beta - self.digamma_difference(n)) * x;
        let initial = four * tau.square() - T::one();
        let travelled = four * T::from_int(n) * (shifted + *tau);
        let bracket = travelled * (beta.square() * *tau + *beta + *gamma) + initial * *gamma;
        let first = *tau * bracket / initial;
        let second = four * (four * shifted.square() - T::one()) * self.sum(n);
        vector![x, y, x * (first - second)]
    }

    /// Returns U_n = ψ(N+1/2) − ψ(τ+1/2) = Σ_{j<n} 1/(j+τ+1/2), where N = n + τ.
    fn digamma_difference(&self, n: i64) -> T {
        let middle = self.tau + T::half();
        if n.abs() > SUMMED {
            return digamma(&(T::from_int(n) + middle)) - digamma(&middle);
        }
        let (range, sign) = if n < 0 { (n..0, -T::one()) } else { (0..n, T::one()) };
        range.fold(T::zero(), |sum, j| sum + sign / (T::from_int(j) + middle))
    }

    /// Returns the sum V_n of the formula for orbits. With M = j + τ and U_j = ψ(M+1/2) − ψ(τ+1/2),
    /// V_n = Σ_{0≤j<n} {1+2βτ + U_j[2M(1+2βτ) − 1 + 2βτ] − U_j²(2M+1)}/((2M+3)(2M+1)(4M²−1)). For
    /// n < 0, V_n is minus the sum over n ≤ j < 0.
    pub fn sum(&self, n: i64) -> T {
        let Self { tau, beta, .. } = self;
        let two = T::from_int(2);
        let product = two * *beta * *tau;
        let (range, sign) = if n < 0 { (n..0, -T::one()) } else { (0..n, T::one()) };
        let mut difference = self.digamma_difference(range.start);
        let mut sum = T::zero();
        for j in range {
            let double = two * (T::from_int(j) + *tau);
            let next = double + T::one();
            let linear = double * (T::one() + product) - T::one() + product;
            let top = T::one() + product + difference * linear - difference.square() * next;
            let divisor = (double + T::from_int(3)) * next * (double.square() - T::one());
            sum += top / divisor;
            difference += two / next;
        }
        sign * sum
    }
}
