//! Tests infinities, zeros, NaN, the largest numbers, the order, and conversions.

use core::cmp::Ordering;

use num_traits::{One, Zero};

use crate::{Constant, Dd, Pivot, Scalar};

const SPECIAL: [f64; 13] = [
    0.0,
    -0.0,
    1.0,
    -1.5,
    3.0,
    5e-324,
    -2.2250738585072014e-308,
    1e300,
    f64::MAX,
    f64::MIN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

fn is_same(a: f64, b: f64) -> bool {
    a == b || a.is_nan() && b.is_nan()
}

#[test]
fn what_is_not_finite_is_what_floats_say() {
    for a in SPECIAL {
        for b in SPECIAL {
            let (x, y) = (Dd::from(a), Dd::from(b));
            let pairs =
                [(x + y, a + b), (x - y, a - b), (x * y, a * b), (x / y, a / b), (x.recip(), 1.0 / a)];
            for (result, float) in pairs {
                // The result is the nearest float. Subnormal results may be rounded twice.
                let is_near = is_same(result.high(), float)
                    || float.is_subnormal() && (result.high() - float).abs() <= f64::from_bits(1);
                assert!(is_near, "{a:e} {b:e}: {:e}, not {float:e}", result.high());
                assert!(result.is_finite() || result.low() == 0.0, "{a:e} {b:e}");
                assert_eq!(result.is_nan(), float.is_nan());
            }
            assert!(is_same(x.multiply_add(y, Dd::one()).high(), (x * y + Dd::one()).high()), "{a:e} {b:e}");
            assert_eq!(x.partial_cmp(&y), a.partial_cmp(&b));
        }
        // The root of the largest float is near a tie; therefore `high` may differ by one unit.
        #[cfg(feature = "std")]
        assert!({
            let (root, float) = (Dd::from(a).sqrt().high(), a.sqrt());
            is_same(root, float) || (root - float).abs() <= f64::EPSILON * float
        });
    }
}

#[test]
fn a_sum_near_the_largest_number_has_its_low_part() {
    let half_place = 9.9792015476736e291; // 2⁹⁷⁰
    let quarter = half_place / 2.0;
    let largest = Dd::new(f64::MAX, quarter);
    assert_eq!((largest.high(), largest.low()), (f64::MAX, quarter));
    assert_eq!(largest - Dd::from(f64::MAX), Dd::from(quarter));
    assert_eq!(largest + Dd::from(half_place), Dd::from(f64::INFINITY));
    let below = Dd::new(f64::MAX, -3.0 * half_place);
    assert_eq!(Dd::from(f64::MAX) - Dd::from(3.0 * half_place), below);
    assert_eq!(below + Dd::from(3.0 * half_place), Dd::from(f64::MAX));
    let big = Dd::from(1e200);
    assert_eq!(big.multiply_add(big, Dd::one()), Dd::from(f64::INFINITY));
    let two = Dd::from(2.0);
    assert_eq!(Dd::from(f64::MAX).multiply_add(two, -Dd::from(f64::MAX)).high(), f64::INFINITY);
}

#[test]
fn a_quotient_and_a_root_do_not_overflow_on_the_way() {
    let third = Dd::one() / Dd::from(3.0);
    for exponent in [-1022, -700, 700, 1021] {
        let x = Dd::from(2_f64.powi(exponent));
        assert_eq!(x / (x + x + x), third);
    }
    #[cfg(feature = "std")]
    assert_eq!(Dd::from(2_f64.powi(1022)).sqrt(), Dd::from(2_f64.powi(511)));
}

#[test]
fn new_normalises_in_any_order() {
    let tiny = f64::EPSILON / 8.0;
    for x in [Dd::new(1.0, tiny), Dd::new(tiny, 1.0)] {
        assert_eq!((x.high(), x.low()), (1.0, tiny));
    }
    // Both sums are the same tie between two floats. The even float becomes the high part.
    assert_eq!(Dd::new(1.0, f64::EPSILON / 2.0), Dd::new(1.0 + f64::EPSILON, -f64::EPSILON / 2.0));
    let infinite = Dd::new(f64::MAX, f64::MAX);
    assert_eq!((infinite.high(), infinite.low()), (f64::INFINITY, 0.0));
    const PI: Dd = Dd::new(core::f64::consts::PI, 1.2246467991473532e-16);
    assert_eq!(PI.high(), core::f64::consts::PI);
}

#[test]
fn order_and_magnitude_look_at_the_low_part() {
    let (less, one, more) = (Dd::new(1.0, -1e-20), Dd::one(), Dd::new(1.0, 1e-20));
    assert!(less < one && one < more && -more < -one);
    assert_eq!(one.partial_cmp(&one), Some(Ordering::Equal));
    assert!((-more).magnitude_exceeds(&one) && !less.magnitude_exceeds(&-one));
    assert!(Dd::new(-2.0, 1e-20).abs() < Dd::from(2.0));
    assert_eq!(Dd::from(-0.0).abs().high().to_bits(), 0);
    let no_number = Dd::from(f64::NAN);
    assert!(!no_number.is_better_pivot(&one) && !one.is_better_pivot(&no_number));
    assert!(no_number != no_number && !no_number.is_finite_number() && one.is_finite_number());
}

#[test]
fn conversions_are_exact_or_nearest() {
    assert_eq!(Dd::from(0.1_f32).high(), f64::from(0.1_f32));
    assert_eq!(Dd::from(i32::MIN).high(), -2_147_483_648.0);
    assert_eq!(f64::from(Dd::new(0.5, 1e-20)), 0.5);
    assert!(Dd::zero().is_zero() && Dd::from(-0.0).is_zero() && !Dd::one().is_zero());
    assert_eq!(Dd::default(), Dd::zero());
    assert_eq!(Dd::new(3.0, 1e-20).approximate(), 3.0);
}

#[test]
fn constants_are_correct_in_both_parts() {
    let third = Dd::constant(&Constant::ratio(1, 3));
    assert_eq!(third, Dd::one() / Dd::from(3.0));
    let n = Dd::constant(&Constant::integer(i64::MAX));
    assert_eq!((n.high(), n.low()), (9_223_372_036_854_775_808.0, -1.0));
    let n = Dd::constant(&Constant::integer(i64::MIN + 1));
    assert_eq!((n.high(), n.low()), (-9_223_372_036_854_775_808.0, 1.0));
}
