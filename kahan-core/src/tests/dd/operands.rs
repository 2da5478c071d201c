//! Random operands of difficult kinds: ties, gaps between the parts, few bits, cancellation.

use crate::Dd;

/// The random generator SplitMix64 (Steele, Lea, Flood 2014).
pub(super) struct Operands(u64);

impl Operands {
    pub(super) fn seeded(seed: u64) -> Self {
        Self(seed)
    }

    pub(super) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ self.0 >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ mixed >> 31
    }

    pub(super) fn below(&mut self, bound: u64) -> u64 {
        self.bits() % bound
    }

    pub(super) fn between(&mut self, least: i32, most: i32) -> i32 {
        least + self.below((most - least + 1) as u64) as i32
    }

    /// Returns the 52 bits after the leading bit.
    fn fraction(&mut self) -> u64 {
        const ALL: u64 = (1 << 52) - 1;
        match self.below(8) {
            0 => self.below(4),
            1 => ALL - self.below(4),
            2 => self.bits() << 40 & ALL,
            3 => self.bits() << 26 & ALL,
            _ => self.bits() & ALL,
        }
    }

    pub(super) fn float(&mut self, exponent: i32) -> f64 {
        let sign = self.bits() & 1 << 63;
        f64::from_bits(sign | ((exponent + 1023) as u64) << 52 | self.fraction())
    }

    /// Returns a number whose high part has this exponent, before rounding.
    pub(super) fn number(&mut self, exponent: i32) -> Dd {
        let high = self.float(exponent);
        let gap = match self.below(8) {
            0 => return Dd::from(high),
            // This gap makes the low part a quarter to a half of an ulp of `high`.
            1..=5 => 54,
            6 => 53 + self.between(1, 8),
            _ => 53 + self.between(1, 60),
        };
        // Low parts below the normal range are left out.
        if exponent - gap < -1022 { Dd::from(high) } else { Dd::new(high, self.float(exponent - gap)) }
    }

    /// Returns a number of an exponent within `reach` of `exponent`, the exponent of x.
    pub(super) fn partner(&mut self, x: Dd, exponent: i32, reach: i32) -> Dd {
        let nudge = self.between(-3, 3) as f64;
        let unit = f64::EPSILON * x.high();
        match self.below(6) {
            0 => Dd::new(-x.high(), self.float(exponent - 54)),
            1 => Dd::new(-x.high() + nudge * unit, self.float(exponent - 54)),
            2 => Dd::new(-x.high() + nudge * unit, -x.low()),
            3 => Dd::new(-x.high(), -x.low() * (1.0 + nudge * f64::EPSILON)),
            _ => {
                let other = exponent + self.between(-reach, reach);
                self.number(other)
            }
        }
    }
}
