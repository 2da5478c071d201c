//! Tests errors of the operations, and undefined results.

use num_traits::{One, Zero};

use super::super::Size;
use super::{Dyadic, Random, Wide};
use crate::Scalar;

const TRIALS: usize = 2_000;

/// Asserts error ≤ radius ≤ 2^`UNIT_EXPONENT`·|exact|, for an operation on exact operands.
fn assert_close(computed: Wide, exact: &Dyadic, what: &str, operands: [Wide; 2]) {
    let (error, radius) = (Dyadic::of(computed).minus(exact), Dyadic::size(computed.radius()));
    assert!(error.is_within(&radius.scaled_up()), "{what} of {operands:?} is {computed:?}");
    assert!(radius.is_within(&exact.scaled(Wide::UNIT_EXPONENT)), "{what} of {operands:?} is {computed:?}");
}

fn exact_pair(random: &mut Random) -> [Wide; 2] {
    let pair = random.pair();
    if pair.iter().all(|number| number.radius().is_zero()) { pair } else { exact_pair(random) }
}

#[test]
fn a_sum_and_a_difference_are_within_the_unit() {
    let mut random = Random(1);
    for _ in 0..TRIALS {
        let [a, b] = exact_pair(&mut random);
        let (x, y) = (Dyadic::of(a), Dyadic::of(b));
        assert_close(a + b, &x.plus(&y), "the sum", [a, b]);
        assert_close(a - b, &x.minus(&y), "the difference", [a, b]);
    }
}

#[test]
fn a_product_is_within_the_unit() {
    let mut random = Random(2);
    for _ in 0..TRIALS {
        let [a, b] = exact_pair(&mut random);
        assert_close(a * b, &Dyadic::of(a).times(&Dyadic::of(b)), "the product", [a, b]);
    }
}

#[test]
fn both_ways_to_multiply_agree() {
    let mut random = Random(10);
    let mut made_in_place = 0;
    for _ in 0..TRIALS {
        let [a, b] = random.pair().map(|number| number.row());
        if let Some(product) = a.times_in_place(&b) {
            assert_eq!(product.digits(), a.times_far_apart(&b).digits());
            made_in_place += 1;
        }
    }
    assert!((TRIALS / 4..TRIALS).contains(&made_in_place), "{made_in_place}");
}

/// Tests |q − a/b| ≤ 2⁻¹⁰²²·|a/b| for a quotient q, after multiplication by all denominators.
#[test]
fn a_quotient_is_within_the_unit() {
    let mut random = Random(3);
    for _ in 0..TRIALS {
        let [a, b] = exact_pair(&mut random);
        let q = a / b;
        let raised = |x: &Dyadic| x.times(&Dyadic { integer: q.denominator.into(), exponent: 0 });
        let (x, y) = (raised(&Dyadic::of(a)), Dyadic::of(b));
        let error = Dyadic::numerator(&q).times(&y).minus(&x);
        let radius = raised(&Dyadic::size(q.radius())).times(&y);
        assert!(error.is_within(&radius.scaled_up()), "the quotient of {a:?} and {b:?}");
        assert!(radius.is_within(&x.scaled(Wide::UNIT_EXPONENT)), "the quotient of {a:?} and {b:?}");
    }
}

