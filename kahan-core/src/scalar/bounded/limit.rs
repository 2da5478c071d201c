//! The largest input for which the error bound of a formula covers underflow.

use super::number::{Magnitude, power_of_two};

/// A limit on the magnitudes of a step's inputs, known at compile time. The integer n ≥ 1 allows
/// inputs below 2ⁿ⁻¹, and 0 allows no input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct InputLimit(u32);

impl InputLimit {
    pub(crate) const NONE: Self = Self(0);
    pub(crate) const ANY: Self = Self(u32::MAX);

    #[inline(always)]
    pub(crate) fn below(power: u32) -> Self {
        Self(power.saturating_add(1))
    }

    #[inline(always)]
    pub(crate) fn and(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }

    /// Returns the smallest forbidden magnitude, which is infinite if all inputs are allowed.
    #[inline(always)]
    pub(crate) fn size(self) -> f64 {
        match self {
            Self::NONE => 0.0,
            Self::ANY => f64::INFINITY,
            Self(n) => power_of_two(n as i32 - 1),
        }
    }

    /// Returns whether inputs up to this magnitude are allowed.
    #[inline(always)]
    pub(crate) fn allows<G: Magnitude>(self, largest: G) -> bool {
        G::of(self.size()) > largest
    }
}
