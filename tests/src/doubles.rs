//! Doubles against exact numbers: conversions, the distance to the next double, draws.

use kahan_algebra::prime_field::SplitMix64;
use num_traits::ToPrimitive;

use crate::exact::Q;

/// The number that a float is.
///
/// # Panics
/// If it is not finite.
#[must_use]
pub fn exact(value: impl Into<f64>) -> Q {
    Q::from_float(value.into()).expect("a finite number")
}

/// The nearest double, or one beside it.
///
/// # Panics
/// Never: a rational has one.
#[must_use]
pub fn float(value: &Q) -> f64 {
    value.to_f64().expect("a rational has a nearby f64")
}

/// The distance of a double from the next one away from zero.
#[must_use]
pub fn ulp(value: f64) -> f64 {
    let size = value.abs();
    f64::from_bits(size.to_bits() + 1) - size
}

/// Uniform in ±[0, 1), all bits random.
pub fn signed_unit(draws: &mut SplitMix64) -> f64 {
    let size = draws.below(1 << 53) as f64 / (1_u64 << 53) as f64;
    if draws.below(2) == 0 { size } else { -size }
}
