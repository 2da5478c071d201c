//! A value with its magnitude, and operations on both at once.

use core::fmt::Debug;

use super::number::Number;

/// A value with its magnitude. Sums and differences add the magnitudes of their operands, and
/// products multiply them.
pub(crate) trait BoundedPair<V: Number>: Copy + Debug + 'static {
    fn new(value: V, magnitude: V::Magnitude) -> Self;
    fn value(self) -> V;
    fn magnitude(self) -> V::Magnitude;

    fn plus(self, other: Self) -> Self;
    fn minus(self, other: Self) -> Self;
    fn times(self, other: Self) -> Self;
    fn negated(self) -> Self;

    /// Returns self·factor + addend. The value is rounded as in `Scalar::multiply_add`.
    fn multiply_add(self, factor: Self, addend: Self) -> Self;
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct UnpackedPair<V: Number> {
    value: V,
    magnitude: V::Magnitude,
}

impl<V: Number> BoundedPair<V> for UnpackedPair<V> {
    #[inline(always)]
    fn new(value: V, magnitude: V::Magnitude) -> Self {
        Self { value, magnitude }
    }

    #[inline(always)]
    fn value(self) -> V {
        self.value
    }

    #[inline(always)]
    fn magnitude(self) -> V::Magnitude {
        self.magnitude
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Self { value: self.value + other.value, magnitude: self.magnitude + other.magnitude }
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        Self { value: self.value - other.value, magnitude: self.magnitude + other.magnitude }
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        Self { value: self.value * other.value, magnitude: self.magnitude * other.magnitude }
    }

    #[inline(always)]
    fn negated(self) -> Self {
        Self { value: -self.value, ..self }
    }

    #[inline(always)]
    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        Self {
            value: self.value.multiply_add(factor.value, addend.value),
            magnitude: self.magnitude * factor.magnitude + addend.magnitude,
        }
    }
}
