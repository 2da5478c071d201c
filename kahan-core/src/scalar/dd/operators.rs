//! `+`, `-`, `*`, `/` and their assignments, the sign, and the order.

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

/// By value; what is not a number has no place.
impl PartialOrd for Dd {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        // Rounding to the nearest float keeps the order, so the low parts matter between equal high
        // parts only.
        match self.high.partial_cmp(&other.high)? {
            Ordering::Equal => self.low.partial_cmp(&other.low),
            order => Some(order),
        }
    }
}