/// Sums of up to 17 digits at any places are exact.
#[test]
fn digits_lie_where_they_are_needed() {
    let mut random = Random(4);
    for _ in 0..1000 {
        let part = |k: i64, digit: u64| Wide::from((digit >> 2) as i64 | 1).scaled(64 * (7 * k - 50));
        let parts: [Wide; Wide::MOST_DIGITS] = core::array::from_fn(|k| part(k as i64, random.bits()));
        let sum = parts.iter().fold(Wide::zero(), |sum, part| sum + *part);
        assert!(sum.radius().is_zero());
        let rest = parts[1..].iter().fold(sum, |rest, part| rest - *part);
        assert!(rest.radius().is_zero() && rest == parts[0]);
        let longer = sum + part(20, random.bits());
        let cut = longer.radius();
        // The lowest digit is cut off. The radius bounds this digit, and is not much larger.
        assert!(Dyadic::of(parts[0]).is_within(&Dyadic::size(cut)));
        assert!(Dyadic::size(cut).is_within(&Dyadic::of(parts[0] + Wide::one().scaled(-64 * 50 + 14))));
    }
    let (one, huge) = (Wide::one(), Wide::one().scaled(100_000));
    let square = (huge + one) * (huge + one) - huge * huge;
    assert!(square == huge + huge + one && square.radius().is_zero());
    // Digits more than 2¹⁶ places below the leading digit are dropped.
    let huge = one.scaled(64 << 16);
    assert!(!(huge + one).radius().is_zero() && (huge.scaled(-64) + one).radius().is_zero());
}

#[test]
fn short_fractions_are_exact() {
    let whole = |n: i64| Wide::from(n);
    let mut random = Random(8);
    for _ in 0..1000 {
        let mut small = || (random.bits() % 200) as i64 + 1;
        let (a, b, c, d) = (small(), small(), small(), small());
        let (p, q) = (whole(a) / whole(b), whole(-c) / whole(d));
        for exact in [p, q, p + q, p * q, p / q, p - q] {
            assert!(exact.radius().is_zero());
        }
        assert_eq!((p + q) * whole(b * d), whole(a * d - b * c));
        assert_eq!(p * q * whole(b * d), whole(-a * c));
        assert_eq!(p / q * whole(b * c), whole(-a * d));
        assert_eq!(p.is_better_pivot(&q), a * d > b * c);
    }
    // If a common denominator exceeds 64 bits, the quotient's radius covers a rounding.
    let large = whole((1 << 61) - 1);
    let (p, q) = (whole(1) / large, whole(1) / whole((1 << 60) + 33));
    for (number, exact) in [(p + q, whole((1 << 61) - 1) + whole((1 << 60) + 33)), (p * q, whole(1))] {
        let raised = number * large * whole((1 << 60) + 33);
        let error = Dyadic::of(raised).minus(&Dyadic::of(exact));
        assert!(!number.radius().is_zero() && error.is_within(&Dyadic::size(raised.radius())));
        assert!(Dyadic::size(raised.radius()).is_within(&Dyadic::of(exact).scaled(Wide::UNIT_EXPONENT + 2)));
    }
}

/// The error of a result is within its radius even if each operand is wrong by its whole radius.
#[test]
fn a_radius_holds_whatever_the_operands_stand_for() {
    let mut random = Random(9);
    for _ in 0..TRIALS / 4 {
        let [a, b] = exact_pair(&mut random);
        let [near_a, near_b] = [a, b].map(|number| {
            let radius = number.size().scaled(-8 - random.within(400).abs());
            Wide { radius, ..number }
        });
        let ends = |near: Wide| {
            let radius = Dyadic::size(near.radius());
            [Dyadic::of(near).plus(&radius), Dyadic::of(near).minus(&radius)]
        };
        for (x, y) in ends(near_a).iter().flat_map(|x| ends(near_b).map(|y| (x.clone(), y))) {
            let holds = |result: Wide, exact: &Dyadic| {
                Dyadic::of(result).minus(exact).is_within(&Dyadic::size(result.radius()).scaled_up())
            };
            assert!(holds(near_a + near_b, &x.plus(&y)) && holds(near_a - near_b, &x.minus(&y)));
            assert!(holds(near_a * near_b, &x.times(&y)), "{near_a:?} {near_b:?}");
            let q = near_a / near_b;
            let raise = |x: &Dyadic| x.times(&Dyadic { integer: q.denominator.into(), exponent: 0 });
            let error = Dyadic::numerator(&q).times(&y).minus(&raise(&x));
            let radius = raise(&Dyadic::size(q.radius())).times(&y);
            assert!(error.is_within(&radius.scaled_up()), "{near_a:?} {near_b:?}");
        }
    }
    let doubtful = Wide { radius: Size::from(0.1), ..Wide::one() };
    assert!((Wide::one() / doubtful).radius() > Size::from(1e300));
}

