//! Rationals of any size as scalars, with exact results. Zero has no reciprocal.

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::{Constant, Scalar};

impl Scalar for BigRational {
    fn constant(c: &Constant<'_>) -> Self {
        c.to_ratio()
    }

    /// Divides directly, because a reciprocal would cost as much as the quotient.
    fn quotient(self, divisor: Self) -> Option<Self> {
        if divisor.is_zero() { None } else { Some(self / divisor) }
    }

    fn approximate(&self) -> f64 {
        self.to_f64().unwrap_or(f64::NAN)
    }
}
