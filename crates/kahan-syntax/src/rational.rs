//! Exact rational numbers, which are the numbers of the language and the coefficients of
//! polynomials.
//!
//! Numbers are in lowest terms with positive denominators, so equal numbers have equal
//! representations. Conversions to floats round correctly. [`Rational::checked_div`] replaces a
//! division operator, so that callers handle division by zero.

mod arithmetic;
pub(crate) mod numeral;
mod rounding;
#[cfg(test)]
mod tests;
pub(crate) mod text;

use std::cmp::Ordering;
use std::sync::Arc;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};

pub(crate) use text::LARGEST_EXPONENT;

/// An exact rational number p/q in lowest terms, where q > 0.
///
/// Numbers whose numerator and denominator fit into 63 bits need no allocation.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Rational(Repr);

/// The representation of a number, which is unique. `Big` holds only numbers with |p| or q above
/// `i64::MAX`. Since `i64::MIN` is stored in `Big`, negating a `Small` cannot overflow.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Repr {
    Small { num: i64, den: i64 },
    Big(Arc<BigRational>),
}

impl Rational {
    /// The number 0.
    pub const ZERO: Self = Self(Repr::Small { num: 0, den: 1 });
    /// The number 1.
    pub const ONE: Self = Self(Repr::Small { num: 1, den: 1 });

    /// Returns the fraction `num/den` in lowest terms.
    ///
    /// # Panics
    /// If `den` is zero.
    pub fn new(num: i64, den: i64) -> Self {
        assert!(den != 0, "a rational needs a denominator other than zero");
        if den == 1 && num != i64::MIN {
            return Self(Repr::Small { num, den });
        }
        let divisor = gcd(num.unsigned_abs(), den.unsigned_abs());
        let sign = if den < 0 { -1 } else { 1 };
        Self::from_reduced(
            sign * i128::from(num) / i128::from(divisor),
            sign * i128::from(den) / i128::from(divisor),
        )
    }

    /// Returns the number 0.
    pub fn zero() -> Self {
        Self::ZERO
    }

    /// Returns the number 1.
    pub fn one() -> Self {
        Self::ONE
    }

    /// Returns the exact value of a finite float; `None` for infinities and NaN.
    pub fn from_f64(value: f64) -> Option<Self> {
        if !value.is_finite() {
            return None;
        }
        let (bits, sign) = (value.abs().to_bits(), if value < 0.0 { -1 } else { 1 });
        let (exponent, fraction) = ((bits >> 52) as i64, bits & ((1 << 52) - 1));
        // The absolute value is significand·2^exponent.
        let significand = if exponent == 0 { fraction } else { fraction | 1 << 52 };
        if significand == 0 {
            return Some(Self::ZERO);
        }
        let even = significand.trailing_zeros();
        let (odd, exponent) = (sign * (significand >> even) as i64, exponent.max(1) - 1075 + i64::from(even));
        Some(match exponent {
            0..10 => Self(Repr::Small { num: odd << exponent, den: 1 }),
            -62..0 => Self(Repr::Small { num: odd, den: 1 << -exponent }),
            10.. => Self::from(BigInt::from(odd) << exponent),
            _ => Self::from_normal(BigRational::new_raw(odd.into(), BigInt::one() << -exponent)),
        })
    }

    /// Returns p and k if the absolute value of the number is p/2ᵏ and p fits into 64 bits.
    fn dyadic(&self) -> Option<(u64, u64)> {
        match &self.0 {
            Repr::Small { num, den } => {
                (*den as u64).is_power_of_two().then(|| (num.unsigned_abs(), den.trailing_zeros().into()))
            }
            Repr::Big(big) => {
                let shift = big.denom().trailing_zeros()?;
                let magnitude = big.numer().magnitude().to_u64()?;
                (big.denom().bits() == shift + 1).then_some((magnitude, shift))
            }
        }
    }

    /// Converts the number to a big rational.
    pub fn to_big(&self) -> BigRational {
        match &self.0 {
            Repr::Small { num, den } => BigRational::new_raw(BigInt::from(*num), BigInt::from(*den)),
            Repr::Big(big) => (**big).clone(),
        }
    }

    /// Returns the numerator p, which has the sign of the number.
    pub fn numerator(&self) -> BigInt {
        match &self.0 {
            Repr::Small { num, .. } => BigInt::from(*num),
            Repr::Big(big) => big.numer().clone(),
        }
    }

    /// Returns the denominator q, which is positive.
    pub fn denominator(&self) -> BigInt {
        match &self.0 {
            Repr::Small { den, .. } => BigInt::from(*den),
            Repr::Big(big) => big.denom().clone(),
        }
    }

