//! Dual numbers v + s·d with d² = 0: a value v and its derivative s along one direction.
//!
//! A step over these numbers gives its value and its derivative along the direction. Constants
//! have no derivative, which saves multiplications by 0.

use num_traits::{One, Zero};

use super::tuning::fenced;
use super::{Constant, Scalar, operators};

/// A value and its derivative along one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DirectionalDual<T> {
    pub(crate) value: T,
    pub(crate) slope: Option<T>,
}

impl<T: Scalar> DirectionalDual<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn from_value(value: T) -> Self {
        Self { value, slope: None }
    }

    /// Creates a number. `fenced` keeps compilers from packing both parts into one register.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn new(value: T, slope: Option<T>) -> Self {
        Self { value: fenced(value), slope: slope.map(fenced) }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn into_slope(self) -> T {
        self.slope.unwrap_or_else(T::zero)
    }
}

/// Combines two derivatives by `both`, or by `left` or `right` if the other one is `None`.
#[cfg_attr(not(debug_assertions), inline(always))]
fn joined<T: Scalar>(
    slopes: [Option<T>; 2],
    both: impl FnOnce(T, T) -> T,
    left: impl FnOnce(T) -> T,
    right: impl FnOnce(T) -> T,
) -> Option<T> {
    match slopes {
        [Some(a), Some(b)] => Some(both(a, b)),
        [Some(a), None] => Some(left(a)),
        [None, Some(b)] => Some(right(b)),
        [None, None] => None,
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn sum<T: Scalar>(a: DirectionalDual<T>, b: DirectionalDual<T>) -> DirectionalDual<T> {
    let slope = joined([a.slope, b.slope], |a, b| a + b, |a| a, |b| b);
    DirectionalDual::new(a.value + b.value, slope)
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn difference<T: Scalar>(a: DirectionalDual<T>, b: DirectionalDual<T>) -> DirectionalDual<T> {
    let slope = joined([a.slope, b.slope], |a, b| a - b, |a| a, |b| -b);
    DirectionalDual::new(a.value - b.value, slope)
}

// (uv)′ = u′v + uv′.
#[cfg_attr(not(debug_assertions), inline(always))]
fn product<T: Scalar>(a: DirectionalDual<T>, b: DirectionalDual<T>) -> DirectionalDual<T> {
    let (u, v) = (a.value, b.value);
    let both = |a, b| a * v.clone() + u.clone() * b;
    let slope = joined([a.slope, b.slope], both, |a| a * v.clone(), |b| u.clone() * b);
    DirectionalDual::new(u * v, slope)
}

// (u/v)′ = (u′ − (u/v)v′)/v. The closure `over` divides a number by v.
#[cfg_attr(not(debug_assertions), inline(always))]
fn quotient<T: Scalar>(value: T, slopes: [Option<T>; 2], over: impl Fn(T) -> T) -> DirectionalDual<T> {
    let both = |a, b| over(a - value.clone() * b);
    let slope = joined(slopes, both, &over, |b| over(-(value.clone() * b)));
    DirectionalDual::new(value, slope)
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn ratio<T: Scalar>(a: DirectionalDual<T>, b: DirectionalDual<T>) -> DirectionalDual<T> {
    quotient(a.value / b.value.clone(), [a.slope, b.slope], |slope| slope / b.value.clone())
}

operators!([T: Scalar] DirectionalDual<T>: sum, difference, product, ratio);

impl<T: Scalar> core::ops::Neg for DirectionalDual<T> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn neg(self) -> Self {
        Self::new(-self.value, self.slope.map(|slope| -slope))
    }
}

impl<T: Scalar> Zero for DirectionalDual<T> {
    fn zero() -> Self {
        Self::from_value(T::zero())
    }

    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.slope.as_ref().is_none_or(T::is_zero)
    }
}

impl<T: Scalar> One for DirectionalDual<T> {
    fn one() -> Self {
        Self::from_value(T::one())
    }
}

impl<T: Scalar> Scalar for DirectionalDual<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn constant(c: &Constant<'_>) -> Self {
        Self::from_value(T::constant(c))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn prepared(&self) -> Self {
        Self::from_value(self.value.clone())
    }

    // (1/v)′ = −v′/v².
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn reciprocal(&self) -> Option<Self> {
        let value = self.value.reciprocal()?;
        let factor = -(value.clone() * value.clone());
        Some(Self::new(value, self.slope.clone().map(|slope| factor * slope)))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn quotient(self, divisor: Self) -> Option<Self> {
        let reciprocal = divisor.value.reciprocal()?;
        let value = self.value.quotient(divisor.value)?;
        Some(quotient(value, [self.slope, divisor.slope], |slope| slope * reciprocal.clone()))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_better_pivot(&self, than: &Self) -> bool {
        self.value.is_better_pivot(&than.value)
    }

    fn approximate(&self) -> f64 {
        self.value.approximate()
    }
}
