//! Exact rational literals as data.
//!
//! The macro writes these numbers, or a program reads them at run time. They convert to the exact
//! ratio, or to the nearest `f32`, `f64` or double-double, with a single rounding.

use super::wide::Digits;

/// An exact rational number p/q, convertible to every [`Scalar`](crate::Scalar).
#[derive(Clone, Copy, Debug)]
pub struct Constant<'a>(ConstantForm<'a>);

#[derive(Clone, Copy, Debug)]
enum ConstantForm<'a> {
    Integer(i64),
    /// Numerator and denominator are at most 2²⁴, and therefore exact in `f32`.
    Ratio(i64, i64),
    Long(LongRatio<'a>),
}

#[derive(Clone, Copy, Debug)]
struct LongRatio<'a> {
    negative: bool,
    numerator: &'a [u64],
    denominator: &'a [u64],
    single: f32,
    double: f64,
    low: f64,
}

/// The largest absolute value of a numerator or denominator of [`Constant::ratio`].
const RATIO_LIMIT: u64 = 1 << 24;

impl<'a> Constant<'a> {
    /// Creates the integer n.
    #[inline(always)]
    pub const fn integer(n: i64) -> Self {
        Self(ConstantForm::Integer(n))
    }

    /// Creates p/q for |p| ≤ 2²⁴ and 1 ≤ q ≤ 2²⁴.
    ///
    /// # Panics
    /// If p or q is out of range. In a constant, the panic occurs at compile time.
    #[inline(always)]
    pub const fn ratio(p: i64, q: i64) -> Self {
        assert!(
            p.unsigned_abs() <= RATIO_LIMIT && q >= 1 && q.unsigned_abs() <= RATIO_LIMIT,
            "Constant::ratio takes numerators and denominators up to 2^24"
        );
        Self(ConstantForm::Ratio(p, q))
    }

    /// Creates ±numerator/denominator from its little-endian 64-bit limbs and its roundings.
    ///
    /// `single` is the nearest `f32`, `double` is the nearest `f64`, and `low` is the `f64` nearest
    /// to the number minus `double`. All three must have the sign of the number. The denominator
    /// must be nonzero.
    #[inline(always)]
    pub const fn exact(
        negative: bool,
        numerator: &'a [u64],
        denominator: &'a [u64],
        single: f32,
        double: f64,
        low: f64,
    ) -> Self {
        Self(ConstantForm::Long(LongRatio { negative, numerator, denominator, single, double, low }))
    }

    /// Returns whether this is an integer of absolute value at most 2⁵³.
    #[inline(always)]
    pub(crate) const fn is_whole(&self) -> bool {
        matches!(self.0, ConstantForm::Integer(n) if n.unsigned_abs() <= 1 << 53)
    }

    /// Returns the `f32` nearest to the number.
    #[inline(always)]
    pub const fn to_f32(&self) -> f32 {
        match self.0 {
            ConstantForm::Integer(n) => n as f32,
            ConstantForm::Ratio(p, q) => p as f32 / q as f32,
            ConstantForm::Long(long) => long.single,
        }
    }

    /// Returns the `f64` nearest to the number.
    #[inline(always)]
    pub const fn to_f64(&self) -> f64 {
        match self.0 {
            ConstantForm::Integer(n) => n as f64,
            ConstantForm::Ratio(p, q) => p as f64 / q as f64,
            ConstantForm::Long(long) => long.double,
        }
    }

    /// Returns the nearest `f64`, and the `f64` nearest to the remainder.
    #[inline(always)]
    pub const fn to_double_double(&self) -> (f64, f64) {
        let high = self.to_f64();
        let low = match self.0 {
            ConstantForm::Integer(n) => (n as i128 - high as i128) as f64,
            ConstantForm::Ratio(p, q) => remainder(p as f64, q as f64, high) / q as f64,
            ConstantForm::Long(long) => long.low,
        };
        (high, low)
    }

    /// Returns the number, rounded only if numerator or denominator has too many digits.
    pub(crate) fn to_digits<const D: usize, const M: usize>(self) -> Digits<D, M> {
        match self.0 {
            ConstantForm::Integer(n) => Digits::from(n),
            ConstantForm::Ratio(p, q) => Digits::from(p) / Digits::from(q),
            ConstantForm::Long(long) => Digits::from_ratio(long.negative, long.numerator, long.denominator),
        }
    }

    /// Returns the number as an exact rational.
    #[cfg(feature = "exact")]
    pub fn to_ratio(&self) -> num_rational::BigRational {
        use num_bigint::{BigInt, Sign};
        use num_rational::BigRational;

        match self.0 {
            ConstantForm::Integer(n) => BigRational::from_integer(n.into()),
            ConstantForm::Ratio(p, q) => BigRational::new(p.into(), q.into()),
            ConstantForm::Long(LongRatio { negative, numerator, denominator, .. }) => {
                let sign = if negative { Sign::Minus } else { Sign::Plus };
                let numerator = BigInt::from_biguint(sign, natural(numerator));
                BigRational::new(numerator, natural(denominator).into())
            }
        }
    }
}

/// Returns p − q·quotient exactly. `quotient` is the float nearest to p/q, and |p|, q ≤ 2²⁴.
///
/// Because `core` has no fused multiply-add, the quotient is split into its 24 leading bits and the
/// remaining bits. The products of both parts with q are exact.
const fn remainder(p: f64, q: f64, quotient: f64) -> f64 {
    let leading = quotient as f32 as f64;
    let rest = quotient - leading;
    (p - leading * q) - rest * q
}

#[cfg(feature = "exact")]
fn natural(limbs: &[u64]) -> num_bigint::BigUint {
    num_bigint::BigUint::new(limbs.iter().flat_map(|&limb| [limb as u32, (limb >> 32) as u32]).collect())
}
