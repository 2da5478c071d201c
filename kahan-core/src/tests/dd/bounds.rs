//! Tests the error bounds of `Dd` on random operands over the whole exponent range.
//!
//! Results are compared exactly, as integers times powers of two. The ignored tests take more
//! samples: `cargo test --release -p kahan-core --features exact -- --ignored millions`.

use super::dyadic::Dyadic;
use super::operands::Operands;
use crate::{Dd, Scalar};

const SAMPLE: usize = 20_000;
const MILLIONS: usize = 4_000_000;

/// The bounds of sums, products and quotients as multiples of u², where u = 2⁻⁵³.
const SUM: i64 = 3;
const PRODUCT: i64 = 5;
const QUOTIENT: i64 = 14;

/// Returns count·u² with u = 2⁻⁵³, slightly enlarged for terms in u³.
fn square_units(count: i64) -> Dyadic {
    Dyadic::new(count, -106) + Dyadic::new(count, -150)
}

/// Returns the error 2⁻¹⁰⁷² that is added below the normal range.
fn least() -> Dyadic {
    Dyadic::new(1, -1072)
}

#[track_caller]
fn assert_normalised(x: Dd) {
    assert!(x.is_finite() && x.high() + x.low() == x.high(), "{:e} {:e}", x.high(), x.low());
}

#[track_caller]
fn assert_within(computed: &Dyadic, exact: &Dyadic, bound: &Dyadic, operands: &[Dd]) {
    let error = (computed.clone() - exact.clone()).abs();
    let parts: std::vec::Vec<_> = operands.iter().map(|x| (x.high(), x.low())).collect();
    assert!(error <= *bound, "{parts:?}");
}

/// Checks sums. The relative bound always holds, because sums of floats do not underflow.
fn check_sums(seed: u64, count: usize) {
    let mut operands = Operands::seeded(seed);
    for _ in 0..count {
        let exponent = operands.between(-1022 + 110, 1020);
        let x = operands.number(exponent);
        let reach = (1020 - exponent).min(exponent + 1022).min(120);
        let y = operands.partner(x, exponent, reach);
        let exact = Dyadic::of(x) + Dyadic::of(y);
        let bound = square_units(SUM) * exact.clone().abs();
        let sum = x + y;
        assert_normalised(sum);
        assert_within(&Dyadic::of(sum), &exact, &bound, &[x, y]);
        assert_eq!(sum, y + x);
        assert_eq!(-sum, -x - y);
    }
}

/// Each operation nearly reaches its bound at these operands. The operands of the sum are from the
/// paper by Joldeş, Muller and Popescu, and a search found the others.
#[test]
fn the_bounds_are_nearly_reached() {
    let of_bits = |high: u64, low: u64| Dd::new(f64::from_bits(high), f64::from_bits(low));
    let ulp = |n: u64| f64::from_bits((1023 - n) << 52);
    let last = 9_007_199_254_740_991.0;
    let x = Dd::new(last, -last * ulp(54));
    let y = Dd::new(-9_007_199_254_740_987.0 / 2.0, -last * ulp(56));
    let exact = Dyadic::of(x) + Dyadic::of(y);
    let errs_between = |error: Dyadic, least: i64, most: i64, exact: &Dyadic| {
        let units = |count: i64| square_units(count) * exact.clone().abs();
        units(least) <= error.clone().abs() && error.abs() <= units(most)
    };
    assert!(errs_between(Dyadic::of(x + y) - exact.clone(), 2, SUM, &exact));
    if cfg!(target_feature = "fma") {
        return;
    }
    let x = of_bits(0x3ff0_4023_f5b4_ef80, 0xbc9f_ffff_e327_31f9);
    let y = of_bits(0x3ff0_4003_740e_2218, 0xbc9f_f310_80ab_0967);
    let exact = Dyadic::of(x) * Dyadic::of(y);
    assert!(errs_between(Dyadic::of(x * y) - exact.clone(), 4, PRODUCT, &exact));
    let x = of_bits(0x3ff0_02ea_2816_a678, 0xbc9f_ffff_1aa6_d8a4);
    let y = of_bits(0x3ff0_0000_0840_002e, 0x3c9f_fdff_c000_05a8);
    let exact = Dyadic::of(x);
    assert!(errs_between(Dyadic::of(x / y) * Dyadic::of(y) - exact.clone(), 9, QUOTIENT, &exact));
}

fn exponents(operands: &mut Operands, most: i32) -> (i32, i32) {
    let first = operands.between(-1022, 1022);
    let sum = operands.between(-most, most);
    (first, (sum - first).clamp(-1022, 1022))
}

fn check_products(seed: u64, count: usize) {
    let mut operands = Operands::seeded(seed);
    for i in 0..count {
        let (first, second) = exponents(&mut operands, if i % 2 == 0 { 100 } else { 1021 });
        let (x, y) = (operands.number(first), operands.number(second));
        let exact = Dyadic::of(x) * Dyadic::of(y);
        let bound = square_units(PRODUCT) * exact.clone().abs();
        let product = x * y;
        if !product.is_finite() {
            // The largest products are below 2¹⁰²⁴, but may round to 2¹⁰²⁴.
            assert!(exact.abs() > Dyadic::new(1, 1023) && product.low() == 0.0 && !product.is_nan());
            continue;
        }
        assert_normalised(product);
        let is_normal = first + second > -968;
        let bound = if is_normal { bound } else { bound + least() };
        assert_within(&Dyadic::of(product), &exact, &bound, &[x, y]);
        assert_eq!(-product, -x * y);
    }
}

