//! Compares the elementary functions with fixed-point numbers of 700 bits.
//!
//! Taylor series are summed until a term is 0. All errors together are below 2⁻⁶⁰⁰.

use std::vec::Vec;

use num_bigint::BigInt;
use num_traits::{Signed, Zero};

use crate::Dd;

const BITS: usize = 700;

fn one() -> BigInt {
    BigInt::from(1) << BITS
}

/// Returns the exact product of x and two to the power `BITS`; |x| must be 0 or at least 2⁻⁵⁹⁰.
fn fixed(x: Dd) -> BigInt {
    let part = |x: f64| {
        let (bits, sign) = (x.to_bits(), if x < 0.0 { -1 } else { 1 });
        let digits = BigInt::from((bits & ((1 << 52) - 1)) + (1 << 52)) * sign;
        let shift = (bits >> 52 & 0x7ff) as i64 - 1075 + BITS as i64;
        if x == 0.0 { BigInt::zero() } else { digits << usize::try_from(shift).expect("its size") }
    };
    part(x.high()) + part(x.low())
}

/// Sums a series with the first term `first`. Each further term is the previous term times y,
/// divided by the next `step` integers after n.
fn series(first: BigInt, mut n: u32, step: u32, y: &BigInt) -> BigInt {
    let (mut term, mut sum) = (first, BigInt::zero());
    while !term.is_zero() {
        sum += &term;
        term = (term * y) >> BITS;
        for _ in 0..step {
            n += 1;
            term /= n;
        }
    }
    sum
}

fn exp(x: &BigInt) -> BigInt {
    // After ten squarings, the relative error of all roundings is below 2⁻⁶⁰⁰.
    let mut power = series(one(), 0, 1, &(x >> 10));
    for _ in 0..10 {
        power = (&power * &power) >> BITS;
    }
    power
}

/// Returns π by Machin's formula.
fn pi() -> BigInt {
    let arctangent = |n: u32| {
        let (mut power, mut sum, mut k) = (one() / n, BigInt::zero(), 0_u32);
        while !power.is_zero() {
            let term = &power / (2 * k + 1);
            sum += if k % 2 == 0 { term } else { -term };
            power /= n * n;
            k += 1;
        }
        sum
    };
    (arctangent(5) * 4 - arctangent(239)) * 4
}

/// Asserts |computed − exact| ≤ count·u²·|exact| + 2ᵏ, where k = −`least` and u = 2⁻⁵³.
#[track_caller]
fn assert_within(computed: Dd, exact: &BigInt, count: u32, least: usize, x: Dd) {
    let error = (fixed(computed) - exact).abs();
    let bound = ((exact.abs() * count) >> 106) + (one() >> least);
    assert!(error <= bound, "{x:?}: {computed:?}");
}

/// Returns numbers of magnitude 2⁻²⁰ to 2ᵐ with m = `most`, some near multiples of `period`.
fn arguments(most: i32, period: f64) -> Vec<Dd> {
    let mut state = 20_261_128_u64;
    let mut unit = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut numbers = Vec::new();
    for k in 0..400 {
        let size = f64::from(-20 + k % (most + 21)).exp2();
        let ordinary = (2.0 * unit() - 1.0) * size;
        let near = (ordinary / period).round() * period;
        for high in [ordinary, near] {
            let low = (unit() - 0.5) * high * f64::EPSILON;
            numbers.extend([Dd::new(high, low), Dd::from(high)]);
        }
    }
    numbers
}

#[test]
fn exponentials_are_within_their_bound() {
    for x in arguments(6, core::f64::consts::LN_2 / 2.0) {
        let exact = exp(&fixed(x));
        // Small values have fewer significant digits among the 700 bits after the point.
        assert_within(x.exp(), &exact, 12, 500, x);
    }
    assert_eq!(Dd::from(0.0).exp(), Dd::from(1.0));
    assert_eq!(Dd::from(-1e4).exp(), Dd::from(0.0));
    assert_eq!(Dd::from(1e4).exp().high(), f64::INFINITY);
    assert!(Dd::from(f64::NAN).exp().is_nan());
}

#[test]
fn logarithms_are_within_their_bound() {
    for x in arguments(8, 0.5).into_iter().map(Dd::abs).filter(|x| x.high() > 0.0) {
        // If the computed y satisfies e^y = x(1 + δ), its error is ln(1 + δ) = δ(1 − δ/2 + …).
        let y = x.ln();
        let (power, x_fixed) = (exp(&fixed(y)), fixed(x));
        let error = (((power - &x_fixed) << BITS) / x_fixed).abs();
        assert!(error <= ((fixed(y).abs() * 33) >> 106_usize) + (one() >> 500), "{x:?}: {y:?}");
    }
    let beside_one = Dd::new(1.0, f64::EPSILON * f64::EPSILON);
    assert!((beside_one.ln() / (beside_one - Dd::from(1.0)) - Dd::from(1.0)).abs() < Dd::from(1e-30));
    assert_eq!(Dd::from(1.0).ln(), Dd::from(0.0));
    assert_eq!(Dd::from(0.0).ln().high(), f64::NEG_INFINITY);
    assert!(Dd::from(-1.0).ln().is_nan());
    assert_eq!(Dd::from(f64::INFINITY).ln().high(), f64::INFINITY);
}

#[test]
fn sines_and_cosines_are_within_their_bound() {
    const MANY: i64 = 1 << 50;
    let pi = pi();
    for x in arguments(40, core::f64::consts::FRAC_PI_2) {
        let exact = fixed(x);
        let turn: BigInt = &pi * 2;
        // Division rounds toward 0, which means down after many revolutions are added.
        let turns: BigInt = (&exact + &pi + &turn * MANY) / &turn - MANY;
        let rest: BigInt = exact - turns * turn;
        let square: BigInt = (&rest * &rest) >> BITS;
        let squared = -square;
        let least = 155 - x.high().abs().max(1e-9).log2().ceil() as i64;
        let (sin, cos) = x.sin_cos();
        assert_within(sin, &series(rest.clone(), 1, 2, &squared), 16, least as usize, x);
        assert_within(cos, &series(one(), 0, 2, &squared), 16, least as usize, x);
    }
    assert_eq!(Dd::from(0.0).sin_cos(), (Dd::from(0.0), Dd::from(1.0)));
    assert!(Dd::from(1e13).sin().is_nan() && Dd::from(f64::INFINITY).cos().is_nan());
}
