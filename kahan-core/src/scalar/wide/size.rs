//! Magnitudes of [`Wide`](super::Wide) numbers for error bounds, with an exponent and 53 bits.

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul};

use num_traits::Zero;

/// A magnitude mantissa·2^exponent with a mantissa in [1, 2), or a mantissa 0, ∞ or NaN with
/// exponent 0. Operations round by at most 2⁻⁵². An exponent out of range gives NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Size {
    pub(super) exponent: i64,
    pub(super) mantissa: f64,
}

/// The bit pattern of the float 1.0.
const ONE: u64 = 1023 << 52;
const FRACTION: u64 = (1 << 52) - 1;

fn power_of_two(power: i64) -> f64 {
    f64::from_bits(((1023 + power) as u64) << 52)
}

impl Size {
    const UNKNOWN: Self = Self { exponent: 0, mantissa: f64::NAN };

    /// Returns mantissa·2^exponent for a mantissa that is not subnormal.
    fn normalised(mantissa: f64, exponent: Option<i64>) -> Self {
        if !mantissa.is_normal() {
            return Self { exponent: 0, mantissa };
        }
        let bits = mantissa.to_bits();
        let shift = (bits >> 52) as i64 - 1023;
        exponent.and_then(|exponent| exponent.checked_add(shift)).map_or(Self::UNKNOWN, |exponent| Self {
            exponent,
            mantissa: f64::from_bits(ONE | bits & FRACTION),
        })
    }

    pub(crate) fn scaled(self, power: i64) -> Self {
        Self::normalised(self.mantissa, self.exponent.checked_add(power))
    }

    pub(crate) fn is_unknown(self) -> bool {
        self.mantissa.is_nan()
    }

    fn is_normal(self) -> bool {
        self.mantissa.is_normal()
    }
}

impl From<f64> for Size {
    fn from(value: f64) -> Self {
        if value < f64::MIN_POSITIVE {
            Self::normalised(value * power_of_two(100), Some(-100))
        } else {
            Self::normalised(value, Some(0))
        }
    }
}

impl From<Size> for f64 {
    fn from(size: Size) -> Self {
        let exponent = size.exponent.clamp(-1200, 1200);
        size.mantissa * power_of_two(exponent / 2) * power_of_two(exponent - exponent / 2)
    }
}

impl Add for Size {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self.is_zero() {
            return other;
        }
        if other.is_zero() {
            return self;
        }
        if !(self.is_normal() && other.is_normal()) {
            return Self { exponent: 0, mantissa: self.mantissa + other.mantissa };
        }
        let (large, small) = if self.exponent < other.exponent { (other, self) } else { (self, other) };
        match large.exponent.checked_sub(small.exponent) {
            Some(distance @ ..=1000) => {
                let mantissa = large.mantissa + small.mantissa * power_of_two(-distance);
                Self::normalised(mantissa, Some(large.exponent))
            }
            _ => large,
        }
    }
}

impl Mul for Size {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::normalised(self.mantissa * other.mantissa, self.exponent.checked_add(other.exponent))
    }
}

impl Div for Size {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        Self::normalised(self.mantissa / other.mantissa, self.exponent.checked_sub(other.exponent))
    }
}

impl PartialOrd for Size {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let mantissas = self.mantissa.partial_cmp(&other.mantissa);
        if self.is_normal() && other.is_normal() {
            mantissas.map(|mantissas| self.exponent.cmp(&other.exponent).then(mantissas))
        } else {
            mantissas
        }
    }
}

impl Zero for Size {
    fn zero() -> Self {
        Self { exponent: 0, mantissa: 0.0 }
    }

    fn is_zero(&self) -> bool {
        self.mantissa == 0.0
    }
}
