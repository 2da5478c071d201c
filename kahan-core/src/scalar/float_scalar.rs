//! Scalars that round their results.

use super::{Dd, Scalar};

/// A scalar with a fixed relative precision, to which results are rounded.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a floating-point scalar",
    label = "not a `FloatScalar`",
    note = "compensated and composed orbits are for scalars that round, such as `f32`, `f64` and `Dd`",
    note = "an exact scalar has no rounding error to carry, and the coefficients of the compositions are irrational"
)]
pub trait FloatScalar: Scalar + Copy {
    /// Numbers of this many bits have exact cubes: 8 for `f32`, 17 for `f64`, 35 for `Dd`.
    const SHORT_BITS: u32;

    /// Returns the nearest number with at most [`SHORT_BITS`](Self::SHORT_BITS) significant bits.
    /// Infinities and NaN stay unchanged.
    fn nearest_short(self) -> Self;
}

macro_rules! implement_for_float {
    ($float:ty) => {
        impl FloatScalar for $float {
            const SHORT_BITS: u32 = <$float>::MANTISSA_DIGITS / 3;

            /// Rounds ties away from zero, but never to infinity.
            fn nearest_short(self) -> Self {
                // Adjacent floats have adjacent bit patterns. Therefore rounding the pattern as an
                // integer rounds the float.
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

impl FloatScalar for Dd {
    const SHORT_BITS: u32 = 35;

    /// Rounds ties away from zero, but never to infinity.
    fn nearest_short(self) -> Self {
        const DROPPED: u32 = f64::MANTISSA_DIGITS - Dd::SHORT_BITS;
        const UNIT: u64 = 1 << DROPPED;

        let high = self.high();
        if !high.is_finite() {
            return self;
        }
        // If the high part is halfway between two short numbers, the sign of the low part decides.
        let below_middle = self.low() != 0.0 && (self.low() > 0.0) != (high > 0.0);
        let cut = |bits: u64| f64::from_bits(bits & !(UNIT - 1));
        let nearest = cut(high.to_bits() + (UNIT / 2 - u64::from(below_middle)));
        Dd::from(if nearest.is_finite() { nearest } else { cut(high.to_bits()) })
    }
}
