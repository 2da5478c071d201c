//! Which scalars rungs work in, and which steps are promised in.

use crate::scalar::{Size, Wide};
use crate::{Dd, Pivot};

use super::bounded::{ALLOWANCE, Bounded, Working, operations};
use super::number::Number;
use super::pair::Both;

/// A scalar that steps can be promised in.
pub(crate) trait Promised: Pivot + Copy {
    /// u: half the distance of 1 from the next larger number, for the machine's floats.
    const UNIT: f64;

    /// The same number.
    fn widen(&self) -> Wide;
    /// The nearest one.
    fn narrow(value: Wide) -> Self;
}

impl Number for f64 {
    type Magnitude = f64;
    const UNIT: f64 = f64::EPSILON / 2.0;
    const ALLOWANCE: f64 = ALLOWANCE;

    #[inline(always)]
    fn size(&self) -> f64 {
        self.abs()
    }
}

impl Working for f64 {
    #[cfg(target_arch = "x86_64")]
    type Pair = super::packed::Packed;
    #[cfg(not(target_arch = "x86_64"))]
    type Pair = Both<f64>;

    operations!(inline(always));
}

impl Number for Dd {
    type Magnitude = f64;
    /// 16 u² of `f64`, at least the bound of each of its operations.
    const UNIT: f64 = f64::EPSILON * f64::EPSILON * 4.0;
    const ALLOWANCE: f64 = ALLOWANCE;

    #[inline(always)]
    fn size(&self) -> f64 {
        self.high().abs()
    }
}

impl Working for Dd {
    type Pair = Both<Dd>;

    operations!(inline(never));
}

impl Number for Wide {
    type Magnitude = Size;
    /// Four times that of an operation, so that a constant, made by a division of cut off numbers, is one, too.
    const UNIT: f64 = f64::from_bits(((1023 + Wide::UNIT_EXPONENT + 2) as u64) << 52);
    const ALLOWANCE: f64 = 0.0;

    fn size(&self) -> Size {
        Wide::size(self)
    }

    fn is_exact(&self) -> bool {
        Wide::is_exact(self)
    }
}

impl Working for Wide {
    type Pair = Both<Wide>;

    operations!(inline(never));
}

impl Promised for f32 {
    const UNIT: f64 = f32::EPSILON as f64 / 2.0;

    fn widen(&self) -> Wide {
        Wide::from(*self)
    }

    fn narrow(value: Wide) -> Self {
        value.to_f32()
    }
}

impl Promised for f64 {
    const UNIT: f64 = f64::EPSILON / 2.0;

    fn widen(&self) -> Wide {
        Wide::from(*self)
    }

    fn narrow(value: Wide) -> Self {
        value.to_f64()
    }
}

impl Promised for Dd {
    /// That of its operations' bounds.
    const UNIT: f64 = <Self as Number>::UNIT;

    fn widen(&self) -> Wide {
        Wide::from_double_double(self.high(), self.low())
    }

    fn narrow(value: Wide) -> Self {
        let (high, low) = value.to_double_double();
        Dd::new(high, low)
    }
}
