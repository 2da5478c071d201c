//! Exact numbers known at run time, as constants that every scalar can be built from.

use kahan_algebra::rational::Rational;
use kahan_core::{Constant, Scalar};
use smallvec::{SmallVec, smallvec};

/// A number in a field's text: a ratio of machine integers, or 64-bit limbs if it is too long.
#[derive(Clone, Debug)]
pub(crate) enum Literal {
    Short(Constant<'static>),
    /// A long number: 64-bit limbs in little-endian order, the nearest floats, and in `low` the
    /// difference between the number and `double`.
    Long {
        negative: bool,
        numerator: SmallVec<[u64; 2]>,
        denominator: SmallVec<[u64; 2]>,
        single: f32,
        double: f64,
        low: f64,
    },
}

impl From<&Rational> for Literal {
    fn from(value: &Rational) -> Self {
        if let Some(integer) = value.as_i64() {
            return Self::Short(Constant::integer(integer));
        }
        if let Some((p, q)) = value.as_short_ratio() {
            return Self::Short(Constant::ratio(p, q));
        }
        let (double, low) = value.to_double_double();
        let (numerator, denominator) = match value.as_small_ratio() {
            Some((p, q)) => (smallvec![p.unsigned_abs()], smallvec![q.unsigned_abs()]),
            None => (
                value.numerator().iter_u64_digits().collect(),
                value.denominator().iter_u64_digits().collect(),
            ),
        };
        Self::Long {
            negative: value.is_negative(),
            numerator,
            denominator,
            single: value.to_f32(),
            double,
            low,
        }
    }
}

impl Literal {
    pub(crate) fn as_constant(&self) -> Constant<'_> {
        match self {
            Self::Short(constant) => *constant,
            Self::Long { negative, numerator, denominator, single, double, low } => {
                Constant::exact(*negative, numerator, denominator, *single, *double, *low)
            }
        }
    }
}

/// Returns the scalar nearest to a number. As in generated code, the number is rounded once.
#[must_use]
pub fn round<T: Scalar>(value: &Rational) -> T {
    T::constant(&Literal::from(value).as_constant())
}
