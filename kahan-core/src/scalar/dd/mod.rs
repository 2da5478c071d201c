//! Double-double numbers: the unevaluated sum of two `f64`, worth about 32 decimal digits.
//!
//! In: floats, constants, text. Out: the four operations, the square root and elementary functions
//! with errors of a few u², u = 2⁻⁵³, each bound stated where the operation is; overflow is
//! infinite, never a finite lie. `arithmetic` holds the operations, on top of `error_free`;
//! `extremes` what they do beyond their range; `elementary` the functions; `decimal` and `display`
//! are exact, through `fixed`. The exponent range is that
//! of `f64`: more digits, no larger numbers.

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

/// A double-double number: high + low, with high the `f64` nearest to the sum.
///
/// So |low| ≤ ½ ulp(high), the digits are 106 bits at least, and two numbers are equal exactly
/// where both parts are. What is not finite has low = 0 and behaves as the `f64` in high does.
///
/// # Bounds
/// With u = 2⁻⁵³ the results of the operations differ from the exact ones, relatively, by at most
///
/// | operation | bound | source |
/// |---|---|---|
/// | `+`, `-` | 3u² + 13u³ | AccurateDWPlusDW: Joldeş, Muller, Popescu, ACM Trans. Math. Softw. 44 (2017) |
/// | `*` | 5u² | DWTimesDW2, or 1 without fused multiply-adds: Muller, Rideau, ACM Trans. Math. Softw. 48 (2022) |
/// | `/`, `recip` | 14u² | one correction of the quotient; the terms stand beside the code |
/// | [`sqrt`](Dd::sqrt) | 4u² | SQRTDWtoDW: Lefèvre, Louvet, Muller, Picot, Rideau, ACM Trans. Math. Softw. 49 (2023), 25/8 u² |
/// | [`exp`](Dd::exp), [`ln`](Dd::ln) | 12u², 32u² | series of a reduced argument |
/// | [`sin`](Dd::sin), [`cos`](Dd::cos) | 16u², and 2⁻¹⁵⁵ of the argument | likewise |
/// | [`multiply_add`](crate::Scalar::multiply_add) and its kin | 16u² of the product and 5u² of the result | not normalised between the two |
///
/// Products and quotients below 2⁻⁹⁶⁹ in size lose low bits, as the error of a float is then no
/// float: besides the relative bound they are off by at most 2⁻¹⁰⁷². Sums never underflow. A result
/// that rounds to 2¹⁰²⁴ or more is infinite; operands and intermediate numbers may be as large as
/// they like.
///
/// Bits depend on the target's multiply-add, as those of floats do; with it, xy and yx may differ
/// within the bound.
///
/// # Cost
/// With fused multiply-adds (a target that has them, and `std`) a sum takes 20 operations, a
/// product 8, a multiply-add 15, a quotient 7 and two divisions side by side; without, a product
/// takes 24. Constants without a low part are not faster than others.
///
/// # Text
/// It is read exactly, from decimals of any length, each part correctly rounded; it is written with
/// 32 significant digits, correctly rounded, or as many as the format asks for (`{:.40}`,
/// `{:.40e}`).
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
    /// high + low, two floats of any sizes and in any order; the sum is exact.
    ///
    /// Where it is not finite, low is 0.
    #[inline]
    pub const fn new(high: f64, low: f64) -> Self {
        // In this order nothing overflows but the sum itself.
        let (larger, smaller) = if high.abs() < low.abs() { (low, high) } else { (high, low) };
        let (sum, error) = error_free::fast_two_sum(larger, smaller);
        if sum.is_finite() { Self { high: sum, low: error } } else { Self::leading(sum) }
    }

    /// A float as it is.
    #[inline(always)]
    const fn leading(high: f64) -> Self {
        Self { high, low: 0.0 }
    }

    /// The `f64` nearest to the number, ties to even.
    #[inline(always)]
    pub const fn high(self) -> f64 {
        self.high
    }

    /// What [`high`](Self::high) leaves; 0 where that is not finite.
    #[inline(always)]
    pub const fn low(self) -> f64 {
        self.low
    }

    /// Whether this is a number and not infinite.
    #[inline]
    pub const fn is_finite(self) -> bool {
        self.high.is_finite()
    }

    /// Whether this is not a number.
    #[inline]
    pub const fn is_nan(self) -> bool {
        self.high.is_nan()
    }

    /// |self|, exactly.
    #[inline]
    pub const fn abs(self) -> Self {
        if self.high.is_sign_negative() { Self { high: -self.high, low: -self.low } } else { self }
    }

    /// 1/self, off by at most 14u² relatively; infinite at zero.
    #[inline]
    pub fn recip(self) -> Self {
        arithmetic::quotient(Self::leading(1.0), self)
    }

    /// √self, off by at most 4u² relatively; not a number below zero, and −0 at −0.
    #[inline]
    pub fn sqrt(self) -> Self {
        arithmetic::square_root(self)
    }

    /// e to the power of self, off by at most 12u² relatively.
    #[must_use]
    pub fn exp(self) -> Self {
        elementary::exp(self)
    }

    /// The natural logarithm of self, off by at most 32u² relatively; −∞ at zero, and not a number
    /// below.
    #[must_use]
    pub fn ln(self) -> Self {
        elementary::ln(self)
    }

    /// Returns sin self and cos self, each off by at most 16u² relatively and by 2⁻¹⁵⁵·|self|
    /// besides; NaN where |self| > 2⁴⁰.
    #[must_use]
    pub fn sin_cos(self) -> (Self, Self) {
        elementary::sin_cos(self)
    }

    /// sin self, as [`sin_cos`](Self::sin_cos).
    #[must_use]
    pub fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// cos self, as [`sin_cos`](Self::sin_cos).
    #[must_use]
    pub fn cos(self) -> Self {
        self.sin_cos().1
    }
}

/// Exactly.
impl From<f64> for Dd {
    #[inline(always)]
    fn from(x: f64) -> Self {
        Self::leading(x)
    }
}

/// Exactly.
impl From<f32> for Dd {
    #[inline(always)]
    fn from(x: f32) -> Self {
        Self::leading(f64::from(x))
    }
}

/// Exactly.
impl From<i32> for Dd {
    #[inline(always)]
    fn from(n: i32) -> Self {
        Self::leading(f64::from(n))
    }
}

/// The nearest `f64`.
impl From<Dd> for f64 {
    #[inline(always)]
    fn from(x: Dd) -> Self {
        x.high
    }
}
