//! Binary floats: the same operations, rounded; division by zero is infinite, not an error.

use kahan_syntax::rational::Rational;

use super::Arithmetic;

macro_rules! float {
    ($(#[$doc:meta])* $name:ident, $float:ty, $round:ident, $most:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $name;

        impl Arithmetic for $name {
            type Value = $float;
            type Constant = Rational;

            fn constant(&self, value: &Rational) -> Option<$float> {
                Some(value.$round())
            }

            fn add(&self, a: &$float, b: &$float) -> $float {
                a + b
            }

            fn subtract(&self, a: &$float, b: &$float) -> $float {
                a - b
            }

            fn multiply(&self, a: &$float, b: &$float) -> $float {
                a * b
            }

            fn negate(&self, a: &$float) -> $float {
                -a
            }

            fn divide(&self, a: &$float, b: &$float) -> Option<$float> {
                Some(a / b)
            }

            /// As generated code has it.
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
    /// `f64`.
    Float64, f64, to_f64, 18_446_744_073_709_551_616.0
);
float!(
    /// `f32`.
    Float32, f32, to_f32, 65_536.0
);
