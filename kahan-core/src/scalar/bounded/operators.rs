//! Bounded values as a scalar, over which generated steps run.

use core::ops::Neg;

use num_traits::{One, Zero};

use crate::scalar::operators;
use crate::{Constant, Scalar};

use super::pair::BoundedPair;
use super::{Bounded, Number};

impl<V: Number, P: BoundedPair<V>> PartialEq for Bounded<V, P> {
    fn eq(&self, other: &Self) -> bool {
        self.value() == other.value()
            && self.magnitude() == other.magnitude()
            && self.roundings() == other.roundings()
    }
}

impl<V: Number, P: BoundedPair<V>> Scalar for Bounded<V, P> {
    /// Integers that the number type and `f64` represent are exact. Other literals are rounded.
    #[inline(always)]
    fn constant(c: &Constant<'_>) -> Self {
        let value = V::constant(c);
        let is_exact = c.is_whole() && value.approximate() == c.to_f64();
        Self::literal(value, u32::from(!is_exact))
    }

    #[inline(always)]
    fn reciprocal(&self) -> Option<Self> {
        Self::one().over(*self)
    }

    #[inline(always)]
    fn quotient(self, divisor: Self) -> Option<Self> {
        self.over(divisor)
    }

    #[inline(always)]
    fn is_better_pivot(&self, than: &Self) -> bool {
        self.value().is_better_pivot(&than.value())
    }

    #[inline(always)]
    fn multiply_add(self, factor: Self, addend: Self) -> Self {
        self.times_plus(factor, addend)
    }

    #[inline(always)]
    fn multiply_subtract(self, factor: Self, subtrahend: Self) -> Self {
        self.times_plus(factor, -subtrahend)
    }

    #[inline(always)]
    fn subtract_product(self, a: Self, b: Self) -> Self {
        (-a).times_plus(b, self)
    }

    fn approximate(&self) -> f64 {
        self.value().approximate()
    }
}

operators!([V: Number, P: BoundedPair<V>] Bounded<V, P>: Self::plus, Self::minus, Self::times, Self::divided);

/// Defines operations that are inlined or called, depending on `V::IS_CALLED`.
macro_rules! inlined_or_called {
    ($($name:ident, $called:ident = $operation:ident($($operand:ident),*) -> $result:ty;)*) => { $(
        #[inline(never)]
        fn $called(self, $($operand: Self),*) -> $result {
            self.$operation($($operand),*)
        }

        #[inline(always)]
        fn $name(self, $($operand: Self),*) -> $result {
            if V::IS_CALLED { self.$called($($operand),*) } else { self.$operation($($operand),*) }
        }
    )* };
}

impl<V: Number, P: BoundedPair<V>> Bounded<V, P> {
    inlined_or_called! {
        plus, called_sum = sum(other) -> Self;
        minus, called_difference = difference(other) -> Self;
        times, called_product = product(other) -> Self;
        times_plus, called_product_plus = product_plus(factor, addend) -> Self;
        over, called_quotient = quotient(divisor) -> Option<Self>;
    }

    #[inline(always)]
    fn divided(self, other: Self) -> Self {
        if self.is_literal() && other.is_ordinary_input() {
            return self.over_input(other);
        }
        self.over(other).unwrap_or_else(|| Self::unknown(self.value() / other.value()))
    }
}

impl<V: Number, P: BoundedPair<V>> Neg for Bounded<V, P> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.negated()
    }
}

impl<V: Number, P: BoundedPair<V>> Zero for Bounded<V, P> {
    #[inline(always)]
    fn zero() -> Self {
        Self::literal(V::zero(), 0)
    }

    fn is_zero(&self) -> bool {
        self.value().is_zero()
    }
}

impl<V: Number, P: BoundedPair<V>> One for Bounded<V, P> {
    #[inline(always)]
    fn one() -> Self {
        Self::literal(V::one(), 0)
    }
}

#[cfg(test)]
mod tests {
    use super::{Bounded, Constant, Scalar};

    #[test]
    fn an_integer_that_the_number_does_not_hold_is_rounded() {
        let beyond = Constant::integer((1 << 24) + 1);
        assert_eq!(Bounded::<f32>::constant(&beyond).roundings(), 1);
        assert_eq!(Bounded::<f32>::constant(&Constant::integer(1 << 30)).roundings(), 0);
        assert_eq!(Bounded::<f64>::constant(&beyond).roundings(), 0);
        assert_eq!(Bounded::<f64>::constant(&Constant::integer((1 << 53) + 1)).roundings(), 1);
    }
}
