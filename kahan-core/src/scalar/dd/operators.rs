//! Operators, assignment operators, sign and order of double-double numbers.

use core::cmp::Ordering;
use core::ops::Neg;

use super::{Dd, arithmetic};
use crate::scalar::operators;

impl Neg for Dd {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

operators!([] Dd: arithmetic::sum, arithmetic::difference, arithmetic::product, arithmetic::quotient);

impl PartialOrd for Dd {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        // Rounding is monotonic, and the high part is the rounded number.
        match self.high.partial_cmp(&other.high)? {
            Ordering::Equal => self.low.partial_cmp(&other.low),
            order => Some(order),
        }
    }
}
