//! The numbers that rungs compute in.

use core::fmt::Debug;
use core::ops::{Div, Mul};

use num_traits::Zero;

use crate::Pivot;

/// What bounds on errors are made of: numbers that are not negative, in which a few digits are enough. What is not a number is
/// neither more nor less than any.
pub(crate) trait Magnitude:
    Copy + Debug + PartialOrd + Zero + Mul<Output = Self> + Div<Output = Self> + From<f64> + Into<f64>
{
}

impl<M> Magnitude for M where
    M: Copy + Debug + PartialOrd + Zero + Mul<Output = M> + Div<Output = M> + From<f64> + Into<f64>
{
}

/// A scalar to work in: its operations round once, relative to their result.
pub(crate) trait Number: Pivot + Copy {
    /// What magnitudes are computed in: numbers of the same range.
    type Magnitude: Magnitude;
    /// u: the relative error of an operation is at most this, but for underflow.
    const UNIT: f64;
    /// More than all errors of underflow; 0 where nothing underflows.
    const ALLOWANCE: f64;

    /// |self|, rounded by no more than a few parts in 2⁵⁰.
    fn size(&self) -> Self::Magnitude;
    /// Whether the value is known to be the formula's own: nothing was rounded on its way.
    #[inline(always)]
    fn is_exact(&self) -> bool {
        false
    }
}
