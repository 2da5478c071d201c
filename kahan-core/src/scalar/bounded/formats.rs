//! The number formats of bounded values, and the range in which each format allows products and
//! quotients.

use crate::Dd;
use crate::scalar::tuning::{BITS_OF_DOUBLE_STEPS, BITS_OF_SINGLE_STEPS};
use crate::scalar::{Size, Wide};

use super::number::{Number, Range};

/// The binary exponent of η for each format. The largest error of an operation that underflows is
/// η.
const LOST_OF_SINGLES: i32 = -149;
const LOST_OF_DOUBLES: i32 = -1074;
// Every float operation within an operation on pairs may underflow.
const LOST_OF_PAIRS: i32 = -1070;

/// A narrow range. Steps with inputs outside this range are computed in `f64`.
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
    /// 16u² for the rounding unit u of `f64`, which is at least the error bound of every operation.
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
