//! Double-double arithmetic for evaluations at a point and for explicit methods. Its operations are
//! those of compiled steps.

use kahan_algebra::arithmetic::Arithmetic;
use kahan_algebra::rational::Rational;
use kahan_core::{Dd, Scalar};

use super::number::Number;
use super::scalar::{Printable, ScalarKind};

/// The arithmetic of [`Dd`].
#[derive(Clone, Copy, Debug)]
pub struct DoubleDouble;

impl Arithmetic for DoubleDouble {
    type Value = Dd;
    type Constant = Rational;

    fn constant(&self, value: &Rational) -> Option<Dd> {
        Some(Self::round(value))
    }

    fn add(&self, a: &Dd, b: &Dd) -> Dd {
        *a + *b
    }

    fn subtract(&self, a: &Dd, b: &Dd) -> Dd {
        *a - *b
    }

    fn multiply(&self, a: &Dd, b: &Dd) -> Dd {
        *a * *b
    }

    fn negate(&self, a: &Dd) -> Dd {
        -*a
    }

    fn divide(&self, a: &Dd, b: &Dd) -> Option<Dd> {
        Some(*a / *b)
    }

    fn multiply_add(&self, a: &Dd, b: &Dd, c: &Dd) -> Dd {
        a.multiply_add(*b, *c)
    }

    fn multiply_subtract(&self, a: &Dd, b: &Dd, c: &Dd) -> Dd {
        a.multiply_subtract(*b, *c)
    }

    fn subtract_product(&self, a: &Dd, b: &Dd, c: &Dd) -> Dd {
        a.subtract_product(*b, *c)
    }

    fn is_zero(&self, a: &Dd) -> bool {
        a.high() == 0.0
    }

    fn is_better_pivot(&self, a: &Dd, than: &Dd) -> bool {
        Scalar::is_better_pivot(a, than)
    }
}

impl Printable for DoubleDouble {
    const KIND: ScalarKind = ScalarKind::Dd;

    /// Returns the nearest `f64` plus the `f64` nearest to the remainder.
    fn round(value: &Rational) -> Dd {
        let (high, low) = value.to_double_double();
        Dd::new(high, low)
    }

    fn number(value: &Dd) -> Number {
        Number::Dd(*value)
    }
}
