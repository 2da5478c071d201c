//! [`Wide`] against exact numbers: n·2^k with big integers n, so that nothing is rounded on the side that judges.
//!
//! Operands are seeded: mantissas at random, of all ones, of single bits, of long runs; exponents from −5000 to 5000, or close
//! together, so that sums cancel.

mod constants;
mod conversions;
mod operations;
mod sizes;

use num_bigint::{BigInt, Sign};
use num_traits::Zero;

use super::{LIMBS, Wide};

/// integer·2^exponent.
#[derive(Clone, Debug)]
struct Dyadic {
    integer: BigInt,
    exponent: i64,
}

impl Dyadic {
    fn of(number: Wide) -> Self {
        assert!(number.is_defined(), "an undefined number has no value");
        if number.is_zero() {
            return Self { integer: BigInt::zero(), exponent: 0 };
        }
        let sign = if number.negative { Sign::Minus } else { Sign::Plus };
        let bytes = number.mantissa.map(u64::to_le_bytes).concat();
        Self { integer: BigInt::from_bytes_le(sign, &bytes), exponent: number.exponent - 1023 }
    }

    /// The integers of both over the smaller exponent, which is the third.
    fn aligned(&self, other: &Self) -> (BigInt, BigInt, i64) {
        let exponent = self.exponent.min(other.exponent);
        let shifted = |dyadic: &Self| &dyadic.integer << (dyadic.exponent - exponent) as u64;
        (shifted(self), shifted(other), exponent)
    }

    fn plus(&self, other: &Self) -> Self {
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

    /// Whether |self| ≤ |other|.
    fn is_within(&self, other: &Self) -> bool {
        let (a, b, _) = self.aligned(other);
        a.magnitude() <= b.magnitude()
    }

    fn equals(&self, other: &Self) -> bool {
        self.minus(other).integer.is_zero()
    }
}

/// SplitMix64.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// An integer from −limit to limit.
    fn within(&mut self, limit: i64) -> i64 {
        (self.bits() % (2 * limit as u64 + 1)) as i64 - limit
    }

    /// Limbs of one of the shapes that carries and borrows run through.
    fn limbs(&mut self) -> [u64; LIMBS] {
        let mut limbs = match self.bits() % 5 {
            0 => [u64::MAX; LIMBS],
            1 => [0; LIMBS],
            2 => core::array::from_fn(|_| if self.bits() & 1 == 0 { 0 } else { u64::MAX }),
            _ => core::array::from_fn(|_| self.bits()),
        };
        // A bit or two of a regular mantissa changed.
        for _ in 0..self.bits() % 3 {
            let place = self.bits() % (64 * LIMBS as u64);
            limbs[(place / 64) as usize] ^= 1 << (place % 64);
        }
        limbs[LIMBS - 1] |= 1 << 63;
        limbs
    }

    fn wide(&mut self, exponent: i64) -> Wide {
        Wide::number(self.bits() & 1 == 1, Some(exponent), self.limbs())
    }

    /// Two numbers: far apart, within each other's bits, or nearly opposite.
    fn pair(&mut self) -> [Wide; 2] {
        let exponent = self.within(5000);
        let a = self.wide(exponent);
        let b = match self.bits() % 4 {
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
            _ => {
                // −a but for its lowest limbs.
                let mut b = -a;
                for place in 0..self.bits() % 6 {
                    b.mantissa[place as usize] = self.bits();
                }
                b.scaled(i64::from(self.bits() & 3 == 0))
            }
        };
        [a, b]
    }
}
