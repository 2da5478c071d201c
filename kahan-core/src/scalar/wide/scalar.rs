//! [`Wide`] as a scalar: the generated step runs over it as over a float.
//!
//! Zero has no reciprocal, so a pole that is met exactly ends the step instead of passing on an undefined number.

use core::cmp::Ordering;

use num_traits::{One, Zero};

use super::Wide;
use crate::{Constant, Pivot, Scalar};

impl Scalar for Wide {
    fn constant(c: &Constant) -> Self {
        c.to_wide()
    }

    fn reciprocal(&self) -> Option<Self> {
        Self::one().quotient(*self)
    }

    /// Without the reciprocal, which would be a second division.
    fn quotient(self, divisor: Self) -> Option<Self> {
        if divisor.is_zero() { None } else { Some(self / divisor) }
    }

    /// The larger magnitude, for stability; what is undefined is never better.
    fn is_better_pivot(&self, than: &Self) -> bool {
        self.magnitude_exceeds(than)
    }

    fn approximate(&self) -> f64 {
        self.to_f64()
    }
}

impl Pivot for Wide {
    fn magnitude_exceeds(&self, other: &Self) -> bool {
        self.compare_magnitudes(other) == Some(Ordering::Greater)
    }

    fn is_finite_number(&self) -> bool {
        self.is_defined()
    }
}
