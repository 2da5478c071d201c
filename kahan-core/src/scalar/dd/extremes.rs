//! The operations on operands for which intermediate results would leave the range of `f64`.
//!
//! Finite operands are scaled by powers of two, which is exact unless a part underflows. Results
//! beyond the range are infinite.

use crate::scalar::bounded::power_of_two;

use super::error_free::{root, two_product, two_sum};
use super::moderate::with_lower;
use super::{Dd, moderate};

#[cold]
#[inline(never)]
pub(super) fn sum(x: Dd, y: Dd) -> Dd {
    if !(x.is_finite() && y.is_finite()) {
        return Dd::leading(x.high + y.high);
    }
    let (x, y) = (scaled(x, -4), scaled(y, -4));
    scaled(with_lower(two_sum(x.high, y.high), x.low, y.low), 4)
}

#[cold]
#[inline(never)]
pub(super) fn product(x: Dd, y: Dd) -> Dd {
    let Some((x, y, exponents)) = leading_in_one_to_two(x, y) else {
        return Dd::leading(x.high * y.high);
    };
    scaled(moderate::product(two_product(x.high, y.high), x, y), exponents.0 + exponents.1)
}

#[cold]
#[inline(never)]
pub(super) fn quotient(x: Dd, y: Dd) -> Dd {
    let Some((x, y, exponents)) = leading_in_one_to_two(x, y) else {
        return Dd::leading(x.high / y.high);
    };
    scaled(moderate::quotient(x, y), exponents.0 - exponents.1)
}

#[cold]
#[inline(never)]
pub(super) fn square_root(x: Dd) -> Dd {
    if x.high > 0.0 && x.is_finite() {
        let half = exponent(x.high).div_euclid(2);
        scaled(moderate::square_root(scaled(x, -2 * half)), half)
    } else {
        Dd::leading(root(x.high))
    }
}

/// Scales finite nonzero numbers into [1, 2), and returns the removed binary exponents.
fn leading_in_one_to_two(x: Dd, y: Dd) -> Option<(Dd, Dd, (i32, i32))> {
    let is_plain = |x: Dd| x.is_finite() && x.high != 0.0;
    if !(is_plain(x) && is_plain(y)) {
        return None;
    }
    let exponents = (exponent(x.high), exponent(y.high));
    Some((scaled(x, -exponents.0), scaled(y, -exponents.1), exponents))
}

/// Returns e with 2ᵉ ≤ |x| < 2ᵉ⁺¹, for a finite nonzero x.
pub(super) fn exponent(x: f64) -> i32 {
    let bits = x.abs().to_bits();
    match (bits >> 52) as i32 {
        // A subnormal number is bits·2⁻¹⁰⁷⁴.
        0 => -1011 - bits.leading_zeros() as i32,
        biased => biased - 1023,
    }
}

/// Returns 2ᵏx. Below the normal range each part has an error of at most 2⁻¹⁰⁷⁴.
pub(super) fn scaled(x: Dd, k: i32) -> Dd {
    // If k is beyond ±2200, every result is infinite or 0.
    let k = k.clamp(-2200, 2200);
    let third = k / 3;
    let [a, b, c] = [power_of_two(third), power_of_two(third), power_of_two(k - 2 * third)];
    let high = x.high * a * b * c;
    Dd::new(high, if high.is_finite() { x.low * a * b * c } else { 0.0 })
}
