//! Quotients of big integers, and an arithmetic of such quotients that computes no gcds.

use core::fmt;

use dashu_int::IBig;
use dashu_int::ops::Gcd;
use kahan_algebra::arithmetic::Arithmetic;
use kahan_algebra::rational::Rational;

use crate::heights::{denominator, numerator, rational};

/// A quotient of integers with a nonzero divisor, not necessarily in lowest terms.
///
/// [`ExactOrbit`](crate::orbit::ExactOrbit) returns fractions in lowest terms. `Display` writes
/// `p/q` or `p`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fraction {
    above: IBig,
    below: IBig,
}

impl Fraction {
    pub(crate) fn times_quotient(&self, above: &IBig, below: &IBig) -> Self {
        Fraction { above: &self.above * above, below: &self.below * below }
    }

    pub(crate) fn equals(&self, other: &Fraction) -> bool {
        &self.above * &other.below == &self.below * &other.above
    }

    pub(crate) fn reduced(self) -> Fraction {
        let common = IBig::from((&self.above).gcd(&self.below));
        let common = if self.below < IBig::ZERO { -common } else { common };
        Fraction { above: self.above / &common, below: self.below / &common }
    }
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.above.fmt(f)?;
        if self.below == IBig::ONE { Ok(()) } else { write!(f, "/{}", self.below) }
    }
}

impl From<&Rational> for Fraction {
    fn from(value: &Rational) -> Self {
        Fraction { above: numerator(value), below: denominator(value).into() }
    }
}

impl From<&Fraction> for Rational {
    fn from(value: &Fraction) -> Self {
        rational(&value.above, &value.below)
    }
}

/// The arithmetic of rational numbers as [`Fraction`]s, without gcds.
pub(crate) struct Fractions;

impl Arithmetic for Fractions {
    type Value = Fraction;
    type Constant = Rational;

    fn constant(&self, value: &Rational) -> Option<Fraction> {
        Some(Fraction::from(value))
    }

    fn add(&self, a: &Fraction, b: &Fraction) -> Fraction {
        if a.below == b.below {
            return Fraction { above: &a.above + &b.above, below: a.below.clone() };
        }
        Fraction { above: &a.above * &b.below + &b.above * &a.below, below: &a.below * &b.below }
    }

    fn subtract(&self, a: &Fraction, b: &Fraction) -> Fraction {
        self.add(a, &self.negate(b))
    }

    fn multiply(&self, a: &Fraction, b: &Fraction) -> Fraction {
        Fraction { above: &a.above * &b.above, below: &a.below * &b.below }
    }

    fn negate(&self, a: &Fraction) -> Fraction {
        Fraction { above: -&a.above, below: a.below.clone() }
    }

    fn divide(&self, a: &Fraction, b: &Fraction) -> Option<Fraction> {
        if self.is_zero(b) {
            return None;
        }
        // For equal denominators, the quotient is that of the numerators.
        if a.below == b.below {
            return Some(Fraction { above: a.above.clone(), below: b.above.clone() });
        }
        Some(Fraction { above: &a.above * &b.below, below: &a.below * &b.above })
    }

    fn is_zero(&self, a: &Fraction) -> bool {
        a.above.is_zero()
    }
}
