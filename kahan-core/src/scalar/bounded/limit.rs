//! How large the inputs of a formula may be, so that its underflow is allowed for.

use super::number::{Magnitude, power_of_two};

/// What inputs may be at most: a number n for sizes below 2ⁿ⁻¹, and 0 for none at all.
///
/// A count and no float, because compilers fold it: of a step nothing but one comparison is left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Limit(u32);

impl Limit {
    /// No input is small enough.
    pub(crate) const NONE: Self = Self(0);
    /// Nothing underflows, whatever the inputs are.
    pub(crate) const ANY: Self = Self(u32::MAX);

    /// Inputs below 2^power.
    #[inline(always)]
    pub(crate) fn below(power: u32) -> Self {
        Self(power.saturating_add(1))
    }

    /// What both allow.
    #[inline(always)]
    pub(crate) fn and(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }

    /// The size that no input may have: 0 for none, infinite for any.
    #[inline(always)]
    pub(crate) fn size(self) -> f64 {
        match self {
            Self::NONE => 0.0,
            Self::ANY => f64::INFINITY,
            Self(n) => power_of_two(n as i32 - 1),
        }
    }

    /// Whether inputs of at most this size are small enough; what is not a number never is.
    #[inline(always)]
    pub(crate) fn allows<G: Magnitude>(self, largest: G) -> bool {
        G::of(self.size()) > largest
    }
}
