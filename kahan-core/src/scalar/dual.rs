//! Dual numbers v + g·d with d² = 0: a value v with its gradient g in N directions.
//!
//! A step over dual numbers gives its value and its derivatives. Dual numbers have no order and no
//! roots. Builds without debug assertions inline all operators, so that steps over lanes stay in
//! registers.

use core::array::from_fn;
use core::ops::Neg;

use num_traits::{One, Zero};

use super::{Constant, Scalar, operators};

/// A value with its derivatives along N directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<T, const N: usize> {
    /// The value.
    pub value: T,
    /// The derivatives of the value.
    pub gradient: [T; N],
}

impl<T: Scalar, const N: usize> Dual<T, N> {
    /// Creates a constant, whose gradient is 0.
    pub fn from_value(value: T) -> Self {
        Self { value, gradient: from_fn(|_| T::zero()) }
    }

    /// Creates the coordinate of direction `i`: its derivative is 1 along `i`, and 0 along the
    /// other directions.
    pub fn coordinate(value: T, i: usize) -> Self {
        Self { value, gradient: from_fn(|j| if i == j { T::one() } else { T::zero() }) }
    }
}

impl<const N: usize> From<f64> for Dual<f64, N> {
    fn from(value: f64) -> Self {
        Self::from_value(value)
    }
}

/// Replaces each entry of a gradient by the value of an expression. The expression may use the
/// corresponding entry of a second gradient.
macro_rules! along {
    ($dual:expr, |$own:ident| $value:expr) => {
        for $own in &mut $dual.gradient {
            *$own = $value;
        }
    };
    ($dual:expr, $with:expr, |$own:ident, $other:ident| $value:expr) => {
        for ($own, $other) in $dual.gradient.iter_mut().zip(&$with.gradient) {
            *$own = $value;
        }
    };
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn sum<T: Scalar, const N: usize>(mut a: Dual<T, N>, b: Dual<T, N>) -> Dual<T, N> {
    along!(a, b, |own, other| own.clone() + other.clone());
    Dual { value: a.value + b.value, gradient: a.gradient }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn difference<T: Scalar, const N: usize>(mut a: Dual<T, N>, b: Dual<T, N>) -> Dual<T, N> {
    along!(a, b, |own, other| own.clone() - other.clone());
    Dual { value: a.value - b.value, gradient: a.gradient }
}

// (uv)′ = u′v + uv′.
#[cfg_attr(not(debug_assertions), inline(always))]
fn product<T: Scalar, const N: usize>(mut a: Dual<T, N>, b: Dual<T, N>) -> Dual<T, N> {
    let (u, v) = (a.value, b.value);
    along!(a, b, |own, other| own.clone() * v.clone() + u.clone() * other.clone());
    Dual { value: u * v, gradient: a.gradient }
}

// (u/v)′ = (u′ − (u/v)v′)/v.
#[cfg_attr(not(debug_assertions), inline(always))]
fn ratio<T: Scalar, const N: usize>(mut a: Dual<T, N>, b: Dual<T, N>) -> Dual<T, N> {
    let value = a.value / b.value.clone();
    along!(a, b, |own, slope| (own.clone() - value.clone() * slope.clone()) / b.value.clone());
    Dual { value, gradient: a.gradient }
}

operators!([T: Scalar, const N: usize] Dual<T, N>: sum, difference, product, ratio);

impl<T: Scalar, const N: usize> Neg for Dual<T, N> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn neg(mut self) -> Self {
        along!(self, |own| -own.clone());
        Self { value: -self.value, gradient: self.gradient }
    }
}

impl<T: Scalar, const N: usize> Zero for Dual<T, N> {
    fn zero() -> Self {
        Self::from_value(T::zero())
    }

    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.gradient.iter().all(T::is_zero)
    }
}

impl<T: Scalar, const N: usize> One for Dual<T, N> {
    fn one() -> Self {
        Self::from_value(T::one())
    }
}

impl<T: Scalar, const N: usize> Scalar for Dual<T, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn constant(c: &Constant<'_>) -> Self {
        Self::from_value(T::constant(c))
    }

    // (1/v)′ = −v′/v².
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn reciprocal(&self) -> Option<Self> {
        let value = self.value.reciprocal()?;
        let slope = -(value.clone() * value.clone());
        let mut result = Self { value, gradient: self.gradient.clone() };
        along!(result, |own| slope.clone() * own.clone());
        Some(result)
    }

    // One reciprocal serves the value and the whole gradient.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn quotient(mut self, divisor: Self) -> Option<Self> {
        let reciprocal = divisor.value.reciprocal()?;
        let value = self.value.quotient(divisor.value)?;
        along!(self, divisor, |own, slope| {
            (own.clone() - value.clone() * slope.clone()) * reciprocal.clone()
        });
        Some(Self { value, gradient: self.gradient })
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_better_pivot(&self, than: &Self) -> bool {
        self.value.is_better_pivot(&than.value)
    }

    fn approximate(&self) -> f64 {
        self.value.approximate()
    }
}
