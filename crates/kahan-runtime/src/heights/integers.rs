//! Big integers: an arithmetic over ℤ for plans, and conversions from and to rational numbers.

use dashu_int::ops::{Abs, BitTest, Gcd, UnsignedAbs};
use dashu_int::{IBig, Sign, UBig, Word};
use kahan_algebra::arithmetic::Arithmetic;
use kahan_algebra::plan::Plan;
use kahan_algebra::poly::Variable;
use kahan_algebra::rational::Rational;
use num_bigint::BigInt;

/// The arithmetic of ℤ, for programs whose constants and quotients are all integers.
#[derive(Clone, Copy, Debug)]
struct Integers;

impl Arithmetic for Integers {
    type Value = IBig;
    type Constant = Rational;

    fn constant(&self, value: &Rational) -> Option<IBig> {
        value.is_integer().then(|| numerator(value))
    }

    fn add(&self, a: &IBig, b: &IBig) -> IBig {
        a + b
    }

    fn subtract(&self, a: &IBig, b: &IBig) -> IBig {
        a - b
    }

    /// Returns a·b. If both are one object, squares it, which takes two thirds of the time.
    fn multiply(&self, a: &IBig, b: &IBig) -> IBig {
        if std::ptr::eq(a, b) { a.sqr().into() } else { a * b }
    }

    fn negate(&self, a: &IBig) -> IBig {
        -a
    }

    fn divide(&self, _: &IBig, _: &IBig) -> Option<IBig> {
        None
    }

    fn is_zero(&self, a: &IBig) -> bool {
        a.is_zero()
    }
}

pub(crate) fn values(plan: &Plan, point: &[IBig]) -> Vec<IBig> {
    let values =
        plan.evaluate(&Integers, |input| input.variable().map(|Variable(k)| point[usize::from(k)].clone()));
    values.into_iter().map(|value| value.expect("a polynomial divides by nothing")).collect()
}

pub(crate) fn numerator(value: &Rational) -> IBig {
    IBig::from_le_bytes(&value.numerator().to_signed_bytes_le())
}

pub(crate) fn denominator(value: &Rational) -> UBig {
    UBig::from_le_bytes(&value.denominator().magnitude().to_bytes_le())
}

/// Returns the quotient p/q in lowest terms; q must not be 0.
pub(crate) fn rational(numerator: &IBig, denominator: &IBig) -> Rational {
    let big = |value: &IBig| BigInt::from_signed_bytes_le(&value.to_le_bytes());
    let common = numerator.gcd(denominator);
    let (p, q) = (numerator / &common, denominator / &common);
    let p = Rational::from(big(&if q.sign() == Sign::Negative { -p } else { p }));
    let q = Rational::from(big(&q.abs()));
    p.checked_div(&q).expect("a denominator is not zero")
}

pub(crate) fn common_denominator<'a>(values: impl IntoIterator<Item = &'a Rational>) -> UBig {
    values.into_iter().fold(UBig::ONE, |multiple, value| {
        let denominator = denominator(value);
        let common = (&multiple).gcd(&denominator);
        multiple / common * denominator
    })
}

/// Returns the greatest common divisor; 0 if all values are 0. Starts with the two smallest values.
pub(crate) fn greatest_common_divisor<'a>(values: impl IntoIterator<Item = &'a IBig>) -> UBig {
    let mut values: Vec<&IBig> = values.into_iter().filter(|value| !value.is_zero()).collect();
    values.sort_by_key(|value| bits(value));
    let mut common = UBig::ZERO;
    for value in values {
        if common.is_one() {
            break;
        }
        common =
            if common.is_zero() { value.unsigned_abs() } else { short_gcd(&common, &value.unsigned_abs()) };
    }
    common
}

/// Returns gcd(a, b) for a ≠ 0; if b is longer than a, first reduces b modulo a.
pub(crate) fn short_gcd(a: &UBig, b: &UBig) -> UBig {
    if a.is_one() {
        return UBig::ONE;
    }
    if b.bit_len() < a.bit_len() {
        return if b.is_zero() { a.clone() } else { a.gcd(b) };
    }
    let rest = b % a;
    if rest.is_zero() { a.clone() } else { a.gcd(rest) }
}

pub(crate) fn bits(value: &IBig) -> usize {
    let words = value.as_sign_words().1;
    words.last().map_or(0, |top| words.len() * Word::BITS as usize - top.leading_zeros() as usize)
}
