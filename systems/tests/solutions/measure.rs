//! Reads numbers from text, and measures distances between numbers.

use kahan_core::num_traits::Zero;
use kahan_systems::special::{Float256, Real};

pub(crate) fn number(text: &str) -> Float256 {
    text.parse().unwrap_or_else(|error| panic!("{error}"))
}

pub(crate) fn ten_to_minus(digits: i64) -> Float256 {
    Float256::from_int(10).power(-digits)
}

/// Asserts that |value − expected| ≤ 10^(−digits) max(|expected|, floor).
#[track_caller]
pub(crate) fn assert_close_above(
    value: &Float256,
    expected: &Float256,
    digits: i64,
    floor: &Float256,
    what: &str,
) {
    let size = if expected.abs() > *floor { expected.abs() } else { *floor };
    let error = (*value - *expected).abs();
    assert!(error <= ten_to_minus(digits) * size, "{what}: {value} where {expected} is expected");
}

#[track_caller]
pub(crate) fn assert_close(value: &Float256, expected: &Float256, digits: i64, what: &str) {
    assert_close_above(value, expected, digits, &Float256::zero(), what);
}

/// Returns the error of an `f64` in units of 2⁻⁵² max(|expected|, floor).
pub(crate) fn ulps_above(value: f64, expected: &Float256, floor: f64) -> f64 {
    let size = expected.abs().to_f64().max(floor);
    ((Float256::from(value) - *expected) / Float256::from(size * f64::EPSILON)).to_f64().abs()
}
