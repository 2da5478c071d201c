//! Exact rationals.

use kahan_syntax::rational::Rational;

use super::Arithmetic;

/// ℚ.
#[derive(Clone, Copy, Debug)]
pub struct Exact;

impl Arithmetic for Exact {
    type Value = Rational;
    type Constant = Rational;

    fn constant(&self, value: &Rational) -> Option<Rational> {
        Some(value.clone())
    }

    fn add(&self, a: &Rational, b: &Rational) -> Rational {
        a + b
    }

    fn subtract(&self, a: &Rational, b: &Rational) -> Rational {
        a - b
    }

    fn multiply(&self, a: &Rational, b: &Rational) -> Rational {
        a * b
    }

    fn negate(&self, a: &Rational) -> Rational {
        -a
    }

    fn divide(&self, a: &Rational, b: &Rational) -> Option<Rational> {
        a.checked_div(b)
    }

    fn is_zero(&self, a: &Rational) -> bool {
        a.is_zero()
    }
}
