//! A software float of 1024 bits whose exponent never runs out: what judges a step where hardware floats cannot.
//!
//! In: floats, constants, and the generated step that runs over any [`Scalar`]. Out: the same step with a relative error
//! of 2^[`Wide::UNIT_EXPONENT`] an operation, whatever the sizes in between.
//! Nothing overflows: exponents are `i64`, and a number whose exponent would leave them is undefined. What has no value
//! (a float that is not finite, a division by zero) is one state, *undefined*, which every operation passes on. There
//! are no signed zeros, no infinities and no rounding modes; conversions to hardware floats are correctly rounded.
//!
//! [`limbs`] is arithmetic on rows of limbs, [`arithmetic`] the operators, [`convert`] the ways in and out, [`size`] how large
//! such a number is, and [`scalar`] what a Kahan map asks for.

mod arithmetic;
mod convert;
mod limbs;
mod scalar;
mod size;

#[cfg(all(test, feature = "exact"))]
mod tests;

use core::cmp::Ordering;

pub(crate) use size::Size;

/// The number of limbs of a mantissa.
pub(crate) const LIMBS: usize = 16;

/// The bits of a mantissa.
const BITS: u64 = 64 * LIMBS as u64;

/// A float of 1024 bits with an exponent of 64 bits.
///
/// Its value is ±m·2^(exponent − 1023) with the mantissa m in [2¹⁰²³, 2¹⁰²⁴), little-endian in its limbs, so that
/// 2^exponent ≤ |value| < 2^(exponent + 1); or zero; or undefined.
/// Addition, subtraction, multiplication and division each have a relative error of at most
/// 2^[`UNIT_EXPONENT`](Wide::UNIT_EXPONENT), and a sum of exactly opposite numbers is zero. It knows whether anything was cut off
/// on its way, so that what cancels exactly is told from what cancels by accident.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wide {
    state: State,
    exact: bool,
    negative: bool,
    exponent: i64,
    mantissa: [u64; LIMBS],
}

/// What a [`Wide`] holds. Sign, exponent and mantissa are false and 0 unless it is a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Zero,
    Number,
    Undefined,
}

impl Wide {
    /// Each operation is exact up to a relative error of at most 2^UNIT_EXPONENT = 2⁻¹⁰²².
    pub(crate) const UNIT_EXPONENT: i64 = -(BITS as i64 - 2);

    const ZERO: Self =
        Self { state: State::Zero, exact: true, negative: false, exponent: 0, mantissa: [0; LIMBS] };

    const UNDEFINED: Self = Self { state: State::Undefined, exact: false, ..Self::ZERO };

    /// The number with a mantissa whose top bit is set; undefined where the exponent left its range.
    fn number(negative: bool, exponent: Option<i64>, mantissa: [u64; LIMBS]) -> Self {
        debug_assert!(mantissa[LIMBS - 1] >> 63 == 1, "a mantissa has its top bit set");
        match exponent {
            Some(exponent) => Self { state: State::Number, exact: true, negative, exponent, mantissa },
            None => Self::UNDEFINED,
        }
    }

    /// ±m·2^(exponent − 64K + 1) for any m in K ≥ LIMBS limbs, little-endian, cut off after 1024 bits.
    fn normalised<const K: usize>(negative: bool, exponent: Option<i64>, mut magnitude: [u64; K]) -> Self {
        let Some(shift) = limbs::leading_zeros(&magnitude) else { return Self::ZERO };
        limbs::shift_left(&mut magnitude, shift);
        let mut mantissa = [0; LIMBS];
        mantissa.copy_from_slice(&magnitude[K - LIMBS..]);
        let cut_off = magnitude[..K - LIMBS].iter().any(|&limb| limb != 0);
        Self::number(negative, exponent.and_then(|e| e.checked_sub_unsigned(shift)), mantissa)
            .exact_if(!cut_off)
    }

    /// The same number, exact if it was and this holds.
    fn exact_if(self, holds: bool) -> Self {
        Self { exact: self.exact && holds, ..self }
    }

    /// Whether this is the value of a formula itself: nothing was cut off, in it or in what it was made from.
    pub(crate) fn is_exact(&self) -> bool {
        self.exact
    }

    /// Whether this is a number (zero included) rather than undefined.
    pub(crate) fn is_defined(&self) -> bool {
        self.state != State::Undefined
    }

    /// self·2^power, exactly.
    pub(crate) fn scaled(self, power: i64) -> Self {
        match self.state {
            State::Number => Self::number(self.negative, self.exponent.checked_add(power), self.mantissa),
            State::Zero | State::Undefined => self,
        }
    }

    /// How |self| compares to |other|; `None` if either is undefined.
    pub(crate) fn compare_magnitudes(&self, other: &Self) -> Option<Ordering> {
        match (self.state, other.state) {
            (State::Undefined, _) | (_, State::Undefined) => None,
            (State::Number, State::Number) => {
                let exponents = self.exponent.cmp(&other.exponent);
                Some(exponents.then_with(|| limbs::compare(&self.mantissa, &other.mantissa)))
            }
            (State::Zero, State::Zero) => Some(Ordering::Equal),
            (State::Zero, State::Number) => Some(Ordering::Less),
            (State::Number, State::Zero) => Some(Ordering::Greater),
        }
    }
}

/// Undefined equals nothing, itself included.
impl PartialEq for Wide {
    fn eq(&self, other: &Self) -> bool {
        self.negative == other.negative && self.compare_magnitudes(other) == Some(Ordering::Equal)
    }
}
