//! The number formats of bounded values, with the range of products and quotients in each format.

use crate::Dd;
use crate::scalar::tuning::{BITS_OF_DOUBLE_STEPS, BITS_OF_SINGLE_STEPS};
use crate::scalar::{Size, Wide};

use super::number::{Number, Range};

/// The binary exponent of the largest underflow error of an `f32` operation.
const LOST_OF_SINGLES: i32 = -149;
const LOST_OF_DOUBLES: i32 = -1074;
// The binary exponent of a bound on the underflow error of an operation on pairs of floats.
const LOST_OF_PAIRS: i32 = -1070;

/// The range of inputs for which `f32` bounds hold. Beyond it, a step is computed in `f64`.
const SINGLE: Range = Range::of(LOST_OF_SINGLES, -40, 4, BITS_OF_SINGLE_STEPS);

const ALLOWANCE_OF_DOUBLES: i32 = -150;
const BITS_OF_DOUBLE_DIVISORS: u32 = 120;

impl Number for f32 {
    type Magnitude = f32;
    const UNIT: f64 = f32::EPSILON as f64 / 2.0;
    const RANGE: Range = SINGLE;

    #[inline(always)]
    fn size(&self) -> f32 {
        self.abs()
    }
}

impl Number for f64 {
    type Magnitude = f64;
    const UNIT: f64 = f64::EPSILON / 2.0;
    const RANGE: Range =
        Range::of(LOST_OF_DOUBLES, ALLOWANCE_OF_DOUBLES, BITS_OF_DOUBLE_DIVISORS, BITS_OF_DOUBLE_STEPS);

    #[inline(always)]
    fn size(&self) -> f64 {
        self.abs()
    }
}

impl Number for Dd {
    type Magnitude = f64;
    const IS_CALLED: bool = true;
    /// A bound of 16u² for every operation on pairs, where u is the rounding unit of `f64`.
    const UNIT: f64 = f64::EPSILON * f64::EPSILON * 4.0;
    const RANGE: Range =
        Range::of(LOST_OF_PAIRS, ALLOWANCE_OF_DOUBLES, BITS_OF_DOUBLE_DIVISORS, BITS_OF_DOUBLE_STEPS);

    #[inline(always)]
    fn size(&self) -> f64 {
        self.high().abs()
    }
}

impl Number for Wide {
    type Magnitude = Size;
    const IS_CALLED: bool = true;
    const UNIT: f64 = f64::from_bits(((1023 + Wide::UNIT_EXPONENT) as u64) << 52);
    const RANGE: Range = Range::UNLIMITED;

    fn size(&self) -> Size {
        Wide::size(self)
    }

    fn radius(&self) -> Option<Size> {
        Some(Wide::radius(self))
    }
}
