//! The limit on a formula's inputs up to which the error bound includes underflow.

use super::number::{Magnitude, power_of_two};

/// A limit on the magnitudes of inputs. The integer n allows magnitudes below 2ⁿ⁻¹, and 0 allows no
/// input. Compilers evaluate the integer, and therefore a step contains only one comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct InputLimit(u32);

impl InputLimit {
    pub(crate) const NONE: Self = Self(0);
    /// Allows all inputs, because no operation underflows.
    pub(crate) const ANY: Self = Self(u32::MAX);

    #[inline(always)]
    pub(crate) fn below(power: u32) -> Self {
        Self(power.saturating_add(1))
    }

    #[inline(always)]
    pub(crate) fn and(self, other: Self) -> Self {
        Self(self.0.min(other.0))
    }

    /// Returns the smallest forbidden magnitude. The magnitude is 0 if no input is allowed, and
    /// infinite if all inputs are allowed.
    #[inline(always)]
    pub(crate) fn size(self) -> f64 {
        match self {
            Self::NONE => 0.0,
            Self::ANY => f64::INFINITY,
            Self(n) => power_of_two(n as i32 - 1),
        }
    }

    /// Returns whether inputs up to this magnitude are allowed. The result is false for NaN.
    #[inline(always)]
    pub(crate) fn allows<G: Magnitude>(self, largest: G) -> bool {
        G::of(self.size()) > largest
    }
}
