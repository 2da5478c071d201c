//! The four operations on [`Wide`], each cut off towards zero after 1024 bits, and what follows from them.
//!
//! The unit here is the last bit of a result's mantissa, at most 2⁻¹⁰²³ of the result: a mantissa is at least 2¹⁰²³.

use core::cmp::Ordering;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use num_traits::{One, Zero};

use super::{BITS, LIMBS, State, Wide, limbs};

impl Neg for Wide {
    type Output = Self;

    fn neg(self) -> Self {
        Self { negative: self.state == State::Number && !self.negative, ..self }
    }
}

/// Below one unit of error in a difference, below two in a sum with a carry, whose unit is half as large.
///
/// One limb below the mantissa keeps what alignment shifts out. Up to 64 places nothing is lost, so cancellation is exact;
/// beyond 64 places a difference cancels at most one bit, and what is lost lies below 2⁻⁶⁴ of a unit.
impl Add for Wide {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (large, small) = match self.compare_magnitudes(&other) {
            None => return Self::UNDEFINED,
            Some(Ordering::Less) => (other, self),
            Some(_) => (self, other),
        };
        let exact = large.exact && small.exact;
        if small.is_zero() {
            return large.exact_if(exact);
        }
        let distance = large.exponent.abs_diff(small.exponent);
        if distance > BITS + 64 {
            return large.exact_if(false);
        }
        let exact = exact && distance <= limbs::trailing_zeros(&small.mantissa) + 64;
        let (mut sum, mut addend) = (guarded(&large.mantissa), guarded(&small.mantissa));
        limbs::shift_right(&mut addend, distance);
        if large.negative != small.negative {
            limbs::subtract(&mut sum, &addend);
            return Self::normalised(large.negative, Some(large.exponent), sum).exact_if(exact);
        }
        if !limbs::add(&mut sum, &addend) {
            return Self::normalised(large.negative, Some(large.exponent), sum).exact_if(exact);
        }
        let exact = exact && sum[0] & 1 == 0;
        limbs::shift_right(&mut sum, 1);
        sum[LIMBS] |= 1 << 63;
        Self::normalised(large.negative, large.exponent.checked_add(1), sum).exact_if(exact)
    }
}

/// A mantissa with a limb of zeros below it.
fn guarded(mantissa: &[u64; LIMBS]) -> [u64; LIMBS + 1] {
    let mut guarded = [0; LIMBS + 1];
    guarded[1..].copy_from_slice(mantissa);
    guarded
}

impl Sub for Wide {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

/// Below one unit of error: all of the product is formed before it is cut off. Zero times undefined is undefined.
impl Mul for Wide {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        match (self.state, other.state) {
            (State::Undefined, _) | (_, State::Undefined) => Self::UNDEFINED,
            // Nothing times anything is nothing, whatever was cut off there.
            (State::Zero, _) => Self::ZERO.exact_if(self.exact || (other.exact && other.is_zero())),
            (_, State::Zero) => Self::ZERO.exact_if(other.exact),
            (State::Number, State::Number) => {
                // The product of two mantissas in [1, 2) is in [1, 4).
                let exponent = self.exponent.checked_add(other.exponent).and_then(|e| e.checked_add(1));
                let product = limbs::product(&self.mantissa, &other.mantissa);
                Self::normalised(self.negative != other.negative, exponent, product)
                    .exact_if(self.exact && other.exact)
            }
        }
    }
}

/// Below one unit of error if the dividend's mantissa is the smaller, else below two, whose unit is half as large. Undefined for a
/// divisor that is zero.
impl Div for Wide {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        match (self.state, other.state) {
            (State::Undefined, _) | (_, State::Undefined | State::Zero) => Self::UNDEFINED,
            (State::Zero, State::Number) => Self::ZERO.exact_if(self.exact),
            (State::Number, State::Number) => {
                // ⌊2¹⁰²⁴·ratio of the mantissas⌋ is in [2¹⁰²³, 2¹⁰²⁵); as a row of 1088 bits its value is m·2^(e − 1087)
                // with e = 1087 − 1024 = 63 more than the difference of the exponents.
                let exponent = self.exponent.checked_sub(other.exponent).and_then(|e| e.checked_add(63));
                let quotient = limbs::quotient(&self.mantissa, &other.mantissa);
                // Whether a remainder is left is not looked at: hardly any quotient is exact.
                Self::normalised(self.negative != other.negative, exponent, quotient).exact_if(false)
            }
        }
    }
}

macro_rules! assign {
    ($($operator:ident, $method:ident, $by_value:ident;)*) => {$(
        impl $operator for Wide {
            fn $method(&mut self, other: Self) {
                *self = self.$by_value(other);
            }
        }
    )*};
}

assign! {
    AddAssign, add_assign, add;
    SubAssign, sub_assign, sub;
    MulAssign, mul_assign, mul;
    DivAssign, div_assign, div;
}

impl Zero for Wide {
    fn zero() -> Self {
        Self::ZERO
    }

    fn is_zero(&self) -> bool {
        self.state == State::Zero
    }
}

impl One for Wide {
    fn one() -> Self {
        Self::from(1_i64)
    }
}
