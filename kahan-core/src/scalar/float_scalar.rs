//! Scalars that round, as against those that are exact.
//!
//! In: a float of any width. Out: what only rounded numbers need: compensated sums, coefficients that are not rational, an ε
//! of few bits.

use super::Scalar;

/// A scalar whose results are rounded to a fixed relative precision.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a floating-point scalar",
    label = "not a `FloatScalar`",
    note = "compensated and composed orbits are for scalars that round, such as `f32` and `f64`",
    note = "an exact scalar has no rounding error to carry, and the coefficients of the compositions are irrational"
)]
pub trait FloatScalar: Scalar + Copy {
    /// The number of bits such that the third power of a number with that many fits the scalar: 8 for `f32`, 17 for `f64`.
    const SHORT_BITS: u32;

    /// The nearest number with at most [`SHORT_BITS`](Self::SHORT_BITS) significant bits; what is not finite stays.
    fn nearest_short(self) -> Self;
}

macro_rules! implement_for_float {
    ($float:ty) => {
        impl FloatScalar for $float {
            const SHORT_BITS: u32 = <$float>::MANTISSA_DIGITS / 3;

            /// Ties away from zero; what would round beyond the largest number is cut off instead.
            fn nearest_short(self) -> Self {
                // Adjacent bit patterns are adjacent numbers, so rounding the pattern rounds the number.
                let dropped = <$float>::MANTISSA_DIGITS - Self::SHORT_BITS;
                let (unit, half) = (1 << dropped, 1 << (dropped - 1));
                let cut = |bits| <$float>::from_bits(bits & !(unit - 1));
                let nearest = cut(self.to_bits().wrapping_add(half));
                match (self.is_finite(), nearest.is_finite()) {
                    (true, true) => nearest,
                    (true, false) => cut(self.to_bits()),
                    (false, _) => self,
                }
            }
        }
    };
}

implement_for_float!(f32);
implement_for_float!(f64);
