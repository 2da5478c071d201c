//! Constants with 40 decimal places, rounded at compile time by exact long division.

use crate::Constant;

const UNIT: Integer256 = Integer256 { high: 0x1d, low: 0x6329_f1c3_5ca4_bfab_b9f5_6100_0000_0000 };
const LIMBS_OF_UNIT: [u64; 3] = UNIT.limbs();

/// The number `high`·2¹²⁸ + `low`.
#[derive(Clone, Copy)]
struct Integer256 {
    high: u128,
    low: u128,
}

impl Integer256 {
    const fn plus(self, other: Self) -> Self {
        let (low, carry) = self.low.overflowing_add(other.low);
        Self { high: self.high + other.high + carry as u128, low }
    }

    const fn minus(self, other: Self) -> Self {
        let (low, borrow) = self.low.overflowing_sub(other.low);
        Self { high: self.high - other.high - borrow as u128, low }
    }

    const fn doubled(self) -> Self {
        self.plus(self)
    }

    const fn is_less_than(self, other: Self) -> bool {
        self.high < other.high || (self.high == other.high && self.low < other.low)
    }

    const fn limbs(self) -> [u64; 3] {
        [self.low as u64, (self.low >> 64) as u64, self.high as u64]
    }
}

pub(super) struct Decimal {
    negative: bool,
    limbs: [u64; 3],
    single: f32,
    double: f64,
    low: f64,
}

impl Decimal {
    /// Parses an optional sign, an integer part, a point and 40 decimal places.
    pub(super) const fn read(text: &str) -> Self {
        let text = text.as_bytes();
        let negative = text[0] == b'-';
        let mut digits = Integer256 { high: 0, low: 0 };
        let mut place = negative as usize;
        while place < text.len() {
            if text[place] != b'.' {
                let four = digits.doubled().doubled();
                let digit = Integer256 { high: 0, low: (text[place] - b'0') as u128 };
                digits = digits.plus(four).doubled().plus(digit);
            }
            place += 1;
        }
        assert!(text[text.len() - 41] == b'.', "40 digits follow the point");
        let sign = if negative { -1.0 } else { 1.0 };
        let (single, _, _) = nearest(digits, f32::MANTISSA_DIGITS);
        let (double, rest, unit) = nearest(digits, f64::MANTISSA_DIGITS);
        let is_below = !rest.is_less_than(UNIT.minus(rest));
        let (low, _, _) = nearest(if is_below { UNIT.minus(rest) } else { rest }, f64::MANTISSA_DIGITS);
        let low = if is_below { -low } else { low } * unit;
        Self {
            negative,
            limbs: digits.limbs(),
            single: (sign * single) as f32,
            double: sign * double,
            low: sign * low,
        }
    }

    pub(super) const fn as_constant(&self) -> Constant<'_> {
        Constant::exact(self.negative, &self.limbs, &LIMBS_OF_UNIT, self.single, self.double, self.low)
    }
}

/// Rounds `part`/10⁴⁰, a number from 0 to 2, to a float of `bits` bits. Returns the float, the
/// remainder below its last place, and one unit in the last place.
const fn nearest(part: Integer256, bits: u32) -> (f64, Integer256, f64) {
    let (mut rest, mut unit) = (part, 1.0);
    while rest.is_less_than(UNIT) {
        rest = rest.doubled();
        unit /= 2.0;
    }
    let mut mantissa = 1_u64;
    rest = rest.minus(UNIT);
    let mut count = 1;
    while count < bits {
        rest = rest.doubled();
        unit /= 2.0;
        let bit = !rest.is_less_than(UNIT);
        mantissa = 2 * mantissa + bit as u64;
        rest = if bit { rest.minus(UNIT) } else { rest };
        count += 1;
    }
    let is_below = !rest.is_less_than(UNIT.minus(rest));
    ((mantissa + is_below as u64) as f64 * unit, rest, unit)
}
