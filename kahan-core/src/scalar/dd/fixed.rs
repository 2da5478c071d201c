//! Binary fixed-point numbers that hold any sum of two `f64`, for conversions from and to text.

use crate::scalar::bounded::power_of_two;

use super::Dd;

/// The number of 64-bit limbs before the point, and also after it.
pub(super) const HALF: usize = 17;

const POINT: i32 = 64 * HALF as i32;

/// The number Σ limbsᵢ·2⁶⁴ⁱ⁻¹⁰⁸⁸, where i is the index of a limb.
#[derive(Clone, PartialEq, Eq)]
pub(super) struct Fixed {
    pub(super) limbs: [u64; 2 * HALF],
}

impl Fixed {
    pub(super) const ZERO: Self = Self { limbs: [0; 2 * HALF] };

    pub(super) fn magnitude(x: f64) -> Self {
        let bits = x.abs().to_bits();
        let biased = (bits >> 52) as i32;
        let fraction = bits & ((1 << 52) - 1);
        let significand = if biased == 0 { fraction } else { fraction | 1 << 52 };
        let (limb, shift) = place(biased.max(1) - 1075);
        let mut fixed = Self::ZERO;
        let shifted = u128::from(significand) << shift;
        fixed.limbs[limb] = shifted as u64;
        fixed.limbs[limb + 1] = (shifted >> 64) as u64;
        fixed
    }

    pub(super) fn magnitude_of(x: Dd) -> Self {
        let (high, low) = (Self::magnitude(x.high), Self::magnitude(x.low));
        if x.high.is_sign_negative() == x.low.is_sign_negative() { high.plus(&low) } else { high.minus(&low) }
    }

    fn plus(mut self, other: &Self) -> Self {
        let mut carry = 0;
        for (mine, theirs) in self.limbs.iter_mut().zip(&other.limbs) {
            let sum = u128::from(*mine) + u128::from(*theirs) + carry;
            *mine = sum as u64;
            carry = sum >> 64;
        }
        self
    }

    pub(super) fn minus(mut self, other: &Self) -> Self {
        let mut borrow = false;
        for (mine, theirs) in self.limbs.iter_mut().zip(&other.limbs) {
            let (difference, first) = mine.overflowing_sub(*theirs);
            let (difference, second) = difference.overflowing_sub(u64::from(borrow));
            *mine = difference;
            borrow = first || second;
        }
        self
    }

    pub(super) fn is_less(&self, other: &Self) -> bool {
        self.limbs.iter().rev().lt(other.limbs.iter().rev())
    }

    pub(super) fn last_place() -> Self {
        let mut fixed = Self::ZERO;
        fixed.limbs[0] = 1;
        fixed
    }

    /// Rounds a number below 2¹⁰²⁴ to the nearest float, ties to even. `has_more` says that the
    /// exact number is slightly larger.
    pub(super) fn rounded(&self, has_more: bool) -> f64 {
        let Some(top) = self.limbs.iter().rposition(|&limb| limb != 0) else { return 0.0 };
        let leading = 64 * top as i32 + 63 - self.limbs[top].leading_zeros() as i32;
        // The exponent of the float's last bit.
        let last = (leading - POINT - 52).max(-1074);
        let (limb, shift) = place(last);
        let next = self.limbs.get(limb + 1).copied().unwrap_or(0);
        let kept = ((u128::from(next) << 64 | u128::from(self.limbs[limb])) >> shift) as u64;
        let (half_limb, half_shift) = place(last - 1);
        let half = self.limbs[half_limb] >> half_shift & 1 == 1;
        let rest = self.limbs[half_limb] & ((1 << half_shift) - 1) != 0
            || self.limbs[..half_limb].iter().any(|&limb| limb != 0)
            || has_more;
        let up = half && (rest || kept & 1 == 1);
        // The significand is at most 2⁵³, and therefore both products are exact.
        let significand = (kept + u64::from(up)) as f64;
        let first = last / 2;
        significand * power_of_two(first) * power_of_two(last - first)
    }
}

/// Returns the indices of a limb, and of the bit in this limb whose value is 2^exponent.
fn place(exponent: i32) -> (usize, u32) {
    let bit = (exponent + POINT) as u32;
    ((bit / 64) as usize, bit % 64)
}
