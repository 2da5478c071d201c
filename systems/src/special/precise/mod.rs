//! A real number of 256 bits, 77 decimal digits, every operation rounded once to nearest.
//!
//! In: arithmetic and correctly rounded elementary functions of `dashu-float`. Out: a number type
//! of one fixed precision that runs through Kahan maps and formulas, and that never panics: what
//! has no finite real value is undefined, and stays so. Deliberately absent: infinities and signed
//! zeros.

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

/// A real number of 256 bits (77 decimal digits), or undefined.
///
/// The four operations, the square root, conversions and the elementary functions round once, to
/// nearest. A result that is infinite or not real (1/0, ln 0, √−1) is *undefined*, the one value
/// unequal to itself, as NaN is; so is everything computed from it. As text:
/// [`Display`](core::fmt::Display) gives 60 significant digits, `{:.n}` gives n, and
/// [`FromStr`](core::str::FromStr) reads decimals (`-1.5e-3`) and fractions (`3/7`), rounded once.
///
/// Cost: an elementary function takes as long as some hundred sums or products.
///
/// ```
/// use kahan_systems::special::{Precise, Real};
///
/// let third: Precise = "1/3".parse().unwrap();
/// assert_eq!(third.clone() + third.clone() + third, Precise::from_int(1));
/// assert_eq!(format!("{:.30}", Precise::pi()), "3.14159265358979323846264338328");
/// assert_ne!(Precise::from_int(-1).sqrt(), Precise::from_int(-1).sqrt());
/// ```
#[derive(Clone, Copy)]
pub struct Precise(Option<Number>);

/// ±significand·2^exponent, the significand odd or, with the exponent 0, 0.
#[derive(Clone, Copy, PartialEq)]
struct Number {
    sign: Sign,
    /// The lowest first. What the library rounds to so many bits can be some bits longer.
    words: [Word; BITS / Word::BITS as usize + 1],
    exponent: isize,
}

/// The bits of a [`Precise`].
const BITS: usize = 256;

const CONTEXT: Context<HalfEven> = Context::new(BITS);

type Outcome = Result<Rounded<FBig<HalfEven, 2>>, FpError>;

thread_local! {
    /// π and ln 2, computed once a thread.
    static CACHE: RefCell<ConstCache> = const { RefCell::new(ConstCache::new()) };
}

impl Precise {
    /// What has no finite real value.
    pub const UNDEFINED: Self = Self(None);

    /// The bits of the significand.
    pub const BITS: usize = BITS;

    /// Whether there is a value.
    pub fn is_defined(&self) -> bool {
        self.0.is_some()
    }

    /// The number nearest to a rational.
    ///
    /// ```
    /// use kahan_core::num_rational::BigRational;
    /// use kahan_systems::special::Precise;
    ///
    /// let q = BigRational::new(3.into(), 8.into());
    /// assert_eq!(Precise::from_rational(&q), "0.375".parse().unwrap());
    /// ```
    pub fn from_rational(q: &BigRational) -> Self {
        let integer = |bytes: Vec<u8>| IBig::from_le_bytes(&bytes);
        quotient(&integer(q.numer().to_signed_bytes_le()), &integer(q.denom().to_signed_bytes_le()))
    }

    /// The nearest `f64`; not a number where there is no value.
    pub fn to_f64(&self) -> f64 {
        self.repr().map_or(f64::NAN, |repr| repr.to_f64().value())
    }

    fn repr(&self) -> Option<Repr<2>> {
        let Number { sign, words, exponent } = self.0?;
        Some(Repr::new(IBig::from_parts(sign, UBig::from_words(&words)), exponent))
    }

    /// A finite result of the library, or undefined.
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
        // One zero only, so that equal numbers are equal everywhere.
        Self(Some(Number { sign, words, exponent: if significand.is_zero() { 0 } else { exponent } }))
    }
}

/// p/q rounded once to nearest; undefined for q = 0.
fn quotient(p: &IBig, q: &IBig) -> Precise {
    use dashu_int::ops::{Abs, BitTest, DivRem};

    if q.is_zero() {
        return Precise::UNDEFINED;
    }
    if p.is_zero() {
        return Precise::from_repr(Repr::zero());
    }
    let (p_bits, q_bits) = (p.bit_len() as isize, q.bit_len() as isize);
    // Two bits more than asked for, and a sticky bit for the remainder: the rounding below is then
    // the only one.
    let shift = (BITS as isize + 2 - (p_bits - q_bits)).max(0) as usize;
    let negative = p.sign() != q.sign();
    let (whole, rest) = (p.abs() << shift).div_rem(q.abs());
    let sticky = (whole << 1usize) + IBig::from(u8::from(!rest.is_zero()));
    let significand = if negative { -sticky } else { sticky };
    let exact = Repr::<2>::new(significand, -(shift as isize) - 1);
    Precise::from_repr(
        FBig::<HalfEven, 2>::from_repr(exact, Context::new(0)).with_precision(BITS).value().into_repr(),
    )
}

impl PartialEq for Precise {
    fn eq(&self, other: &Self) -> bool {
        matches!((&self.0, &other.0), (Some(a), Some(b)) if a == b)
    }
}

impl PartialOrd for Precise {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.repr()?.cmp(&other.repr()?))
    }
}

impl From<i64> for Precise {
    fn from(n: i64) -> Self {
        Self::from_repr(Repr::new(n.into(), 0))
    }
}

impl From<f64> for Precise {
    /// The number that `x` is; undefined where `x` is not finite.
    fn from(x: f64) -> Self {
        Repr::try_from(x).map_or(Self::UNDEFINED, Self::from_repr)
    }
}
