//! The trait of real numbers in closed solutions.

use kahan_core::Pivot;
use kahan_core::num_rational::BigRational;

/// A real number of finite precision with elementary functions, Γ and ψ: `f64` or
/// [`Float256`](super::Float256). Without a real value (0/0, ln(−1), a pole of Γ), the result is
/// NaN. Comparisons with NaN are false, and [`is_finite_number`](Pivot::is_finite_number) is false
/// for NaN.
pub trait Real: Pivot + Copy + PartialOrd + From<f64> + core::fmt::Display {
    /// The number of decimal digits that survive conversion: 15 for `f64`, 76 for `Float256`.
    const DIGITS: usize;

    /// Returns the distance from 1 to the next larger number, which is twice the unit roundoff.
    fn epsilon() -> Self;

    /// Converts an integer to the nearest number.
    fn from_int(n: i64) -> Self;

    /// Rounds a rational to the nearest number.
    fn from_rational(q: &BigRational) -> Self;

    /// Returns p/q, or NaN if q = 0.
    fn from_ratio(p: i64, q: i64) -> Self {
        Self::from_int(p) / Self::from_int(q)
    }

    /// Returns the nearest `f64`.
    fn to_f64(&self) -> f64 {
        self.approximate()
    }

    /// Returns π.
    fn pi() -> Self;

    /// Returns |x|.
    fn abs(&self) -> Self;

    /// Returns √x, or NaN if x < 0.
    fn sqrt(&self) -> Self;

    /// Returns eˣ.
    fn exp(&self) -> Self;

    /// Returns eˣ − 1, without cancellation near x = 0.
    fn exp_m1(&self) -> Self;

    /// Returns ln x for x > 0.
    fn ln(&self) -> Self;

    /// Returns ln(1 + x) for x > −1, without cancellation near x = 0.
    fn ln_1p(&self) -> Self;

    /// Returns (sin x, cos x) for x in radians.
    fn sin_cos(&self) -> (Self, Self);

    /// Returns the angle of the point (x, `self`), in (−π, π], or 0 at the origin.
    fn atan2(&self, x: &Self) -> Self;

    /// Returns (sinh x, cosh x).
    fn sinh_cosh(&self) -> (Self, Self);

    /// Returns tanh x.
    fn tanh(&self) -> Self;

    /// Returns artanh x, for −1 < x < 1.
    fn atanh(&self) -> Self;

    /// Returns the largest integer ≤ x.
    fn floor(&self) -> Self;

    /// Returns Γ(x), or NaN at the poles 0, −1, −2, …. [`gamma`](super::gamma) documents the
    /// errors.
    fn gamma(&self) -> Self;

    /// Returns ψ(x) = Γ′(x)/Γ(x), or NaN at the poles 0, −1, −2, …. [`digamma`](super::digamma)
    /// documents the errors.
    fn digamma(&self) -> Self;

    /// Returns the Bernoulli numbers B₂, B₄, …, B₁₂₈, computed once.
    fn bernoulli() -> &'static [Self];

    /// Returns 1/2.
    fn half() -> Self {
        Self::one() / Self::from_int(2)
    }

    /// Returns sin x.
    fn sin(&self) -> Self {
        self.sin_cos().0
    }

    /// Returns cos x.
    fn cos(&self) -> Self {
        self.sin_cos().1
    }

    /// Returns sinh x.
    fn sinh(&self) -> Self {
        self.sinh_cosh().0
    }

    /// Returns cosh x.
    fn cosh(&self) -> Self {
        self.sinh_cosh().1
    }

    /// Returns arctan x in (−π/2, π/2).
    fn atan(&self) -> Self {
        self.atan2(&Self::one())
    }

    /// Returns arsinh x, without cancellation near 0.
    fn asinh(&self) -> Self {
        // For x ≥ 0, y = arsinh x satisfies eʸ − 1 = x + x²/(1 + √(1 + x²)). The function is odd.
        let x = self.abs();
        let root = (Self::one() + x.square()).sqrt();
        let value = (x + x.square() / (Self::one() + root)).ln_1p();
        if self.is_negative() { -value } else { value }
    }

    /// Returns 1 for x ≥ 0, and −1 for x < 0.
    fn sign(&self) -> Self {
        if self.is_negative() { -Self::one() } else { Self::one() }
    }

    /// Returns x².
    fn square(&self) -> Self {
        *self * *self
    }

    /// Returns xⁿ for any integer n, where x⁰ = 1.
    fn power(&self, n: i64) -> Self {
        let mut result = Self::one();
        let mut square = *self;
        let mut rest = n.unsigned_abs();
        while rest > 0 {
            if rest % 2 == 1 {
                result *= square;
            }
            square = square.square();
            rest /= 2;
        }
        if n < 0 { Self::one() / result } else { result }
    }

    /// Returns x^y = e^(y ln x) for x > 0.
    fn power_real(&self, y: &Self) -> Self;

    /// Returns whether x > 0.
    fn is_positive(&self) -> bool {
        *self > Self::zero()
    }

    /// Returns whether x < 0.
    fn is_negative(&self) -> bool {
        *self < Self::zero()
    }
}
