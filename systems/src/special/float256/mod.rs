//! Real numbers of 256 bits, or 77 decimal digits, for Kahan maps and formulas. The crate
//! `dashu-float` supplies arithmetic and correctly rounded elementary functions. No operation
//! panics: without a finite real value, the result is undefined.

mod arithmetic;
mod elementary;
mod text;

use core::cmp::Ordering;
use std::cell::RefCell;

use dashu_float::round::Rounded;
use dashu_float::round::mode::HalfEven;
use dashu_float::{ConstCache, Context, FBig, FpError, Repr};
use dashu_int::{IBig, Sign, UBig, Word};
use kahan_core::num_rational::BigRational;

pub use text::ParsePreciseError;

/// A real number of 256 bits (77 decimal digits), or an undefined value.
///
/// Arithmetic, square roots, conversions and elementary functions round once, to nearest. Results
/// that are infinite or complex (1/0, ln 0, √−1) are *undefined*. Like NaN, undefined values
/// propagate and differ from themselves.
///
/// [`Display`](core::fmt::Display) writes 60 significant digits, and `{:.n}` writes n.
/// [`FromStr`](core::str::FromStr) reads decimals (`-1.5e-3`) and fractions (`3/7`), rounded once.
/// An elementary function costs about a hundred sums or products.
///
/// ```
/// use kahan_systems::special::{Float256, Real};
///
/// let third: Float256 = "1/3".parse().unwrap();
/// assert_eq!(third.clone() + third.clone() + third, Float256::from_int(1));
/// assert_eq!(format!("{:.30}", Float256::pi()), "3.14159265358979323846264338328");
/// assert_ne!(Float256::from_int(-1).sqrt(), Float256::from_int(-1).sqrt());
/// ```
#[derive(Clone, Copy)]
pub struct Float256(Option<Number>);

/// The number ±significand·2^exponent with an odd significand, or zero with exponent 0.
#[derive(Clone, Copy, PartialEq)]
struct Number {
    sign: Sign,
    /// The 64-bit words of the significand, lowest first. Unused words are zero.
    words: [Word; BITS / Word::BITS as usize + 1],
    exponent: isize,
}

const BITS: usize = 256;

const CONTEXT: Context<HalfEven> = Context::new(BITS);

type Outcome = Result<Rounded<FBig<HalfEven, 2>>, FpError>;

thread_local! {
    /// The constants π and ln 2, computed once in each thread.
    static CACHE: RefCell<ConstCache> = const { RefCell::new(ConstCache::new()) };
}

impl Float256 {
    /// The value of results that are not finite or not real.
    pub const UNDEFINED: Self = Self(None);

    /// The number of bits of the significand.
    pub const BITS: usize = BITS;

    /// Returns whether the value is a number, not undefined.
    pub fn is_defined(&self) -> bool {
        self.0.is_some()
    }

    /// Rounds a rational to the nearest number.
    ///
    /// ```
    /// use kahan_core::num_rational::BigRational;
    /// use kahan_systems::special::Float256;
    ///
    /// let q = BigRational::new(3.into(), 8.into());
    /// assert_eq!(Float256::from_rational(&q), "0.375".parse().unwrap());
    /// ```
    pub fn from_rational(q: &BigRational) -> Self {
        let integer = |bytes: Vec<u8>| IBig::from_le_bytes(&bytes);
        quotient(&integer(q.numer().to_signed_bytes_le()), &integer(q.denom().to_signed_bytes_le()))
    }

    /// Returns the nearest `f64`, or NaN if the value is undefined.
    pub fn to_f64(&self) -> f64 {
        self.repr().map_or(f64::NAN, |repr| repr.to_f64().value())
    }

    fn repr(&self) -> Option<Repr<2>> {
        let Number { sign, words, exponent } = self.0?;
        Some(Repr::new(IBig::from_parts(sign, UBig::from_words(&words)), exponent))
    }

    fn from_outcome(outcome: Outcome) -> Self {
        match outcome {
            Ok(value) => Self::from_repr(value.value().into_repr()),
            Err(FpError::Underflow(_)) => Self::from_repr(Repr::zero()),
            Err(_) => Self::UNDEFINED,
        }
    }

    fn from_repr(repr: Repr<2>) -> Self {
        if repr.is_infinite() {
            return Self::UNDEFINED;
        }
        let (significand, exponent) = repr.into_parts();
        let (sign, digits) = significand.as_sign_words();
        let mut words = [0; _];
        words[..digits.len()].copy_from_slice(digits);
        // Zero has a unique representation; therefore equal numbers are equal as data.
        Self(Some(Number { sign, words, exponent: if significand.is_zero() { 0 } else { exponent } }))
    }
}

/// Returns p/q, rounded once to nearest. The result is undefined if q = 0.
fn quotient(p: &IBig, q: &IBig) -> Float256 {
    use dashu_int::ops::{Abs, BitTest, DivRem};

    if q.is_zero() {
        return Float256::UNDEFINED;
    }
    if p.is_zero() {
        return Float256::from_repr(Repr::zero());
    }
    let (p_bits, q_bits) = (p.bit_len() as isize, q.bit_len() as isize);
    // The quotient gets two extra bits, and a last bit that is 1 if the division has a remainder.
    // Rounding to 256 bits is then correct.
    let shift = (BITS as isize + 2 - (p_bits - q_bits)).max(0) as usize;
    let negative = p.sign() != q.sign();
    let (whole, rest) = (p.abs() << shift).div_rem(q.abs());
    let sticky = (whole << 1usize) + IBig::from(u8::from(!rest.is_zero()));
    let significand = if negative { -sticky } else { sticky };
    let exact = Repr::<2>::new(significand, -(shift as isize) - 1);
    Float256::from_repr(
        FBig::<HalfEven, 2>::from_repr(exact, Context::new(0)).with_precision(BITS).value().into_repr(),
    )
}

impl PartialEq for Float256 {
    fn eq(&self, other: &Self) -> bool {
        matches!((&self.0, &other.0), (Some(a), Some(b)) if a == b)
    }
}

impl PartialOrd for Float256 {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.repr()?.cmp(&other.repr()?))
    }
}

impl From<i64> for Float256 {
    fn from(n: i64) -> Self {
        Self::from_repr(Repr::new(n.into(), 0))
    }
}

impl From<f64> for Float256 {
    /// The conversion is exact. Infinities and NaN become undefined.
    fn from(x: f64) -> Self {
        Repr::try_from(x).map_or(Self::UNDEFINED, Self::from_repr)
    }
}
