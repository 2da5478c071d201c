//! The limit of a formula's inputs below which underflow is accounted for.

use super::number::{Magnitude, power_of_two};

/// A limit of inputs: n for magnitudes below 2ⁿ⁻¹, 0 if no input is allowed. Compilers fold the
/// integer, so that only one comparison remains in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Limit(u32);

impl Limit {
    /// Allows no input.
    pub(crate) const NONE: Self = Self(0);
    /// Allows all inputs, as nothing underflows.
    pub(crate) const ANY: Self = Self(u32::MAX);

    #[inline(always)]
    pub(crate) fn below(power: u32) -> Self {
        Self(power.saturating_add(1))
    }

    #[inline(always)]
    pub(crate) fn and(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }

    /// Returns the least magnitude that is not allowed: 0 for none, infinite for any.
    #[inline(always)]
    pub(crate) fn size(self) -> f64 {
        match self {
            Self::NONE => 0.0,
            Self::ANY => f64::INFINITY,
            Self(n) => power_of_two(n as i32 - 1),
        }
    }

    /// Returns whether inputs of at most this magnitude are allowed; NaN never is.
    #[inline(always)]
    pub(crate) fn allows<G: Magnitude>(self, largest: G) -> bool {
        G::of(self.size()) > largest
    }
}