/// Checks |z − x/y| ≤ 14u²·|x/y| for z = x/y, in the form |zy − x| ≤ 14u²·|x|.
fn check_quotients(seed: u64, count: usize) {
    let mut operands = Operands::seeded(seed);
    for i in 0..count {
        let (first, second) = exponents(&mut operands, if i % 2 == 0 { 100 } else { 1021 });
        let x = operands.number(first);
        let y = operands.number(-second);
        let quotient = x / y;
        let (numerator, denominator) = (Dyadic::of(x), Dyadic::of(y));
        if !quotient.is_finite() {
            let least_infinite = Dyadic::new(1, 1023) * denominator.abs();
            assert!(numerator.abs() > least_infinite && quotient.low() == 0.0 && !quotient.is_nan());
            continue;
        }
        assert_normalised(quotient);
        let bound = square_units(QUOTIENT) * numerator.clone().abs();
        let is_normal = first + second > -967;
        let bound = if is_normal { bound } else { bound + least() * denominator.clone().abs() };
        assert_within(&(Dyadic::of(quotient) * denominator.clone()), &numerator, &bound, &[x, y]);

        if (-1022 + 110..=1021).contains(&second) {
            let reciprocal = Dyadic::of(y.recip()) * denominator;
            assert_within(&reciprocal, &Dyadic::new(1, 0), &square_units(QUOTIENT), &[y]);
        }
    }
}

/// Checks |z − √x| ≤ b√x for the root z and its bound b, in the form (1 − b)²x ≤ z² ≤ (1 + b)²x.
#[cfg(feature = "std")]
fn check_square_roots(seed: u64, count: usize) {
    let one = || Dyadic::new(1, 0);
    let square = |x: Dyadic| x.clone() * x;
    let mut operands = Operands::seeded(seed);
    for _ in 0..count {
        let exponent = operands.between(-1022, 1023);
        let x = operands.number(exponent).abs();
        if !x.is_finite() {
            continue;
        }
        let root = x.sqrt();
        assert_normalised(root);
        let (exact, computed) = (Dyadic::of(x), square(Dyadic::of(root)));
        let least = square(one() - square_units(4)) * exact.clone();
        let most = square(one() + square_units(4)) * exact;
        assert!(least <= computed && computed <= most, "{:e} {:e}", x.high(), x.low());
    }
}

/// Checks |computed − (xy + z)| ≤ 16u²·|xy| + 5u²·|xy + z|, also with cancellation.
fn check_multiply_adds(seed: u64, count: usize) {
    let mut operands = Operands::seeded(seed);
    for i in 0..count {
        let (first, second) = exponents(&mut operands, if i % 2 == 0 { 100 } else { 850 });
        let (x, y) = (operands.number(first), operands.number(second));
        let product = x * y;
        let z = operands.partner(product, first + second, 110);
        let exact_product = Dyadic::of(x) * Dyadic::of(y);
        let addend = Dyadic::of(z);
        let check = |computed: Dd, exact: Dyadic| {
            let bound =
                square_units(16) * exact_product.clone().abs() + square_units(5) * exact.clone().abs();
            assert_normalised(computed);
            assert_within(&Dyadic::of(computed), &exact, &bound, &[x, y, z]);
        };
        check(x.multiply_add(y, z), exact_product.clone() + addend.clone());
        check(x.multiply_subtract(y, z), exact_product.clone() - addend.clone());
        check(z.subtract_product(x, y), addend - exact_product.clone());
    }
}

/// Checks subnormal numbers, whose products and quotients have an additional error of 2⁻¹⁰⁷².
fn check_subnormals(seed: u64, count: usize) {
    let mut operands = Operands::seeded(seed);
    for _ in 0..count {
        let sign = if operands.below(2) == 0 { 1.0 } else { -1.0 };
        let x = Dd::from(sign * f64::from_bits(operands.bits() >> operands.between(12, 62)));
        let exponent = operands.between(-1022, -900);
        let y = operands.number(exponent);
        let exact = Dyadic::of(x) + Dyadic::of(y);
        let bound = square_units(SUM) * exact.clone().abs();
        assert_within(&Dyadic::of(x + y), &exact, &bound, &[x, y]);

        let exponent = operands.between(-60, 60);
        let factor = operands.number(exponent);
        let exact = Dyadic::of(x) * Dyadic::of(factor);
        let bound = square_units(PRODUCT) * exact.clone().abs() + least();
        assert_within(&Dyadic::of(x * factor), &exact, &bound, &[x, factor]);

        let divided = Dyadic::of(x / factor) * Dyadic::of(factor);
        let bound = square_units(QUOTIENT) * Dyadic::of(x).abs() + least() * Dyadic::of(factor).abs();
        assert_within(&divided, &Dyadic::of(x), &bound, &[x, factor]);
    }
}

macro_rules! laws {
    ($($(#[$condition:meta])* $law:ident, $millions:ident: $check:ident, $seed:literal;)*) => {$(
        $(#[$condition])*
        #[test]
        fn $law() {
            $check($seed, SAMPLE);
        }

        $(#[$condition])*
        #[test]
        #[ignore = "takes minutes unless optimised"]
        fn $millions() {
            $check(!$seed, MILLIONS);
        }
    )*};
}

laws! {
    sums_are_within_their_bound, millions_of_sums: check_sums, 1;
    products_are_within_their_bound, millions_of_products: check_products, 2;
    quotients_are_within_their_bound, millions_of_quotients: check_quotients, 3;
    #[cfg(feature = "std")]
    square_roots_are_within_their_bound, millions_of_square_roots: check_square_roots, 4;
    multiply_adds_are_within_their_bound, millions_of_multiply_adds: check_multiply_adds, 5;
    subnormals_are_within_their_bound, millions_of_subnormals: check_subnormals, 6;
}
