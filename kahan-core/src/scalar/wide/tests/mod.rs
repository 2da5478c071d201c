//! Compares [`Wide`] with exact numbers n·2^k, where n is a big integer.
//!
//! Operands are random. Their mantissas are random, all ones, single bits or long runs.

mod conversions;
mod literals;
#[cfg(feature = "std")]
mod long;
mod operations;
mod sizes;

use num_bigint::BigInt;
use num_traits::Zero;

use super::rows::DigitRow;
use super::{MAX_PLACE, Size, Wide};

const LIMBS: usize = 16;

#[derive(Clone, Debug)]
struct Dyadic {
    integer: BigInt,
    exponent: i64,
}

impl Dyadic {
    fn of(number: Wide) -> Self {
        assert_eq!(number.denominator, 1, "{number:?}");
        Self::numerator(&number)
    }

    fn numerator(number: &Wide) -> Self {
        assert!(number.is_defined(), "an undefined number has no value");
        let digits = number.digits.iter().zip(&number.below).take(number.count.into());
        digits.fold(Self { integer: BigInt::zero(), exponent: 0 }, |sum, (&digit, &below)| {
            assert!(digit != 0, "{number:?}");
            let exponent = 64 * (number.place - i64::from(below));
            sum.plus(&Self { integer: digit.into(), exponent })
        })
    }

    fn size(size: Size) -> Self {
        Self::of(Wide::from(size.mantissa).scaled(size.exponent))
    }

    /// Returns the integers n, m and e with self = n·2^e and other = m·2^e.
    fn aligned(&self, other: &Self) -> (BigInt, BigInt, i64) {
        let exponent = self.exponent.min(other.exponent);
        let shifted = |dyadic: &Self| &dyadic.integer << (dyadic.exponent - exponent) as u64;
        (shifted(self), shifted(other), exponent)
    }

    fn plus(&self, other: &Self) -> Self {
        if self.integer.is_zero() {
            return other.clone();
        }
        let (a, b, exponent) = self.aligned(other);
        Self { integer: a + b, exponent }
    }

    fn minus(&self, other: &Self) -> Self {
        let (a, b, exponent) = self.aligned(other);
        Self { integer: a - b, exponent }
    }

    fn times(&self, other: &Self) -> Self {
        Self { integer: &self.integer * &other.integer, exponent: self.exponent + other.exponent }
    }

    fn scaled(&self, power: i64) -> Self {
        Self { integer: self.integer.clone(), exponent: self.exponent + power }
    }

    fn is_within(&self, other: &Self) -> bool {
        let (a, b, _) = self.aligned(other);
        a.magnitude() <= b.magnitude()
    }

    /// Returns a slightly larger number, to cover the rounding of a radius.
    fn scaled_up(&self) -> Self {
        self.plus(&self.scaled(-40))
    }

    fn equals(&self, other: &Self) -> bool {
        self.minus(other).integer.is_zero()
    }
}

impl Wide {
    fn scaled(self, power: i64) -> Self {
        if !self.is_defined() || power.unsigned_abs() > 64 * MAX_PLACE {
            return Self::UNDEFINED;
        }
        Self::of(
            &self.row().times(&DigitRow::of_significand(1, power)),
            self.denominator,
            self.radius.scaled(power),
        )
    }
}

struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn within(&mut self, limit: i64) -> i64 {
        (self.bits() % (2 * limit as u64 + 1)) as i64 - limit
    }

    /// Returns limbs that produce long carries and borrows.
    fn limbs(&mut self) -> [u64; LIMBS] {
        let mut limbs = match self.bits() % 5 {
            0 => [u64::MAX; LIMBS],
            1 => [0; LIMBS],
            2 => core::array::from_fn(|_| if self.bits() & 1 == 0 { 0 } else { u64::MAX }),
            _ => core::array::from_fn(|_| self.bits()),
        };
        for _ in 0..self.bits() % 3 {
            let place = self.bits() % (64 * LIMBS as u64);
            limbs[(place / 64) as usize] ^= 1 << (place % 64);
        }
        limbs[LIMBS - 1] |= 1 << 63;
        limbs
    }

    /// Returns a number of about 1024 bits, of which the leading bit stands for 2^exponent.
    fn wide(&mut self, exponent: i64) -> Wide {
        Wide::from_limbs(self.bits() & 1 == 1, &self.limbs()).scaled(exponent - 64 * LIMBS as i64 + 1)
    }

    /// Returns a number of few digits that are far apart.
    fn sparse(&mut self, exponent: i64) -> Wide {
        let parts = 1 + self.bits() % 6;
        (0..parts).fold(Wide::zero(), |sum, _| {
            let below = self.within(3000);
            sum + Wide::from(self.bits() as i64 >> (self.bits() % 64)).scaled(exponent - 64 + below)
        })
    }

    /// Returns two numbers that are far apart, overlapping, nearly opposite, or of few digits.
    fn pair(&mut self) -> [Wide; 2] {
        let exponent = self.within(5000);
        let a = self.wide(exponent);
        let b = match self.bits() % 5 {
            0 => {
                let exponent = self.within(5000);
                self.wide(exponent)
            }
            1 => {
                let distance = self.within(460);
                self.wide(exponent + distance)
            }
            2 => {
                let distance = self.within(2);
                self.wide(exponent + distance)
            }
            3 => {
                // The second number is −a except for its lowest digits.
                let low = self.wide(exponent - 640);
                low - a
            }
            _ => {
                let pair = [self.sparse(exponent), self.sparse(exponent)];
                return if pair.iter().any(Wide::is_zero) { self.pair() } else { pair };
            }
        };
        [a, b]
    }
}
