//! Converts between doubles and exact numbers, measures ulps, and draws random doubles.

use kahan_algebra::prime_field::SplitMix64;
use num_traits::ToPrimitive;

use crate::exact::Q;

/// Converts a float exactly. Panics for infinities and NaN.
#[must_use]
pub fn exact(value: impl Into<f64>) -> Q {
    Q::from_float(value.into()).expect("a finite number")
}

/// Converts a number to a double. The result is the nearest double or a neighbour of the nearest.
#[must_use]
pub fn float(value: &Q) -> f64 {
    value.to_f64().expect("a rational has a nearby f64")
}

/// Returns the distance from a double to the next double away from zero.
#[must_use]
pub fn ulp(value: f64) -> f64 {
    let size = value.abs();
    f64::from_bits(size.to_bits() + 1) - size
}

/// Draws a uniform number between −1 and 1, with 53 random bits and a random sign.
pub fn signed_unit(draws: &mut SplitMix64) -> f64 {
    let size = draws.below(1 << 53) as f64 / (1_u64 << 53) as f64;
    if draws.below(2) == 0 { size } else { -size }
}
