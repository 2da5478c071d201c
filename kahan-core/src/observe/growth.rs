//! Lengths and products beyond the range of floats, as a mantissa and a power of two.
//!
//! Scaling by powers of two is exact, unless an entry underflows. Therefore the bits of a report do
//! not depend on the steps at which a vector is scaled.

use core::cmp::Ordering;
use core::f64::consts::{FRAC_1_SQRT_2, LN_2};

#[cfg(feature = "std")]
use crate::Scalar;
#[cfg(feature = "std")]
use crate::ensemble::columns::Group;
use crate::{Constant, FloatScalar, StateVector};

/// A number of any magnitude, mantissa·2^exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    mantissa: f64,
    exponent: i64,
}

impl Size {
    /// Returns |v|² for a vector v, where `squared` is the squared length of 2^−`exponent`·v.
    #[inline(always)]
    pub(super) fn of_square(squared: f64, exponent: i64) -> Self {
        Self { mantissa: squared, exponent: 2 * exponent }
    }

    pub(super) const ONE: Self = Self::of(1.0);

    pub(super) const fn of(mantissa: f64) -> Self {
        Self { mantissa, exponent: 0 }
    }

    /// Multiplies by `factor`, and normalises the mantissa to a magnitude from ½ to 1.
    pub(super) fn multiply(&mut self, factor: Self) {
        let (mantissa, exponent) = libm::frexp(self.mantissa * factor.mantissa);
        *self = Self { mantissa, exponent: self.exponent + factor.exponent + i64::from(exponent) };
    }

    /// Returns the natural logarithm of the magnitude.
    pub(super) fn ln(self) -> f64 {
        let (mantissa, exponent) = libm::frexp(self.mantissa.abs());
        // A number near 1 gets the exponent 0, so that no large logarithms cancel.
        let (mantissa, exponent) =
            if mantissa < FRAC_1_SQRT_2 { (2.0 * mantissa, exponent - 1) } else { (mantissa, exponent) };
        libm::log(mantissa) + (self.exponent + i64::from(exponent)) as f64 * LN_2
    }
}

impl PartialOrd for Size {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        if self.exponent == other.exponent {
            self.mantissa.partial_cmp(&other.mantissa)
        } else {
            self.ln().partial_cmp(&other.ln())
        }
    }
}

/// The binary exponent of the scaling factor. Scaled vectors stay in the range of `f32` for a step.
const SCALING_EXPONENT: i64 = 32;

/// Scales a finite nonzero vector by powers of two until its squared length lies between 2⁻⁶⁴ and
/// 2⁶⁴. Adds the removed exponent to `exponent`. Returns the unscaled squared length.
#[inline(always)]
pub(super) fn scale<P, T>(vector: &mut P, exponent: &mut i64) -> Size
where
    P: StateVector<T>,
    T: FloatScalar,
{
    let mut squared = square(vector.as_slice());
    if !is_moderate(squared) {
        let bits;
        (*vector, bits, squared) = scaled(vector.clone());
        *exponent += bits;
    }
    Size::of_square(squared, *exponent)
}

/// Returns 2⁶⁴, the largest squared length that needs no scaling.
#[cfg(feature = "std")]
#[inline(always)]
pub(super) fn most<T: Scalar>() -> T {
    let root = T::constant(&Constant::integer(1 << SCALING_EXPONENT));
    root.clone() * root
}

/// Returns whether no vector of a group needs scaling. A vector with a NaN needs no scaling.
#[cfg(feature = "std")]
pub fn are_moderate<T: FloatScalar>(squares: &[Group<T>]) -> bool {
    let most: f64 = most::<T>().approximate();
    let is_beyond = |square: &T| (square.approximate() > most) | (square.approximate() < 1.0 / most);
    !squares.as_flattened().iter().fold(false, |any, square| any | is_beyond(square))
}

#[inline(always)]
fn is_moderate(squared: f64) -> bool {
    const MOST: f64 = (1_u128 << (2 * SCALING_EXPONENT)) as f64;
    squared > 1.0 / MOST && squared < MOST
}

/// Returns the scaled vector, the removed exponent, and the squared length. A copy is taken so that
/// the caller's loop keeps the vector in registers.
#[cold]
#[inline(never)]
fn scaled<P, T>(mut vector: P) -> (P, i64, f64)
where
    P: StateVector<T>,
    T: FloatScalar,
{
    let up = T::constant(&Constant::integer(1 << SCALING_EXPONENT));
    let down = T::one() / up;
    let mut exponent = 0;
    // After this number of scalings, the exponent has changed by more than the range of `f64`.
    for _ in 0..2 * 1100 / SCALING_EXPONENT {
        let squared = square(vector.as_slice());
        if is_moderate(squared) || squared.is_nan() || vector.as_slice().iter().all(T::is_zero) {
            break;
        }
        let (factor, bits) = if squared < 1.0 { (up, -SCALING_EXPONENT) } else { (down, SCALING_EXPONENT) };
        for entry in vector.as_mut_slice() {
            *entry *= factor;
        }
        exponent += bits;
    }
    let squared = square(vector.as_slice());
    (vector, exponent, squared)
}

/// Returns the squared length of a vector, computed without fused operations.
#[inline(always)]
pub(super) fn square<T: FloatScalar>(vector: &[T]) -> f64 {
    dot(vector, vector).approximate()
}

#[inline(always)]
pub(super) fn dot<T: FloatScalar>(v: &[T], w: &[T]) -> T {
    v.iter().zip(w).fold(T::zero(), |sum, (v, w)| sum + *v * *w)
}
