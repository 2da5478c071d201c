//! The numbers that rungs compute in.

use core::fmt::Debug;
use core::ops::{Div, Mul};

use num_traits::Zero;

use crate::scalar::{Scalar, Size};

/// What bounds on errors are made of: numbers that are not negative, in which a few digits are
/// enough. What is not a number is neither more nor less than any.
pub(crate) trait Magnitude:
    Copy + Debug + PartialOrd + Zero + Mul<Output = Self> + Div<Output = Self> + Into<f64>
{
    /// The nearest magnitude.
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

/// What the range of a format leaves to products and quotients, see [`bounded`](super).
pub(crate) struct Range {
    /// More than all errors of underflow; 0 where nothing underflows.
    pub(crate) allowance: f64,
    /// B: no product of inputs exceeds 2ᴮ.
    pub(crate) bits_of_products: u32,
    /// No divisor is below 2 to minus this power.
    pub(crate) bits_of_divisors: u32,
    /// No ε that a step divides by is below 2 to minus this power; 0 where none is divided by.
    pub(crate) bits_of_steps: u32,
}

/// The power of two up to which operations of a formula may underflow, one after the other: w.
const POWER_OF_UNDERFLOWS: i32 = 10;

/// The largest w that the allowance of a format is made for.
pub(crate) const MOST_UNDERFLOWS: u32 = 1 << POWER_OF_UNDERFLOWS;

impl Range {
    /// Nothing underflows, and no step is divided by ε.
    pub(crate) const UNLIMITED: Self =
        Self { allowance: 0.0, bits_of_products: u32::MAX, bits_of_divisors: 0, bits_of_steps: 0 };

    /// Where an operation that underflows is off by 2^eta at most, and 2^allowance is allowed for
    /// all of them: B is what w·2ᴮ·η leaves.
    pub(crate) const fn of(eta: i32, allowance: i32, bits_of_divisors: u32, bits_of_steps: u32) -> Self {
        let bits_of_products = (allowance - eta - POWER_OF_UNDERFLOWS) as u32;
        Self { allowance: power_of_two(allowance), bits_of_products, bits_of_divisors, bits_of_steps }
    }

    /// The least divisor; 0 where nothing underflows.
    #[inline(always)]
    pub(crate) const fn least_divisor(&self) -> f64 {
        if self.allowance > 0.0 { power_of_two(-(self.bits_of_divisors as i32)) } else { 0.0 }
    }
}

/// 2^power for powers of normal doubles.
pub(crate) const fn power_of_two(power: i32) -> f64 {
    f64::from_bits(((1023 + power) as u64) << 52)
}

/// A scalar to work in: its operations round once, relative to their result.
pub(crate) trait Number: Scalar + Copy {
    /// What magnitudes are computed in: numbers of the same range.
    type Magnitude: Magnitude;
    /// u: the relative error of an operation is at most this, but for underflow.
    const UNIT: f64;
    /// Where underflow is allowed for.
    const RANGE: Range;
    /// Whether operations with bounds are called: over hardware floats they are inlined, so that a
    /// step is one piece of code; over wide numbers, whose rungs are seldom reached, called, so
    /// that a step over them stays small.
    const IS_CALLED: bool = false;

    /// |self|, rounded as magnitudes are.
    fn size(&self) -> Self::Magnitude;
    /// How far the value may be from its formula's, where it knows that itself.
    #[inline(always)]
    fn radius(&self) -> Option<Self::Magnitude> {
        None
    }
}
