//! The interface that the number formats of bounded values implement.

use core::fmt::Debug;
use core::ops::{Div, Mul};

use num_traits::Zero;

use crate::scalar::{Scalar, Size};

/// Nonnegative numbers for error bounds. Comparisons with NaN are false.
pub(crate) trait Magnitude:
    Copy + Debug + PartialOrd + Zero + Mul<Output = Self> + Div<Output = Self> + Into<f64>
{
    fn of(value: f64) -> Self;
}

impl Magnitude for f32 {
    #[inline(always)]
    fn of(value: f64) -> Self {
        value as f32
    }
}

impl Magnitude for f64 {
    #[inline(always)]
    fn of(value: f64) -> Self {
        value
    }
}

impl Magnitude for Size {
    fn of(value: f64) -> Self {
        Self::from(value)
    }
}

/// The range in which a format allows products and quotients; see [`bounded`](super).
pub(crate) struct Range {
    /// An upper bound of all errors of underflow, 0 if no operation underflows.
    pub(crate) allowance: f64,
    /// The upper limit of products of inputs is 2 to the power `bits_of_products`.
    pub(crate) bits_of_products: u32,
    /// The lower limit of divisors is 2 to the power −`bits_of_divisors`.
    pub(crate) bits_of_divisors: u32,
    /// With n = `bits_of_steps`, steps may divide by ε if 2⁻ⁿ ≤ |ε| ≤ 2ⁿ. If n is 0, they never
    /// divide by ε.
    pub(crate) bits_of_steps: u32,
}

const POWER_OF_UNDERFLOWS: i32 = 10;

/// The largest number of underflows per formula that error bounds cover.
pub(crate) const MOST_UNDERFLOWS: u32 = 1 << POWER_OF_UNDERFLOWS;

impl Range {
    /// The range of a format that never underflows. Steps do not divide by ε.
    pub(crate) const UNLIMITED: Self =
        Self { allowance: 0.0, bits_of_products: u32::MAX, bits_of_divisors: 0, bits_of_steps: 0 };

    /// Creates a range. `eta` is the binary exponent of the largest error of an underflow.
    pub(crate) const fn of(eta: i32, allowance: i32, bits_of_divisors: u32, bits_of_steps: u32) -> Self {
        let bits_of_products = (allowance - eta - POWER_OF_UNDERFLOWS) as u32;
        Self { allowance: power_of_two(allowance), bits_of_products, bits_of_divisors, bits_of_steps }
    }

    #[inline(always)]
    pub(crate) const fn least_divisor(&self) -> f64 {
        if self.allowance > 0.0 { power_of_two(-(self.bits_of_divisors as i32)) } else { 0.0 }
    }
}

/// Returns 2^power. The result must be a normal double.
pub(crate) const fn power_of_two(power: i32) -> f64 {
    f64::from_bits(((1023 + power) as u64) << 52)
}

/// A scalar whose operations round once, with a bounded relative error.
pub(crate) trait Number: Scalar + Copy {
    type Magnitude: Magnitude;
    /// The largest relative error of an operation without underflow.
    const UNIT: f64;
    const RANGE: Range;
    /// Whether operations with bounds are called instead of inlined, which keeps steps small.
    const IS_CALLED: bool = false;

    /// Returns |self|, rounded to a magnitude.
    fn size(&self) -> Self::Magnitude;
    /// Returns the error radius, or `None` if the type of number stores none.
    #[inline(always)]
    fn radius(&self) -> Option<Self::Magnitude> {
        None
    }
}
