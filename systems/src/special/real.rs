//! The trait of real numbers that explicit solutions are computed with.

use kahan_core::Pivot;
use kahan_core::num_rational::BigRational;

/// A real number of finite precision with the elementary functions and the few special ones that
/// have a library.
///
/// Implemented for `f64` and for [`Precise`](super::Precise). What has no real value (0/0, ln(−1),
/// a pole of Γ) is not a number: it compares with nothing, and
/// [`is_finite_number`](Pivot::is_finite_number) tells. Methods take references; the operators of
/// [`Scalar`](kahan_core::Scalar) take values. An `f64` becomes the number that it is, without
/// rounding.
pub trait Real: Pivot + Copy + PartialOrd + From<f64> + core::fmt::Display {
    /// Decimal digits that a value carries at least: 15 for `f64`, 76 for
    /// [`Precise`](super::Precise).
    const DIGITS: usize;

    /// The distance from 1 to the next larger number; a correct rounding errs by at most half of
    /// it, relatively.
    fn epsilon() -> Self;

    /// An integer, rounded to nearest where it has too many digits.
    fn from_int(n: i64) -> Self;

    /// The number nearest to a rational.
    fn from_rational(q: &BigRational) -> Self;

    /// The number nearest to p/q; not a number for q = 0.
    fn from_ratio(p: i64, q: i64) -> Self {
        Self::from_int(p) / Self::from_int(q)
    }

    /// The nearest `f64`.
    fn to_f64(&self) -> f64 {
        self.approximate()
    }

    /// π, the half turn.
    fn pi() -> Self;

    /// The absolute value.
    fn abs(&self) -> Self;

    /// The square root, of what is not negative.
    fn sqrt(&self) -> Self;

    /// eˣ.
    fn exp(&self) -> Self;

    /// eˣ − 1, without cancellation near x = 0.
    fn exp_m1(&self) -> Self;

    /// The natural logarithm, of what is positive.
    fn ln(&self) -> Self;

    /// ln(1 + x), without cancellation near x = 0, for x > −1.
    fn ln_1p(&self) -> Self;

    /// (sin x, cos x), x in radians.
    fn sin_cos(&self) -> (Self, Self);

    /// The angle of the point (x, y) with `self` as y: in (−π, π], and 0 at the origin.
    fn atan2(&self, x: &Self) -> Self;

    /// (sinh x, cosh x).
    fn sinh_cosh(&self) -> (Self, Self);

    /// tanh x.
    fn tanh(&self) -> Self;

    /// The inverse of tanh, of what lies between −1 and 1.
    fn atanh(&self) -> Self;

    /// The largest integer that is not above x.
    fn floor(&self) -> Self;

    /// Γ(x), see [`gamma`](super::gamma); not a number at the poles 0, −1, −2, …
    fn gamma(&self) -> Self;

    /// ψ(x) = Γ′(x)/Γ(x), see [`digamma`](super::digamma); not a number at the poles 0, −1, −2, …
    fn digamma(&self) -> Self;

    /// The Bernoulli numbers B₂, B₄, …, B₁₂₈, computed once.
    fn bernoulli() -> &'static [Self];

    /// 1/2, exactly.
    fn half() -> Self {
        Self::one() / Self::from_int(2)
    }

    /// sin x.
    fn sin(&self) -> Self {
        self.sin_cos().0
    }

    /// cos x.
    fn cos(&self) -> Self {
        self.sin_cos().1
    }

    /// sinh x.
    fn sinh(&self) -> Self {
        self.sinh_cosh().0
    }

    /// cosh x.
    fn cosh(&self) -> Self {
        self.sinh_cosh().1
    }

    /// The angle in (−π/2, π/2) whose tangent is x.
    fn atan(&self) -> Self {
        self.atan2(&Self::one())
    }

    /// The inverse of sinh, for every x, without cancellation near 0.
    fn asinh(&self) -> Self {
        // For x ≥ 0: eʸ − 1 = x + x²/(1 + √(1 + x²)); odd, so the size decides.
        let x = self.abs();
        let root = (Self::one() + x.square()).sqrt();
        let value = (x + x.square() / (Self::one() + root)).ln_1p();
        if self.is_negative() { -value } else { value }
    }

    /// The sign as a number: 1 for x ≥ 0, −1 for x < 0.
    fn sign(&self) -> Self {
        if self.is_negative() { -Self::one() } else { Self::one() }
    }

    /// x².
    fn square(&self) -> Self {
        *self * *self
    }

    /// xⁿ for any integer n; x⁰ = 1.
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

    /// x^y = e^(y ln x) for x > 0.
    fn power_real(&self, y: &Self) -> Self;

    /// Whether x > 0.
    fn is_positive(&self) -> bool {
        *self > Self::zero()
    }

    /// Whether x < 0.
    fn is_negative(&self) -> bool {
        *self < Self::zero()
    }
}