#[test]
fn dividing_an_exact_product_gives_the_factor_back() {
    let mut random = Random(10);
    let mut seen = 0;
    while seen < 1000 {
        let [a, b] = random.pair().map(|number| Wide {
            count: number.count.min(Wide::MOST_DIGITS as u16 / 2 - 1),
            radius: Size::zero(),
            ..number
        });
        let product = a * b;
        if !product.radius().is_zero() {
            continue;
        }
        seen += 1;
        assert_eq!(product / b, a);
        assert_eq!(product / a, b);
    }
}

#[test]
fn opposite_numbers_cancel_to_zero() {
    let mut random = Random(5);
    for _ in 0..1000 {
        let [a, _] = random.pair();
        assert!((a - a).is_zero() && (a + -a).is_zero());
        assert_eq!(a - a, Wide::zero());
        assert_eq!(-(a - a), Wide::zero());
        assert_eq!(a + Wide::zero(), a);
        assert_eq!(Wide::zero() - a, -a);
        assert_eq!(a * Wide::one(), a);
        assert!((a * Wide::zero()).is_zero() && (Wide::zero() / a).is_zero());
    }
}

#[test]
fn magnitudes_are_ordered_as_the_numbers_are() {
    let mut random = Random(6);
    for _ in 0..10_000 {
        let [a, b] = random.pair();
        let (x, y) = (Dyadic::of(a), Dyadic::of(b));
        assert_eq!(a.is_better_pivot(&b), !x.is_within(&y));
        assert_eq!(a == b, x.equals(&y));
        assert!(a.is_better_pivot(&Wide::zero()) && !Wide::zero().is_better_pivot(&a));
    }
}

#[test]
fn undefined_is_passed_on_by_every_operation() {
    let (one, zero) = (Wide::one(), Wide::zero());
    let undefined = [one / zero, zero / zero, Wide::from(f64::NAN), Wide::from(f64::INFINITY)];
    for bad in undefined {
        for other in [one, zero, bad] {
            for result in [bad + other, other - bad, bad * other, other * bad, bad / other, other / bad, -bad]
            {
                assert!(!result.is_defined() && !result.is_zero());
                assert!(result != result && result.to_f64().is_nan() && result.to_f32().is_nan());
            }
            assert!(!bad.is_better_pivot(&other) && !other.is_better_pivot(&bad));
        }
        assert!(bad.scaled(3) != bad);
    }
    assert!(zero.reciprocal().is_none() && one.quotient(zero).is_none() && zero.quotient(zero).is_none());
    assert_eq!(one.quotient(one + one), Some(Wide::from(0.5)));
}

#[test]
fn an_exponent_that_leaves_its_range_is_undefined() {
    let far = 1 << 40;
    let (large, small) =
        (Wide::one().scaled(far).scaled(63 * far), Wide::one().scaled(-far).scaled(-63 * far));
    assert!(large.is_defined() && small.is_defined());
    let (above, below) = (large.scaled(64), small.scaled(-64));
    for result in [large * large, small * small, large / small, small / large, above, below] {
        assert!(!result.is_defined());
    }
    assert_eq!(large + small - large, Wide::zero());
    assert_eq!((large.to_f64(), small.to_f64()), (f64::INFINITY, 0.0));
}

#[test]
fn operators_in_place_are_the_operators() {
    let mut random = Random(7);
    for _ in 0..1000 {
        let [a, b] = random.pair();
        let mut results = [a; 4];
        results[0] += b;
        results[1] -= b;
        results[2] *= b;
        results[3] /= b;
        assert_eq!(results, [a + b, a - b, a * b, a / b]);
    }
}
