//! The error of each operation, and what has no value.

use num_traits::{One, Zero};

use super::super::LIMBS;
use super::{Dyadic, Random, Wide};
use crate::{Pivot, Scalar};

const TRIALS: usize = 20_000;

/// Asserts |computed − exact| ≤ 2⁻¹⁰²²·|exact|; for an exact 0, and where the result says that nothing was cut off, that is
/// equality.
fn assert_close(computed: Wide, exact: &Dyadic, what: &str, operands: [Wide; 2]) {
    let error = Dyadic::of(computed).minus(exact);
    assert!(error.is_within(&exact.scaled(Wide::UNIT_EXPONENT)), "{what} of {operands:?} is {computed:?}");
    let nothing = Dyadic::of(Wide::zero());
    assert!(
        !computed.is_exact() || error.is_within(&nothing),
        "{what} of {operands:?} is exact: {computed:?}"
    );
}

#[test]
fn a_sum_and_a_difference_are_within_the_unit() {
    let mut random = Random(1);
    for _ in 0..TRIALS {
        let [a, b] = random.pair();
        let (x, y) = (Dyadic::of(a), Dyadic::of(b));
        assert_close(a + b, &x.plus(&y), "the sum", [a, b]);
        assert_close(a - b, &x.minus(&y), "the difference", [a, b]);
    }
}

#[test]
fn a_product_is_within_the_unit() {
    let mut random = Random(2);
    for _ in 0..TRIALS {
        let [a, b] = random.pair();
        assert_close(a * b, &Dyadic::of(a).times(&Dyadic::of(b)), "the product", [a, b]);
    }
}

/// |q − a/b| ≤ 2⁻¹⁰²²·|a/b|, multiplied by |b|.
#[test]
fn a_quotient_is_within_the_unit() {
    let mut random = Random(3);
    for _ in 0..TRIALS {
        let [a, b] = random.pair();
        let (x, y) = (Dyadic::of(a), Dyadic::of(b));
        let residue = Dyadic::of(a / b).times(&y).minus(&x);
        assert!(residue.is_within(&x.scaled(Wide::UNIT_EXPONENT)), "the quotient of {a:?} and {b:?}");
    }
}

/// Every quotient of a product that is exact, also where the digits of the long division are all ones and estimates are
/// too large.
#[test]
fn dividing_an_exact_product_gives_the_factor_back() {
    let mut random = Random(4);
    for _ in 0..TRIALS {
        let [mut a, mut b] = random.pair();
        // Two mantissas of 512 bits have a product of 1024.
        a.mantissa[..LIMBS / 2].fill(0);
        b.mantissa[..LIMBS / 2].fill(0);
        assert!((a * b).is_exact() && (a * b - a * b).is_exact());
        assert_eq!(a * b / b, a);
        assert_eq!(a * b / a, b);
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
        assert_eq!(a.magnitude_exceeds(&b), !x.is_within(&y));
        assert_eq!(a == b, x.equals(&y));
        assert_eq!(a.is_better_pivot(&b), a.magnitude_exceeds(&b));
        assert!(a.magnitude_exceeds(&Wide::zero()) && !Wide::zero().magnitude_exceeds(&a));
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
                assert!(!result.is_defined() && !result.is_finite_number() && !result.is_zero());
                assert!(result != result && result.to_f64().is_nan() && result.to_f32().is_nan());
            }
            assert!(!bad.magnitude_exceeds(&other) && !other.magnitude_exceeds(&bad));
        }
        assert!(bad.scaled(3) != bad);
    }
    assert!(zero.reciprocal().is_none() && one.quotient(zero).is_none() && zero.quotient(zero).is_none());
    assert_eq!(one.quotient(one + one), Some(Wide::from(0.5)));
}

#[test]
fn an_exponent_that_leaves_its_range_is_undefined() {
    let (large, small) = (Wide::one().scaled(i64::MAX), Wide::one().scaled(i64::MIN));
    assert!(large.is_defined() && small.is_defined());
    for result in [large * large, large + large, small * small, large / small, small / large, large.scaled(1)]
    {
        assert!(!result.is_defined());
    }
    assert_eq!(large + small, large);
    assert_eq!((large.to_f64(), small.to_f64()), (f64::INFINITY, 0.0));
    // 1·2^MIN less half of the last bit of 2^(MIN+1) would need an exponent below the range.
    assert!(!(small.scaled(1) - small.scaled(1) * Wide::from(1.0 - 1e-16)).is_defined());
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
