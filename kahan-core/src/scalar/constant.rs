//! An exact rational literal as data.
//!
//! In: the numbers of a field's text, written by the macro or kept by what reads a text at run
//! time. Out: the ratio itself, or its nearest
//! `f32`, `f64` or pair of `f64`. Every rounding happens once: small ratios by one correctly
//! rounded division, long ones by whoever wrote the data, since neither digits nor limbs are
//! divided here.

use super::wide::Digits;

/// An exact rational number p/q that every [`Scalar`](crate::Scalar) can be built from; its digits
/// are borrowed, as a rule from the program's static data.
#[derive(Clone, Copy, Debug)]
pub struct Constant<'a>(Form<'a>);

#[derive(Clone, Copy, Debug)]
enum Form<'a> {
    Integer(i64),
    /// |p| and q at most 2²⁴: exact in `f32`, so that one division rounds correctly in either width.
    Ratio(i64, i64),
    Long(Long<'a>),
}

#[derive(Clone, Copy, Debug)]
struct Long<'a> {
    negative: bool,
    numerator: &'a [u64],
    denominator: &'a [u64],
    single: f32,
    double: f64,
    low: f64,
}

/// The largest numerator and denominator of [`Constant::ratio`].
const RATIO_LIMIT: u64 = 1 << 24;

impl<'a> Constant<'a> {
    /// The integer n.
    #[inline(always)]
    pub const fn integer(n: i64) -> Self {
        Self(Form::Integer(n))
    }

    /// p/q for |p| ≤ 2²⁴ and 1 ≤ q ≤ 2²⁴.
    ///
    /// # Panics
    /// Outside that range (while compiling, where it is used in a constant).
    #[inline(always)]
    pub const fn ratio(p: i64, q: i64) -> Self {
        assert!(
            p.unsigned_abs() <= RATIO_LIMIT && q >= 1 && q.unsigned_abs() <= RATIO_LIMIT,
            "Constant::ratio takes numerators and denominators up to 2^24"
        );
        Self(Form::Ratio(p, q))
    }

    /// Any rational ±numerator/denominator, its limbs of 64 bits in little-endian order, with its
    /// roundings.
    ///
    /// `single` and `double` are the nearest floats and `low` is the `f64` nearest to what `double`
    /// leaves; all three carry the number's sign. The denominator is not zero.
    #[inline(always)]
    pub const fn exact(
        negative: bool,
        numerator: &'a [u64],
        denominator: &'a [u64],
        single: f32,
        double: f64,
        low: f64,
    ) -> Self {
        Self(Form::Long(Long { negative, numerator, denominator, single, double, low }))
    }

    /// Whether this is an integer that every float of 53 bits or more holds.
    #[inline(always)]
    pub(crate) const fn is_whole(&self) -> bool {
        matches!(self.0, Form::Integer(n) if n.unsigned_abs() <= 1 << 53)
    }

    /// The nearest `f32`.
    #[inline(always)]
    pub const fn to_f32(&self) -> f32 {
        match self.0 {
            Form::Integer(n) => n as f32,
            Form::Ratio(p, q) => p as f32 / q as f32,
            Form::Long(long) => long.single,
        }
    }

    /// The nearest `f64`.
    #[inline(always)]
    pub const fn to_f64(&self) -> f64 {
        match self.0 {
            Form::Integer(n) => n as f64,
            Form::Ratio(p, q) => p as f64 / q as f64,
            Form::Long(long) => long.double,
        }
    }

    /// The nearest `f64` and the `f64` nearest to what it leaves: (high, low), worth high + low.
    #[inline(always)]
    pub const fn to_double_double(&self) -> (f64, f64) {
        let high = self.to_f64();
        let low = match self.0 {
            // Both are integers below 2⁶⁵ in size, and the difference fits an f64.
            Form::Integer(n) => (n as i128 - high as i128) as f64,
            Form::Ratio(p, q) => remainder(p as f64, q as f64, high) / q as f64,
            Form::Long(long) => long.low,
        };
        (high, low)
    }

    /// The number: exact but for numerators and denominators of very many bits.
    pub(crate) fn to_digits<const D: usize, const M: usize>(self) -> Digits<D, M> {
        match self.0 {
            Form::Integer(n) => Digits::from(n),
            Form::Ratio(p, q) => Digits::from(p) / Digits::from(q),
            Form::Long(long) => Digits::from_ratio(long.negative, long.numerator, long.denominator),
        }
    }

    /// The number itself.
    #[cfg(feature = "exact")]
    pub fn to_ratio(&self) -> num_rational::BigRational {
        use num_bigint::{BigInt, Sign};
        use num_rational::BigRational;

        match self.0 {
            Form::Integer(n) => BigRational::from_integer(n.into()),
            Form::Ratio(p, q) => BigRational::new(p.into(), q.into()),
            Form::Long(Long { negative, numerator, denominator, .. }) => {
                let sign = if negative { Sign::Minus } else { Sign::Plus };
                let numerator = BigInt::from_biguint(sign, natural(numerator));
                BigRational::new(numerator, natural(denominator).into())
            }
        }
    }
}

/// p − q·quotient without an error, for |p|, q ≤ 2²⁴ and quotient the float nearest to p/q.
///
/// The remainder of a correctly rounded division is a float. To get it without a fused multiply-add
/// (which `core` lacks), the quotient is cut into 24 leading bits and at most 29 others, whose
/// products with q are exact.
const fn remainder(p: f64, q: f64, quotient: f64) -> f64 {
    let leading = quotient as f32 as f64;
    let rest = quotient - leading;
    (p - leading * q) - rest * q
}

/// A natural number from its limbs of 64 bits, little-endian.
#[cfg(feature = "exact")]
fn natural(limbs: &[u64]) -> num_bigint::BigUint {
    num_bigint::BigUint::new(limbs.iter().flat_map(|&limb| [limb as u32, (limb >> 32) as u32]).collect())
}
