//! Arithmetics of rationals, residues and binary floats. Floats divide by zero without an error.

use kahan_syntax::rational::Rational;

use crate::prime_field::PrimeField;

use super::Arithmetic;

macro_rules! operators {
    ($value:ty) => {
        type Value = $value;
        type Constant = Rational;

        fn add(&self, a: &$value, b: &$value) -> $value {
            a + b
        }

        fn subtract(&self, a: &$value, b: &$value) -> $value {
            a - b
        }

        fn multiply(&self, a: &$value, b: &$value) -> $value {
            a * b
        }

        fn negate(&self, a: &$value) -> $value {
            -a
        }
    };
}

/// The arithmetic of rationals ℚ.
#[derive(Clone, Copy, Debug)]
pub struct Exact;

impl Arithmetic for Exact {
    operators!(Rational);

    fn constant(&self, value: &Rational) -> Option<Rational> {
        Some(value.clone())
    }

    fn divide(&self, a: &Rational, b: &Rational) -> Option<Rational> {
        a.checked_div(b)
    }

    fn is_zero(&self, a: &Rational) -> bool {
        a.is_zero()
    }
}

/// The arithmetic of residues in a prime field.
#[derive(Clone, Copy, Debug)]
pub struct Modular(pub PrimeField);

impl Arithmetic for Modular {
    type Value = u64;
    type Constant = Rational;

    fn constant(&self, value: &Rational) -> Option<u64> {
        self.0.reduce(value)
    }

    fn add(&self, a: &u64, b: &u64) -> u64 {
        self.0.add(*a, *b)
    }

    fn subtract(&self, a: &u64, b: &u64) -> u64 {
        self.0.sub(*a, *b)
    }

    fn multiply(&self, a: &u64, b: &u64) -> u64 {
        self.0.mul(*a, *b)
    }

    fn negate(&self, a: &u64) -> u64 {
        self.0.neg(*a)
    }

    fn divide(&self, a: &u64, b: &u64) -> Option<u64> {
        self.0.inverse(*b).map(|inverse| self.0.mul(*a, inverse))
    }

    fn is_zero(&self, a: &u64) -> bool {
        *a == 0
    }
}

macro_rules! float {
    ($(#[$doc:meta])* $name:ident, $float:ty, $round:ident, $most:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $name;

        impl Arithmetic for $name {
            operators!($float);

            fn constant(&self, value: &Rational) -> Option<$float> {
                Some(value.$round())
            }

            fn divide(&self, a: &$float, b: &$float) -> Option<$float> {
                Some(a / b)
            }

            /// Returns `false` if formulas divided by this ε could overflow or underflow.
            fn is_moderate(&self, eps: &$float) -> bool {
                (1.0 / $most..=$most).contains(&eps.abs())
            }

            fn is_zero(&self, a: &$float) -> bool {
                *a == 0.0
            }

            fn is_better_pivot(&self, a: &$float, than: &$float) -> bool {
                a.abs() > than.abs()
            }
        }
    };
}

float!(
    /// Arithmetic in `f64`. Steps divide by ε only if 2⁻⁶⁴ ≤ |ε| ≤ 2⁶⁴.
    Float64, f64, to_f64, 18_446_744_073_709_551_616.0
);
float!(
    /// Arithmetic in `f32`. Steps divide by ε only if 2⁻¹⁶ ≤ |ε| ≤ 2¹⁶.
    Float32, f32, to_f32, 65_536.0
);
