//! Double-double numbers: unevaluated sums of two `f64`, with about 32 decimal digits.
//!
//! The four operations, the square root, exponential and logarithm have relative errors from 3u² to
//! 32u² for u = 2⁻⁵³; products and quotients below 2⁻⁹⁶⁹ lose low bits. Sine and cosine have an
//! additional error of 2⁻¹⁵⁵ of the argument. The exponent range is that of `f64`. Conversions from
//! and to text round correctly.

mod arithmetic;
mod decimal;
mod display;
mod elementary;
mod error_free;
mod extremes;
mod fixed;
mod moderate;
mod operators;
mod traits;

/// A double-double number high + low, where `high` is the `f64` nearest to the sum.
///
/// Because |low| ≤ ½ ulp(high), numbers have at least 106 bits. Infinities and NaN have low = 0 and
/// behave as the `f64` in `high` does.
///
/// # Bounds
/// The relative errors of the operations have the following bounds, with u = 2⁻⁵³:
///
/// | operation | bound | source |
/// |---|---|---|
/// | `+`, `-` | 3u² + 13u³ | AccurateDWPlusDW: Joldeş, Muller, Popescu, ACM Trans. Math. Softw. 44 (2017) |
/// | `*` | 5u² | DWTimesDW2, unfused DWTimesDW1: Muller, Rideau, ACM Trans. Math. Softw. 48 (2022) |
/// | `/`, `recip` | 14u² | one correction of the quotient; proved in a comment of the code |
/// | [`sqrt`](Dd::sqrt) | 4u² | SQRTDWtoDW: Lefèvre, Louvet, Muller, Picot, Rideau, ACM Trans. Math. Softw. 49 (2023), 25/8 u² |
/// | [`exp`](Dd::exp), [`ln`](Dd::ln) | 12u², 32u² | series of a reduced argument |
/// | [`sin`](Dd::sin), [`cos`](Dd::cos) | 16u², and 2⁻¹⁵⁵ of the argument | series of a reduced argument |
/// | [`multiply_add`](crate::Scalar::multiply_add) | 16u² of the product and 5u² of the result | |
///
/// Products and quotients below 2⁻⁹⁶⁹ lose low bits, which adds an error of at most 2⁻¹⁰⁷². Sums
/// never underflow. Results from 2¹⁰²⁴ on become infinite, and so do products in multiply-adds.
///
/// The results depend on whether the target fuses multiply-adds. If it does, xy and yx may differ.
///
/// # Cost
/// With `std` and fused multiply-adds, a sum takes 20 operations, a product 8, a multiply-add 15,
/// and a quotient 7 operations and two parallel divisions. Without fusing, a product takes 24.
///
/// # Text
/// Decimals of any length are read exactly, and each part is correctly rounded. Numbers are written
/// with 32 significant digits or as the format requests (`{:.40}`, `{:.40e}`), correctly rounded.
///
/// ```
/// use kahan_core::Dd;
///
/// let third = Dd::from(1.0) / Dd::from(3.0);
/// assert_eq!(third.to_string(), "0.33333333333333333333333333333333");
/// assert_eq!(f64::from(third), 1.0 / 3.0);
/// assert_eq!("0.1".parse(), Ok(Dd::from(1.0) / Dd::from(10.0)));
/// assert_ne!("0.1".parse(), Ok(Dd::from(0.1)));
/// ```
#[derive(Clone, Copy, Default, PartialEq)]
pub struct Dd {
    high: f64,
    low: f64,
}

impl Dd {
    /// Returns high + low exactly, for floats of any size and order. If the sum overflows, `low`
    /// becomes 0.
    #[inline]
    pub const fn new(high: f64, low: f64) -> Self {
        // In this order, an overflow occurs only if the sum itself overflows.
        let (larger, smaller) = if high.abs() < low.abs() { (low, high) } else { (high, low) };
        let (sum, error) = error_free::fast_two_sum(larger, smaller);
        if sum.is_finite() { Self { high: sum, low: error } } else { Self::leading(sum) }
    }

    #[inline(always)]
    const fn leading(high: f64) -> Self {
        Self { high, low: 0.0 }
    }

    /// Returns the `f64` nearest to the number, ties to even.
    #[inline(always)]
    pub const fn high(self) -> f64 {
        self.high
    }

    /// Returns the number minus [`high`](Self::high), or 0 if the number is not finite.
    #[inline(always)]
    pub const fn low(self) -> f64 {
        self.low
    }

    /// Returns whether the number is neither infinite nor NaN.
    #[inline]
    pub const fn is_finite(self) -> bool {
        self.high.is_finite()
    }

    /// Returns whether the number is NaN.
    #[inline]
    pub const fn is_nan(self) -> bool {
        self.high.is_nan()
    }

    /// Returns |self|, which is exact.
    #[inline]
    pub const fn abs(self) -> Self {
        if self.high.is_sign_negative() { Self { high: -self.high, low: -self.low } } else { self }
    }

    /// Returns 1/self with a relative error of at most 14u². The result is infinite at zero.
    #[inline]
    pub fn recip(self) -> Self {
        arithmetic::quotient(Self::leading(1.0), self)
    }

    /// Returns √self with a relative error of at most 4u². The result is NaN below zero, and −0 for
    /// −0.
    #[inline]
    pub fn sqrt(self) -> Self {
        arithmetic::square_root(self)
    }

    /// Returns e to the power of self with a relative error of at most 12u².
    #[must_use]
    pub fn exp(self) -> Self {
        elementary::exp(self)
    }

    /// Returns the natural logarithm with a relative error of at most 32u². The result is −∞ at
    /// zero, and NaN below zero.
    #[must_use]
    pub fn ln(self) -> Self {
        elementary::ln(self)
    }

    /// Returns sine and cosine with relative errors of at most 16u² + 2⁻¹⁵⁵·|self|. Both are NaN if
    /// |self| exceeds 2⁴⁰.
    #[must_use]
    pub fn sin_cos(self) -> (Self, Self) {
        elementary::sin_cos(self)
    }

    /// Returns the sine; see [`sin_cos`](Self::sin_cos).
    #[must_use]
    pub fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// Returns the cosine; see [`sin_cos`](Self::sin_cos).
    #[must_use]
    pub fn cos(self) -> Self {
        self.sin_cos().1
    }
}

impl From<f64> for Dd {
    #[inline(always)]
    fn from(x: f64) -> Self {
        Self::leading(x)
    }
}

impl From<f32> for Dd {
    #[inline(always)]
    fn from(x: f32) -> Self {
        Self::leading(f64::from(x))
    }
}

impl From<i32> for Dd {
    #[inline(always)]
    fn from(n: i32) -> Self {
        Self::leading(f64::from(n))
    }
}

impl From<Dd> for f64 {
    #[inline(always)]
    fn from(x: Dd) -> Self {
        x.high
    }
}
