//! The formats that bounded values are computed in, and what the range of each leaves to products
//! and quotients.

use crate::Dd;
use crate::scalar::tuning::{BITS_OF_DOUBLE_STEPS, BITS_OF_SINGLE_STEPS};
use crate::scalar::{Size, Wide};

use super::number::{Number, Range, power_of_two};
use super::pair::Pair;
use super::{Bounded, Working, operations};

/// That of `f32`: 2¹⁰·2⁹⁹·η is the allowance for η = 2⁻¹⁴⁹. Narrow, but what it leaves out has only
/// to be computed in `f64`.
const SINGLE: Range = Range {
    allowance: power_of_two(-40),
    bits_of_products: 99,
    bits_of_divisors: 4,
    bits_of_steps: BITS_OF_SINGLE_STEPS,
};

/// That of `f64`, and of pairs of them: 2¹⁰·2⁸⁶⁰·η is far below the allowance for η = 2⁻¹⁰⁷⁰ and
/// less.
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
