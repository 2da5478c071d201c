//! Lengths beyond the range of floats.
//!
//! In: factors, one after another, or a vector that grows. Out: its size as a number and a power of
//! two, which no growth takes out of range, and the logarithm of that. Scaling by powers of two is
//! exact, so when it is done changes no bit.

use core::cmp::Ordering;
use core::f64::consts::{FRAC_1_SQRT_2, LN_2};

#[cfg(feature = "std")]
use crate::Scalar;
#[cfg(feature = "std")]
use crate::ensemble::columns::Group;
use crate::{Constant, FloatScalar, StateVector};

/// A positive number: mantissa·2^exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    mantissa: f64,
    exponent: i64,
}

impl Size {
    /// The size of a vector from the square of its length, after it was scaled by 2^−`exponent`.
    #[inline(always)]
    pub(super) fn of_square(squared: f64, exponent: i64) -> Self {
        Self { mantissa: squared, exponent: 2 * exponent }
    }

    pub(super) const ONE: Self = Self::of(1.0);

    pub(super) const fn of(mantissa: f64) -> Self {
        Self { mantissa, exponent: 0 }
    }

    /// The number times a factor, its mantissa between ½ and 1 in size.
    pub(super) fn multiply(&mut self, factor: Self) {
        let (mantissa, exponent) = libm::frexp(self.mantissa * factor.mantissa);
        *self = Self { mantissa, exponent: self.exponent + factor.exponent + i64::from(exponent) };
    }

    /// The natural logarithm of its magnitude, however mantissa and exponent share it.
    pub(super) fn ln(self) -> f64 {
        let (mantissa, exponent) = libm::frexp(self.mantissa.abs());
        // Numbers near 1 have a logarithm near 0, not one that is left of two larger ones.
        let (mantissa, exponent) =
            if mantissa < FRAC_1_SQRT_2 { (2.0 * mantissa, exponent - 1) } else { (mantissa, exponent) };
        libm::log(mantissa) + (self.exponent + i64::from(exponent)) as f64 * LN_2
    }
}

/// A greater one grows more.
impl PartialOrd for Size {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        if self.exponent == other.exponent {
            self.mantissa.partial_cmp(&other.mantissa)
        } else {
            self.ln().partial_cmp(&other.ln())
        }
    }
}

/// A vector is scaled by this power of two whenever its square leaves 2⁻⁶⁴ to 2⁶⁴, the square of
/// that: then `f32` holds what it becomes in a step, too.
const BITS: i64 = 32;

/// Scales a vector by powers of two until its square is of moderate size, as long as it is finite
/// and not 0. Adds what it was scaled by to `exponent`, and returns the square of its length, as
/// that of the vector before it was ever scaled.
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

/// The square of a vector above which it is scaled; below the reciprocal it is scaled, too.
#[cfg(feature = "std")]
#[inline(always)]
pub(super) fn most<T: Scalar>() -> T {
    let root = T::constant(&Constant::integer(1 << BITS));
    root.clone() * root
}

/// Whether no vector has to be scaled, by the squares of a group's lengths; what is not a number
/// never is.
#[cfg(feature = "std")]
pub fn are_moderate<T: FloatScalar>(squares: &[Group<T>]) -> bool {
    let most: f64 = most::<T>().approximate();
    let is_beyond = |square: &T| (square.approximate() > most) | (square.approximate() < 1.0 / most);
    !squares.as_flattened().iter().fold(false, |any, square| any | is_beyond(square))
}

#[inline(always)]
fn is_moderate(squared: f64) -> bool {
    const MOST: f64 = (1_u128 << (2 * BITS)) as f64;
    squared > 1.0 / MOST && squared < MOST
}

/// The vector scaled, the power of two that it was scaled by, and the square of its length.
///
/// It is given a copy, so that a loop keeps the vector in registers.
#[cold]
#[inline(never)]
fn scaled<P, T>(mut vector: P) -> (P, i64, f64)
where
    P: StateVector<T>,
    T: FloatScalar,
{
    let up = T::constant(&Constant::integer(1 << BITS));
    let down = T::one() / up;
    let mut exponent = 0;
    // From one end of the range of `f64` to the other.
    for _ in 0..2 * 1100 / BITS {
        let squared = square(vector.as_slice());
        // The square of a small vector may be 0.
        if is_moderate(squared) || squared.is_nan() || vector.as_slice().iter().all(T::is_zero) {
            break;
        }
        let (factor, bits) = if squared < 1.0 { (up, -BITS) } else { (down, BITS) };
        for entry in vector.as_mut_slice() {
            *entry *= factor;
        }
        exponent += bits;
    }
    let squared = square(vector.as_slice());
    (vector, exponent, squared)
}

/// The square of a vector's length, by multiplications and additions that nothing fuses.
#[inline(always)]
pub(super) fn square<T: FloatScalar>(vector: &[T]) -> f64 {
    dot(vector, vector).approximate()
}

/// The inner product.
#[inline(always)]
pub(super) fn dot<T: FloatScalar>(v: &[T], w: &[T]) -> T {
    v.iter().zip(w).fold(T::zero(), |sum, (v, w)| sum + *v * *w)
}