    /// Returns the number as an `i64`, if it is an integer that fits.
    pub fn as_i64(&self) -> Option<i64> {
        match &self.0 {
            Repr::Small { num, den: 1 } => Some(*num),
            Repr::Small { .. } => None,
            Repr::Big(big) if big.is_integer() => big.numer().to_i64(),
            Repr::Big(_) => None,
        }
    }

    /// Returns the numerator and the denominator, if the absolute values of both are at most
    /// `i64::MAX`.
    pub fn as_small_ratio(&self) -> Option<(i64, i64)> {
        match &self.0 {
            Repr::Small { num, den } => Some((*num, *den)),
            Repr::Big(_) => None,
        }
    }

    /// Returns the numerator and the denominator if both are at most 2²⁴ in absolute value. Both
    /// are then exact in `f32`.
    pub fn as_short_ratio(&self) -> Option<(i64, i64)> {
        const EXACT_IN_F32: i64 = 1 << 24;
        self.as_small_ratio().filter(|(p, q)| p.abs().max(*q) <= EXACT_IN_F32)
    }

    /// Returns whether the number is 0.
    pub fn is_zero(&self) -> bool {
        matches!(self.0, Repr::Small { num: 0, .. })
    }

    /// Returns whether the number is 1.
    pub fn is_one(&self) -> bool {
        matches!(self.0, Repr::Small { num: 1, den: 1 })
    }

    /// Returns whether the number is negative.
    pub fn is_negative(&self) -> bool {
        match &self.0 {
            Repr::Small { num, .. } => *num < 0,
            Repr::Big(big) => big.is_negative(),
        }
    }

    /// Returns whether the number is an integer.
    pub fn is_integer(&self) -> bool {
        match &self.0 {
            Repr::Small { den, .. } => *den == 1,
            Repr::Big(big) => big.is_integer(),
        }
    }

    /// Returns the bit length of |p| or of q, whichever is larger; at least 1.
    pub fn bits(&self) -> u64 {
        match &self.0 {
            Repr::Small { num, den } => {
                u64::from(64 - (num.unsigned_abs() | den.unsigned_abs()).leading_zeros())
            }
            Repr::Big(big) => big.numer().bits().max(big.denom().bits()),
        }
    }

    /// Wraps a big rational that is already in lowest terms with a positive denominator.
    fn from_normal(value: BigRational) -> Self {
        match (value.numer().to_i64(), value.denom().to_i64()) {
            (Some(num), Some(den)) if num != i64::MIN => Self(Repr::Small { num, den }),
            _ => Self(Repr::Big(Arc::new(value))),
        }
    }

    fn from_reduced(num: i128, den: i128) -> Self {
        const LIMIT: u128 = i64::MAX as u128;
        if num.unsigned_abs() <= LIMIT && den.unsigned_abs() <= LIMIT {
            return Self(Repr::Small { num: num as i64, den: den as i64 });
        }
        Self(Repr::Big(Arc::new(BigRational::new_raw(BigInt::from(num), BigInt::from(den)))))
    }
}

/// Returns the greatest common divisor by Euclid's algorithm. The gcd of 0 and b is b.
pub(crate) fn gcd(mut a: u64, mut b: u64) -> u64 {
    // The denominators of floats are powers of two, for which this is faster.
    if a != 0 && b.is_power_of_two() {
        return b.min(1 << a.trailing_zeros());
    }
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

impl Default for Rational {
    fn default() -> Self {
        Self::ZERO
    }
}

impl From<i64> for Rational {
    fn from(value: i64) -> Self {
        Self::new(value, 1)
    }
}

impl From<BigInt> for Rational {
    fn from(value: BigInt) -> Self {
        match value.to_i64() {
            Some(small) => Self::from(small),
            None => Self(Repr::Big(Arc::new(BigRational::new_raw(value, BigInt::one())))),
        }
    }
}

/// The denominator must be nonzero, which `BigRational::new_raw` does not check.
impl From<BigRational> for Rational {
    fn from(value: BigRational) -> Self {
        Self::from_normal(value.reduced())
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            (Repr::Small { num: a, den: 1 }, Repr::Small { num: b, den: 1 }) => a.cmp(b),
            (Repr::Small { num: a, den: b }, Repr::Small { num: c, den: d }) => {
                (i128::from(*a) * i128::from(*d)).cmp(&(i128::from(*c) * i128::from(*b)))
            }
            _ => self.to_big().cmp(&other.to_big()),
        }
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

#[cfg(test)]
pub(crate) fn is_canonical(value: &Rational) -> bool {
    match &value.0 {
        Repr::Small { num, den } => *den > 0 && *num != i64::MIN && gcd(num.unsigned_abs(), *den as u64) == 1,
        Repr::Big(big) => {
            let fits = big.numer().to_i64().is_some_and(|n| n != i64::MIN) && big.denom().to_i64().is_some();
            !fits && big.denom().is_positive() && big.reduced() == **big
        }
    }
}
