//! Exponential function, logarithm, sine and cosine, with error bounds in terms of u = 2⁻⁵³.
//!
//! The argument is reduced to a small r, at which a series is summed. The reduction, the last sum
//! and the other terms of the series contribute to the error bounds.

use core::f64::consts::{FRAC_2_PI, FRAC_PI_2, LOG2_E, SQRT_2};

use crate::scalar::bounded::power_of_two;

use super::Dd;
use super::error_free::two_product;
use super::extremes::{exponent, scaled};

/// The leading 40 bits of ln 2, so that products with exponents are exact.
const LN_2: f64 = 0.6931471805592082;
const REST_OF_LN_2: Dd = Dd { high: 7.371002565167799e-13, low: 1.94704509238075e-31 };

const HALF_PI: [f64; 2] = [FRAC_PI_2, 6.123233995736766e-17];
const REST_OF_HALF_PI: Dd = Dd { high: -1.4973849048591698e-33, low: 5.562271104316826e-50 };

/// Returns 1 + z/(n + 1)·(1 + z/(n + 2)·(1 + …)), where n is `first` and the last divisor is
/// `last`. With `step` 2, the divisors are (n + 1)(n + 2), (n + 3)(n + 4), ….
fn series(z: Dd, first: i32, step: usize, last: i32) -> Dd {
    let one = Dd::from(1.0);
    (first..last).step_by(step).rev().fold(one, |sum, n| {
        let divisor = if step == 1 { n + 1 } else { (n + 1) * (n + 2) };
        sum * z / Dd::from(divisor) + one
    })
}

/// Returns eˣ with a relative error of at most 12u².
///
/// Write x = k·ln 2 + r with |r| ≤ ½ ln 2. The error of r is 6u²|r|, and the last sum rounds by
/// 3u². The other terms, eʳ − 1, have the relative error 14u² and are at most 0.42 of the value.
pub(super) fn exp(x: Dd) -> Dd {
    // Outside this range the result is 0, infinite or NaN.
    if x.is_nan() || x.high.abs() > 800.0 {
        return Dd::from(libm::exp(x.high));
    }
    let k = libm::rint(x.high * LOG2_E);
    let r = (x - Dd::from(k * LN_2)) - Dd::from(k) * REST_OF_LN_2;
    scaled(series(r, 0, 1, 22), k as i32)
}

/// Returns ln x with a relative error of at most 32u². The result is −∞ at 0, and NaN below 0.
///
/// Write x = 2ᵏm with √½ ≤ m ≤ √2. Then ln m is 2 artanh s for s = (m − 1)/(m + 1), with an error
/// of 20u² from s and one of 4u² from the series. |ln m| is at most |ln x|, and two more sums round
/// by 3u² each.
pub(super) fn ln(x: Dd) -> Dd {
    if x.high <= 0.0 || !x.is_finite() {
        return Dd::from(libm::log(x.high));
    }
    let below = exponent(x.high);
    let k = below + i32::from(scaled(x, -below).high > SQRT_2);
    let (m, one) = (scaled(x, -k), Dd::from(1.0));
    let s = (m - one) / (m + one);
    let z = s * s;
    let tail = (1..=21).rev().fold(Dd::default(), |sum, n| (sum + Dd::from(2 * n + 1).recip()) * z);
    let twice = s + s;
    let k = f64::from(k);
    (twice * tail + twice + Dd::from(k) * REST_OF_LN_2) + Dd::from(k * LN_2)
}

/// Returns sin x and cos x, each with a relative error of at most 16u² plus 2⁻¹⁵⁵|x|. The results
/// are NaN for |x| > 2⁴⁰.
///
/// Write x = k·π/2 + r with |r| ≤ π/4. Then r has the error 6u²|r|, plus 6u² times `second` if
/// `first` cancels x. The last sum rounds by 3u². The other terms of the sine have the relative
/// error 38u², and are at most 0.12 of the value. The other terms of the cosine have the relative
/// error 18u², and are at most 0.42 of the value.
pub(super) fn sin_cos(x: Dd) -> (Dd, Dd) {
    if x.is_nan() || x.high.abs() > power_of_two(40) {
        return (Dd::from(f64::NAN), Dd::from(f64::NAN));
    }
    let k = libm::rint(x.high * FRAC_2_PI);
    let [first, second] = HALF_PI.map(|part| {
        let (high, low) = two_product(k, part);
        Dd { high, low }
    });
    let r = (x - first) - (second + Dd::from(k) * REST_OF_HALF_PI);
    let z = -(r * r);
    let sin = series(z, 3, 2, 27) * z / Dd::from(6) * r + r;
    let cos = series(z, 0, 2, 28);
    match (k as i64).rem_euclid(4) {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}
