//! Logarithms of big integers, accurate to the last digits of `f64`.
//!
//! If m has b bits, log m = b·log 2 + log(m/2ᵇ), where m/2ᵇ is taken from the top three words.
//! Below 2⁵³ the logarithm of m as `f64` is taken, so that log 1 = 0.

use std::f64::consts::{LN_2, LN_10};

use dashu_int::ops::BitTest;
use dashu_int::{UBig, Word};

/// The leading 32 bits of log 2. The product with a number below 2²¹ is exact.
const LN_2_HIGH: f64 = f64::from_bits(LN_2.to_bits() & !0x1f_ffff);
/// log 2 − [`LN_2_HIGH`], including the rounding error of the double `LN_2`.
const LN_2_LOW: f64 = (LN_2 - LN_2_HIGH) + 2.319_046_813_846_299_6e-17;

/// Returns log m with an error below one unit in the last place; 0 for m = 0.
pub(crate) fn natural_logarithm(m: &UBig) -> f64 {
    let bits = m.bit_len();
    if bits <= 53 {
        let small = u64::try_from(m).expect("it has at most 53 bits");
        return if small == 0 { 0.0 } else { libm::log(small as f64) };
    }
    let words = m.as_words();
    // Three 64-bit words hold 128 significant bits even if the first has leading zeros.
    let fraction = words.iter().rev().take(3).enumerate().fold(0.0, |sum, (i, &word)| {
        let place = (words.len() - 1 - i) as i64 * i64::from(Word::BITS) - bits as i64;
        sum + word as f64 * libm::exp2(place as f64)
    });
    let bits = bits as f64;
    bits * LN_2_HIGH + (bits * LN_2_LOW + libm::log(fraction))
}

/// Returns the number of decimal digits of m > 0; `logarithm` is log m.
pub(crate) fn decimal_digits(m: &UBig, logarithm: f64) -> u64 {
    let digits = logarithm / LN_10;
    // If `digits` is nearly an integer, rounding could err, so m is compared with a power of ten.
    let nearest = digits.round();
    if (digits - nearest).abs() > 1e-9 * nearest.max(1.0) {
        return digits.floor() as u64 + 1;
    }
    let power = UBig::from(10_u8).pow(nearest as usize);
    nearest as u64 + u64::from(*m >= power)
}
