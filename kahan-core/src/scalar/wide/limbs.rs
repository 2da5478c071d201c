//! Arithmetic on natural numbers as rows of 64-bit limbs, the lowest limb first.
//!
//! In and out: arrays and slices of a length that the caller chose; nothing here knows signs or exponents.

use core::cmp::Ordering;

use super::LIMBS;

/// How a compares to b, for rows of one length.
pub(super) fn compare(a: &[u64; LIMBS], b: &[u64; LIMBS]) -> Ordering {
    a.iter().rev().cmp(b.iter().rev())
}

/// The zero bits above the top set bit, or `None` for zero.
pub(super) fn leading_zeros(limbs: &[u64]) -> Option<u64> {
    let top = limbs.iter().rposition(|&limb| limb != 0)?;
    Some(64 * (limbs.len() - 1 - top) as u64 + u64::from(limbs[top].leading_zeros()))
}

/// The zero bits below the lowest set bit; all bits for zero.
pub(super) fn trailing_zeros(limbs: &[u64]) -> u64 {
    let lowest = limbs.iter().position(|&limb| limb != 0);
    lowest.map_or(64 * limbs.len() as u64, |i| 64 * i as u64 + u64::from(limbs[i].trailing_zeros()))
}

/// Shifts up by `shift` bits; what leaves at the top is lost.
pub(super) fn shift_left(limbs: &mut [u64], shift: u64) {
    let (whole, part) = (usize::try_from(shift / 64).unwrap_or(usize::MAX), (shift % 64) as u32);
    let at = |limbs: &[u64], index: Option<usize>| index.map_or(0, |index| limbs[index]);
    for i in (0..limbs.len()).rev() {
        let high = at(limbs, i.checked_sub(whole));
        let low = at(limbs, i.checked_sub(whole).and_then(|below| below.checked_sub(1)));
        // A pair of limbs, so that a shift by no bits needs no case of its own.
        let pair = (u128::from(high) << 64) | u128::from(low);
        limbs[i] = ((pair << part) >> 64) as u64;
    }
}

/// Shifts down by `shift` bits; what leaves at the bottom is lost.
pub(super) fn shift_right(limbs: &mut [u64], shift: u64) {
    let (whole, part) = (usize::try_from(shift / 64).unwrap_or(usize::MAX), (shift % 64) as u32);
    let at = |limbs: &[u64], index: Option<usize>| index.and_then(|i| limbs.get(i)).copied().unwrap_or(0);
    for i in 0..limbs.len() {
        let low = at(limbs, i.checked_add(whole));
        let high = at(limbs, i.checked_add(whole).and_then(|above| above.checked_add(1)));
        let pair = (u128::from(high) << 64) | u128::from(low);
        limbs[i] = (pair >> part) as u64;
    }
}

/// a += b for rows of one length; true if a bit was carried out at the top.
pub(super) fn add(a: &mut [u64], b: &[u64]) -> bool {
    let mut carry = false;
    for (a, &b) in a.iter_mut().zip(b) {
        (*a, carry) = a.carrying_add(b, carry);
    }
    carry
}

/// a −= b for rows of one length; true if a < b, the difference then being taken modulo a power of two.
pub(super) fn subtract(a: &mut [u64], b: &[u64]) -> bool {
    let mut borrow = false;
    for (a, &b) in a.iter_mut().zip(b) {
        (*a, borrow) = a.borrowing_sub(b, borrow);
    }
    borrow
}

/// a·b, every limb of it.
pub(super) fn product(a: &[u64; LIMBS], b: &[u64; LIMBS]) -> [u64; 2 * LIMBS] {
    let mut product = [0; 2 * LIMBS];
    for (i, &a) in a.iter().enumerate() {
        let mut carry = 0;
        for (j, &b) in b.iter().enumerate() {
            (product[i + j], carry) = a.carrying_mul_add(b, carry, product[i + j]);
        }
        product[i + LIMBS] = carry;
    }
    product
}

/// ⌊a·2¹⁰²⁴/b⌋ for b with its top bit set: long division, one limb of the quotient a round (Knuth, The Art of Computer
/// Programming 2, §4.3.1, algorithm D).
pub(super) fn quotient(a: &[u64; LIMBS], b: &[u64; LIMBS]) -> [u64; LIMBS + 1] {
    let mut remainder = [0; 2 * LIMBS + 1];
    remainder[LIMBS..2 * LIMBS].copy_from_slice(a);
    let mut quotient = [0; LIMBS + 1];
    for place in (0..=LIMBS).rev() {
        // Invariant: the limbs of the remainder from `place` on are below b·2⁶⁴, so the digit is below 2⁶⁴.
        let window = &mut remainder[place..=place + LIMBS];
        let mut digit = estimate(window, b);
        if subtract_multiple(window, b, digit) {
            // The estimate was one too large, and the remainder is negative, modulo 2^(64·7).
            digit -= 1;
            let (rest, top) = window.split_at_mut(LIMBS);
            let carry = add(rest, b);
            top[0] = top[0].wrapping_add(u64::from(carry));
        }
        quotient[place] = digit;
    }
    quotient
}

/// The next digit of a quotient from the three top limbs of the remainder and two of b: right, or one too large.
fn estimate(window: &[u64], b: &[u64; LIMBS]) -> u64 {
    let (divisor, next) = (u128::from(b[LIMBS - 1]), u128::from(b[LIMBS - 2]));
    let top = (u128::from(window[LIMBS]) << 64) | u128::from(window[LIMBS - 1]);
    let (mut digit, mut rest) = (top / divisor, top % divisor);
    // The digit is at most 2⁶⁴ + 1 before the first comparison, and its product with a limb is not formed until it is
    // below 2⁶⁴; the rest is below 2⁶⁴ when it is shifted.
    while digit >> 64 != 0 || digit * next > ((rest << 64) | u128::from(window[LIMBS - 2])) {
        digit -= 1;
        rest += divisor;
        if rest >> 64 != 0 {
            break;
        }
    }
    digit as u64
}

/// window −= digit·b, where the window has one limb more than b; true if that is negative.
fn subtract_multiple(window: &mut [u64], b: &[u64; LIMBS], digit: u64) -> bool {
    let (mut carry, mut borrow) = (0, false);
    for (w, &b) in window.iter_mut().zip(b) {
        let low;
        (low, carry) = digit.carrying_mul(b, carry);
        (*w, borrow) = w.borrowing_sub(low, borrow);
    }
    (window[LIMBS], borrow) = window[LIMBS].borrowing_sub(carry, borrow);
    borrow
}
