//! Rationals of any size as scalars.

use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

use super::{Constant, Scalar};

impl Scalar for BigRational {
    fn constant(c: &Constant<'_>) -> Self {
        c.to_ratio()
    }

    fn quotient(self, divisor: Self) -> Option<Self> {
        if divisor.is_zero() { None } else { Some(self / divisor) }
    }

    fn approximate(&self) -> f64 {
        self.to_f64().unwrap_or(f64::NAN)
    }
}
