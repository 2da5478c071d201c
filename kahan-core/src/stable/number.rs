//! The numbers that rungs compute in.

use crate::Pivot;

/// A scalar to work in: its operations round once, relative to their result.
pub(crate) trait Number: Pivot + Copy {
    /// What magnitudes are computed in: a number of the same range, in which a few digits are enough.
    type Magnitude: Pivot + Copy;
    /// u: the relative error of an operation is at most this, but for underflow.
    const UNIT: f64;
    /// More than all errors of underflow; 0 where nothing underflows.
    const ALLOWANCE: f64;

    /// |self|, rounded by no more than a few parts in 2⁵⁰.
    fn size(&self) -> Self::Magnitude;
    /// A constant as a magnitude.
    fn magnitude(value: f64) -> Self::Magnitude;
    /// Whether the value is known to be the formula's own: nothing was rounded on its way.
    #[inline(always)]
    fn is_exact(&self) -> bool {
        false
    }
    /// Whether one magnitude is larger than another; false if either is not a number.
    fn exceeds(one: Self::Magnitude, other: Self::Magnitude) -> bool;
}
