//! Exact numbers known at run time as the constants that every scalar can be built from.

use kahan_algebra::rational::Rational;
use kahan_core::Constant;

/// Up to this size numerators and denominators make a [`Constant::ratio`], as in generated code.
const EXACT_IN_F32: i64 = 1 << 24;

/// The constant that generated code writes for this number: every scalar rounds it once.
///
/// A number beyond 64-bit integers and small ratios keeps its digits as static data, which
/// generated code has too; here that is memory that is never given back, some bytes a number.
#[must_use]
pub fn constant(value: &Rational) -> Constant {
    if let Some(integer) = value.as_i64() {
        return Constant::integer(integer);
    }
    if let Some((p, q)) = value.as_small_ratio().filter(|(p, q)| p.abs().max(*q) <= EXACT_IN_F32) {
        return Constant::ratio(p, q);
    }
    let (high, low) = value.to_double_double();
    let limbs = |digits: Vec<u64>| -> &'static [u64] { Vec::leak(digits) };
    Constant::exact(
        value.is_negative(),
        limbs(value.numerator().iter_u64_digits().collect()),
        limbs(value.denominator().iter_u64_digits().collect()),
        value.to_f32(),
        high,
        low,
    )
}
