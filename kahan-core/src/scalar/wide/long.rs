//! Numbers of many digits on the heap, for the last elimination that a step is tried by.
//!
//! 17 digits of 64 bits leave a step open where its matrix has entries that are a thousand powers
//! of ten apart and nearly singular parts; here there is room for that, at the price of an
//! allocation an operation. Zero takes no room.

use std::boxed::Box;

use num_traits::{One, Zero};

use super::{Digits, Size, Wide};
use crate::scalar::{assignments, operators};
use crate::{Constant, Scalar};

/// The number of digits.
type Inner = Digits<256, 518>;

/// A number of at most [`MOST_DIGITS`](Self::MOST_DIGITS) digits of 64 bits; none for zero.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Long(Option<Box<Inner>>);

impl Long {
    /// How many digits there may be.
    pub(crate) const MOST_DIGITS: usize = Inner::MOST_DIGITS;

    fn of(number: Inner) -> Self {
        let is_exactly_zero = number.is_zero() && number.radius().is_zero();
        Self((!is_exactly_zero).then(|| Box::new(number)))
    }

    /// The number, zero included.
    fn inner(&self) -> Inner {
        self.0.as_deref().copied().unwrap_or_else(Inner::zero)
    }

    /// What |v| is at most, for the value v of the formula.
    pub(crate) fn at_most(&self) -> Size {
        self.0.as_deref().map_or_else(Size::zero, |number| number.size() + number.radius())
    }

    /// The leading digits, and what the others are as the radius.
    pub(crate) fn leading(&self) -> Wide {
        self.0.as_deref().map_or_else(Wide::zero, Inner::with_digits)
    }

    /// self·2^power
    fn scaled(&self, power: i64) -> Self {
        match &self.0 {
            None => self.clone(),
            Some(number) => Self::of(**number * Inner::power_of_two(power)),
        }
    }

    fn plus(self, other: Self) -> Self {
        match (self.0, other.0) {
            (None, number) | (number, None) => Self(number),
            (Some(a), Some(b)) => Self::of(*a + *b),
        }
    }

    fn times(self, other: Self) -> Self {
        match (self.0, other.0) {
            (Some(a), Some(b)) => Self::of(*a * *b),
            // Zero times undefined is undefined.
            (None, Some(number)) | (Some(number), None) if !number.is_defined() => Self(Some(number)),
            _ => Self(None),
        }
    }
}

/// Multiplies a row of a system of equations by the power of two that leaves its largest entry
/// near 1, so that the largest entry of a column is a good pivot.
pub(crate) fn level_row<'a>(row: impl Iterator<Item = &'a mut Long>, right: &mut Long) {
    let mut row: std::vec::Vec<_> = row.collect();
    let largest = row.iter().filter(|entry| entry.0.is_some()).map(|entry| entry.at_most());
    let Some(power) = largest.filter(|size| !size.is_unknown()).map(|size| size.exponent).max() else {
        return;
    };
    for entry in row.iter_mut().map(|entry| &mut **entry).chain([right]) {
        *entry = entry.scaled(-power);
    }
}

impl From<Wide> for Long {
    fn from(number: Wide) -> Self {
        Self::of(number.with_digits())
    }
}

operators!([] Long: Self::plus, |a: Self, b: Self| a.plus(-b), Self::times, |a: Self, b: Self| Self::of(a.inner() / b.inner()));
assignments!([] Long);

impl core::ops::Neg for Long {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.map(|number| Box::new(-*number)))
    }
}

impl Zero for Long {
    fn zero() -> Self {
        Self(None)
    }

    fn is_zero(&self) -> bool {
        self.0.as_deref().is_none_or(Zero::is_zero)
    }
}

impl One for Long {
    fn one() -> Self {
        Self::of(Inner::one())
    }
}

impl Scalar for Long {
    fn constant(c: &Constant<'_>) -> Self {
        Self::of(c.to_digits())
    }

    /// Without the reciprocal, which would be a second division.
    fn quotient(self, divisor: Self) -> Option<Self> {
        if divisor.is_zero() { None } else { Some(self / divisor) }
    }

    /// The larger magnitude, for stability; what is undefined is never better.
    fn is_better_pivot(&self, than: &Self) -> bool {
        self.at_most() > than.at_most()
    }

    fn approximate(&self) -> f64 {
        self.leading().to_f64()
    }
}
