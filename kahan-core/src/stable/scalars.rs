//! Which scalars rungs work in, and which steps are promised in.

use crate::Dd;
use crate::scalar::{BITS_OF_DOUBLE_STEPS, BITS_OF_SINGLE_STEPS, Size, Wide};

use super::bounded::{Bounded, Working, operations};
use super::number::{Number, Range, power_of_two};
use super::pair::{Both, Pair};

/// A scalar that steps can be promised in, and begin in.
pub(crate) trait Promised: Working {
    /// A value and its magnitude, side by side in a register if there is such a one.
    type Packed: Pair<Self>;

    /// The same number.
    fn widen(&self) -> Wide;
    /// The nearest one.
    fn narrow(value: Wide) -> Self;
}

/// One whose second rung is the next wider scalar.
pub(crate) trait Widened: Promised {
    /// That scalar.
    type Wider: Promised;

    /// The same number.
    fn embed(&self) -> Self::Wider;
    /// The nearest one.
    fn round(value: Self::Wider) -> Self;
}

impl Widened for f32 {
    type Wider = f64;

    #[inline(always)]
    fn embed(&self) -> f64 {
        (*self).into()
    }

    #[inline(always)]
    fn round(value: f64) -> Self {
        value as f32
    }
}

impl Widened for f64 {
    type Wider = Dd;

    #[inline(always)]
    fn embed(&self) -> Dd {
        (*self).into()
    }

    #[inline(always)]
    fn round(value: Dd) -> Self {
        value.into()
    }
}

/// That of `f32`: 2¹⁰·2⁹⁹·η is the allowance for η = 2⁻¹⁴⁹. Narrow, but what it leaves out has only to be computed in `f64`.
const SINGLE: Range = Range {
    allowance: power_of_two(-40),
    bits_of_products: 99,
    bits_of_divisors: 4,
    bits_of_steps: BITS_OF_SINGLE_STEPS,
};

/// That of `f64`, and of pairs of them: 2¹⁰·2⁸⁶⁰·η is far below the allowance for η = 2⁻¹⁰⁷⁰ and less.
const DOUBLE: Range = Range {
    allowance: power_of_two(-150),
    bits_of_products: 860,
    bits_of_divisors: 120,
    bits_of_steps: BITS_OF_DOUBLE_STEPS,
};

impl Number for f32 {
    type Magnitude = f32;
    const UNIT: f64 = f32::EPSILON as f64 / 2.0;
    const RANGE: Range = SINGLE;

    #[inline(always)]
    fn size(&self) -> f32 {
        self.abs()
    }
}

impl Working for f32 {
    operations!(inline(always));
}

impl Number for f64 {
    type Magnitude = f64;
    const UNIT: f64 = f64::EPSILON / 2.0;
    const RANGE: Range = DOUBLE;

    #[inline(always)]
    fn size(&self) -> f64 {
        self.abs()
    }
}

impl Working for f64 {
    operations!(inline(always));
}

impl Number for Dd {
    type Magnitude = f64;
    /// 16 u² of `f64`, at least the bound of each of its operations.
    const UNIT: f64 = f64::EPSILON * f64::EPSILON * 4.0;
    const RANGE: Range = DOUBLE;

    #[inline(always)]
    fn size(&self) -> f64 {
        self.high().abs()
    }
}

impl Working for Dd {
    operations!(inline(never));
}

impl Number for Wide {
    type Magnitude = Size;
    const UNIT: f64 = f64::from_bits(((1023 + Wide::UNIT_EXPONENT) as u64) << 52);
    /// No step over these divides by ε.
    const RANGE: Range =
        Range { allowance: 0.0, bits_of_products: 860, bits_of_divisors: 0, bits_of_steps: 0 };

    fn size(&self) -> Size {
        Wide::size(self)
    }

    fn radius(&self) -> Option<Size> {
        Some(Wide::radius(self))
    }
}

impl Working for Wide {
    operations!(inline(never));
}

impl Promised for f32 {
    #[cfg(target_arch = "x86_64")]
    type Packed = super::packed::PackedSingle;
    #[cfg(not(target_arch = "x86_64"))]
    type Packed = Both<f32>;

    fn widen(&self) -> Wide {
        Wide::from(*self)
    }

    fn narrow(value: Wide) -> Self {
        value.to_f32()
    }
}

impl Promised for f64 {
    #[cfg(target_arch = "x86_64")]
    type Packed = super::packed::Packed;
    #[cfg(not(target_arch = "x86_64"))]
    type Packed = Both<f64>;

    fn widen(&self) -> Wide {
        Wide::from(*self)
    }

    fn narrow(value: Wide) -> Self {
        value.to_f64()
    }
}

impl Promised for Dd {
    type Packed = Both<Dd>;

    fn widen(&self) -> Wide {
        Wide::from_double_double(self.high(), self.low())
    }

    fn narrow(value: Wide) -> Self {
        let (high, low) = value.to_double_double();
        Dd::new(high, low)
    }
}
