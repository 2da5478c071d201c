//! Tests that error bounds cover underflow. The largest permitted inputs amplify the underflow
//! error η most.

use num_traits::{Signed, ToPrimitive};

use super::worst::{Beside, Q, Worst, off_by};
use crate::scalar::bounded::underflow;
use crate::scalar::bounded::{Number, power_of_two};

const FINE: i32 = 40;
/// The argument of `off_by` for an underflow: a relative error of 0·u, an absolute error of 1·η.
const TINY: (i64, i64) = (0, 1);

type Value = Beside<FINE>;

/// Checks that the error is positive and within the bound.
fn assert_allowed(value: &Value) {
    let error = value.error();
    assert!(error.is_positive() && value.part() <= 1.0, "{} of the bound: {value:?}", value.part());
}

fn largest_input(formula: impl Fn(&Value) -> Value) -> f64 {
    formula(&Value::from_input(1.0)).bounded.largest_input().size()
}

#[test]
fn an_operation_that_underflows_is_allowed_for() {
    let (zero, one) = (Value::from_input(0.0), Value::from_input(1.0));
    for value in off_by(TINY, || [zero.times(&one), zero.plus(&zero), zero.over(&one).expect("a quotient")]) {
        assert_allowed(&value);
    }
}

#[test]
fn products_carry_an_underflow_as_far_as_their_inputs_let_them() {
    for count in 2..8 {
        let formula = |x: &Value| {
            let tiny = Value::from_input(0.0).times(&Value::from_input(0.0));
            off_by((0, 0), || (0..count).fold(tiny.clone(), |product, _| product.times(x)))
        };
        let largest = largest_input(formula);
        let value = off_by(TINY, || formula(&Value::from_input(largest)));
        assert_allowed(&value);
    }
}

#[test]
fn sums_and_constants_take_their_bits() {
    let formula = |x: &Value| {
        let tiny = Value::from_input(0.0).times(&Value::from_input(0.0));
        off_by((0, 0), || (0..18).fold(tiny.times(x), |sum, _| sum.plus(&sum)))
    };
    let largest = largest_input(formula);
    assert!(largest <= 4.0);
    assert_allowed(&off_by(TINY, || formula(&Value::from_input(largest))));

    let formula = |x: &Value| {
        let tiny = Value::from_input(0.0).times(&Value::from_input(0.0));
        let large = Value::literal(1 << 7, 1);
        off_by((0, 0), || tiny.times(x).times(&large).times(&large))
    };
    let largest = largest_input(formula);
    assert!(largest <= power_of_two(20 - 14));
    assert_allowed(&off_by(TINY, || formula(&Value::from_input(largest))));
}

/// The least permitted divisor is 2^−k. A division multiplies an underflow error of the numerator
/// by 2^k, and an error of the divisor by 2^2k.
#[test]
fn quotients_take_the_bits_of_divisors_twice() {
    let least = power_of_two(-(Worst::<FINE>::RANGE.bits_of_divisors as i32)) * 1.01;
    let formula = |x: &Value| {
        let divisor = |least: f64| Value::from_input(least).plus(&Value::from_input(0.0));
        let first = Value::from_input(0.0).times(&Value::from_input(0.0)).times(x);
        first.over(&divisor(least)).and_then(|v| v.over(&divisor(least))).expect("a quotient")
    };
    let largest = largest_input(formula);
    assert!(largest <= power_of_two((20 - 16) / 2), "{largest}");
    assert_allowed(&off_by(TINY, || formula(&Value::from_input(largest))));
    let formula = |x: &Value| {
        let divisor = Value::from_input(least).plus(&Value::from_input(0.0));
        Value::from_input(1.0).times(x).over(&divisor).expect("a quotient")
    };
    let largest = largest_input(formula);
    assert_allowed(&off_by(TINY, || formula(&Value::from_input(largest))));
    assert!(Value::from_input(1.0).over(&Value::from_input(least / 1.02)).is_none());
}

#[test]
fn steps_divided_by_eps_take_the_bits_of_steps() {
    let least = Value::from_input(power_of_two(-(Worst::<FINE>::RANGE.bits_of_steps as i32)));
    let formula = |x: &Value| {
        let tiny = Value::from_input(0.0).times(&Value::from_input(0.0)).times(x);
        off_by((0, 0), || {
            let large = Value::literal(1, 1).over_input(&least);
            tiny.times(&large).times(&large).times(&large)
        })
    };
    let largest = largest_input(formula);
    assert!(largest <= power_of_two(20 - 18));
    assert_allowed(&off_by(TINY, || formula(&Value::from_input(largest))));
}

/// Premises of the error bound on constants and operations. Each test shows that the true error
/// exceeds the bound just beyond a premise.
mod premises {
    use super::super::worst::{Beside, Worst, off_by, with_low_magnitudes};
    use super::TINY;
    use crate::scalar::bounded::{Bounded, InputLimit, Number, power_of_two};
    use crate::{Constant, Scalar};

    const MOST_UNDERFLOWS: u32 = 1024;

    const FINEST: i32 = 120;
    type Value = Beside<FINEST>;

    fn doubled(value: &Value, times: u32) -> Value {
        off_by((0, 0), || (0..times).fold(value.clone(), |sum, _| sum.plus(&sum)))
    }

    #[test]
    fn inputs_are_below_the_smaller_one_of_two_limits() {
        let (low, high) = (InputLimit::below(3), InputLimit::below(9));
        for (a, b) in [(low, high), (high, low), (low, InputLimit::ANY), (InputLimit::ANY, low)] {
            assert_eq!(a.and(b), low);
        }
        assert!(low.allows(7.99) && !low.allows(8.0) && !low.allows(f64::NAN));
        assert!(InputLimit::ANY.allows(f64::MAX) && !InputLimit::ANY.allows(f64::NAN));
        assert_eq!(
            (low.and(InputLimit::NONE), InputLimit::NONE.and(low)),
            (InputLimit::NONE, InputLimit::NONE)
        );
        assert!(!InputLimit::NONE.allows(0.0));
    }

    #[test]
    fn no_product_is_larger_than_all_products_may_be() {
        let bits = Worst::<FINEST>::RANGE.bits_of_products;
        let large = |doublings: u32| doubled(&Value::literal(2, 1), doublings);
        assert_eq!(large(bits - 2).bounded.largest_input(), InputLimit::below(0));
        assert_eq!(large(bits - 1).bounded.largest_input(), InputLimit::NONE);
        assert_eq!(large(bits + 40).bounded.largest_input(), InputLimit::NONE);
        let lost = |doublings: u32| {
            let large = large(doublings);
            let tiny = off_by(TINY, || Value::from_input(0.0).times(&Value::from_input(0.0)));
            off_by(TINY, || tiny.times(&large))
        };
        let (within, beyond) = (lost(bits - 2), lost(bits + 12));
        assert!(within.bounded.largest_input() != InputLimit::NONE && within.part() <= 1.0);
        assert!(beyond.bounded.largest_input() == InputLimit::NONE && beyond.part() > 1.0);
    }

    #[test]
    fn no_more_operations_underflow_than_the_allowance_is_made_for() {
        // Factors ½ keep the products small. Only the number of operations exceeds its limit.
        let half = |roundings| Bounded::<Worst<FINEST>>::literal(Worst::of_float(0.5), roundings);
        let product = |count: u32, roundings: u32| {
            (0..count).fold(half(0), |product, _| product * half(roundings)).largest_input()
        };
        assert_eq!(product(MOST_UNDERFLOWS, 0), InputLimit::below(20));
        assert_eq!(product(MOST_UNDERFLOWS + 1, 0), InputLimit::NONE);
        assert_eq!(product(MOST_UNDERFLOWS / 2, 1), InputLimit::below(20));
        assert_eq!(product(MOST_UNDERFLOWS / 2 + 1, 1), InputLimit::NONE);
        let halves = |count: u32| (0..count).fold(half(0), |product, _| product * half(0));
        let sum = (0..5).fold(half(0), |sum, _| sum + halves(MOST_UNDERFLOWS));
        assert_eq!(sum.largest_input(), InputLimit::below(20 - 5));
        let quotient = |count: u32| {
            let divisor = halves(count) + half(0);
            halves(count).quotient(divisor).expect("a divisor of a half").largest_input()
        };
        assert_eq!(quotient(MOST_UNDERFLOWS / 2 - 1), InputLimit::below(20 - 9));
        assert_eq!(quotient(MOST_UNDERFLOWS / 2), InputLimit::NONE);
    }

    #[test]
    fn no_more_roundings_are_counted_than_the_slack_pays_for() {
        const COARSE: i32 = 10;
        let one = Beside::<COARSE>::from_input(1.0);
        let rounded = |k: u32| off_by((1, 0), || (0..k).fold(one.clone(), |product, _| product.times(&one)));
        with_low_magnitudes(|| {
            let (within, beyond) = (rounded(40), rounded(41));
            assert!(within.part() <= 1.0 && within.bounded.roundings() == 40, "{}", within.part());
            assert_ne!(within.bounded.largest_input(), InputLimit::NONE);
            assert_eq!(beyond.bounded.largest_input(), InputLimit::NONE);
            assert!(rounded(45).part() > 1.0);
        });
    }

    #[test]
    fn a_quotient_has_the_inputs_of_its_divisor() {
        let input = || Bounded::<Worst<FINEST>>::from_input(Worst::of_float(1.0));
        let quotient = |divisor: Bounded<Worst<FINEST>>| input().quotient(divisor).expect("a divisor of 1");
        assert_eq!(quotient(input()).largest_input(), InputLimit::below((20 - 8) / 2));
        assert_eq!(quotient(input() * input() * input()).largest_input(), InputLimit::below((20 - 8) / 4));
        let size = power_of_two(10);
        let formula = |x: f64| {
            let lost = off_by(TINY, || Beside::<FINEST>::from_input(0.0).times(&Beside::from_input(0.0)));
            let lost = off_by((0, 0), || lost.times(&Beside::from_input(x)).times(&Beside::from_input(x)));
            let divisor = off_by((0, 0), || Beside::<FINEST>::from_input(0.125).plus(&lost));
            off_by((0, 0), || Beside::<FINEST>::from_input(x).over(&divisor)).expect("a divisor of an eighth")
        };
        assert!(!formula(1.0).bounded.largest_input().allows(size));
        assert!(formula(size).part() > 1.0);
    }

    /// Unknown values stay unknown, because ∞·0 is NaN and comparisons with NaN are false.
    #[test]
    fn nothing_is_allowed_of_an_unknown_value() {
        let unknown = || Bounded::<f64>::from_input(1.0) / Bounded::from_input(0.0);
        let zero = || Bounded::<f64>::from_input(0.0);
        for value in
            [unknown(), unknown() * zero(), zero() * unknown() + Bounded::from_input(1.0), -unknown()]
        {
            assert_eq!(value.largest_input(), InputLimit::NONE);
        }
    }

    /// An infinite literal exceeds all limits. A literal that underflows has an error within the
    /// bound.
    #[test]
    fn literals_at_the_ends_of_a_range_are_bounded() {
        let of = |single: f32, double: f64, limbs: (&[u64], &[u64])| {
            let constant = Constant::exact(false, limbs.0, limbs.1, single, double, 0.0);
            (Bounded::<f32>::constant(&constant), Bounded::<f64>::constant(&constant))
        };
        let (single, double) = of(f32::INFINITY, 200_f64.exp2(), (&[0, 0, 0, 256], &[1]));
        assert_eq!(
            (single.largest_input(), double.largest_input()),
            (InputLimit::NONE, InputLimit::below(914 - 201))
        );
        let (single, double) = of(0.0, (-200_f64).exp2(), (&[1], &[0, 0, 0, 256]));
        assert!(f64::from(single.error()) >= (-200_f64).exp2() && double.roundings() == 1);
        assert_ne!(single.largest_input(), InputLimit::NONE);
    }

    #[test]
    fn an_eps_beyond_its_bits_is_a_divisor_as_any() {
        let bits = Worst::<FINEST>::RANGE.bits_of_steps as i32;
        let over = |eps: f64| Value::literal(1, 1).bounded / Bounded::from_input(Worst::of_float(eps));
        for sign in [1.0, -1.0] {
            for power in [bits, -bits] {
                assert_eq!(over(sign * power_of_two(power)).largest_input(), InputLimit::below(20 - 1 - 6));
            }
            assert_eq!(over(sign * power_of_two(bits + 1)).largest_input(), InputLimit::below(20 - 1 - 8));
            assert_eq!(over(sign * power_of_two(-bits - 1)).largest_input(), InputLimit::NONE);
        }
    }

    /// The allowance is 2¹⁰·2ᴮ·η for products of at most 2ᴮ and underflow errors of at most η.
    #[test]
    fn allowances_are_those_of_their_formats() {
        fn eta<V: Number>() -> f64 {
            V::RANGE.allowance / (f64::from(MOST_UNDERFLOWS) * power_of_two(V::RANGE.bits_of_products as i32))
        }
        assert_eq!(eta::<f32>(), f64::from(f32::from_bits(1)));
        assert_eq!(eta::<f64>(), f64::from_bits(1));
        assert_eq!(eta::<crate::Dd>(), f64::from_bits(16));
    }
}

/// The numerator underflows to 0, and only the allowance for underflow bounds its error.
#[test]
fn a_weight_allows_for_underflow_in_numerator_and_reciprocal() {
    let as_float = |error: Q| error.to_f64().expect("a number");
    let (numerator, reciprocal, product) = off_by(TINY, || {
        let numerator = Value::from_input(0.0).times(&Value::from_input(1.0));
        let reciprocal = Value::from_input(1.0).over(&Value::from_input(0.125)).expect("a quotient");
        (numerator.clone(), reciprocal.clone(), numerator.times(&reciprocal))
    });
    let roundings = numerator.bounded.roundings();
    let magnitude = f64::from(numerator.bounded.magnitude());
    let weight = f64::from(reciprocal.bounded.weight(roundings));
    let bound = (magnitude + underflow::<Worst<FINE>>(roundings)) * weight * Worst::<FINE>::UNIT;
    assert!(as_float(product.error()) <= bound);
    let (reciprocal, product) = off_by(TINY, || {
        let reciprocal = Value::from_input(0.0).over(&Value::from_input(1.0)).expect("a quotient");
        (reciprocal.clone(), Value::from_input(1.0).times(&reciprocal))
    });
    assert!(as_float(product.error()) <= f64::from(reciprocal.bounded.weight(0)) * Worst::<FINE>::UNIT);
}

/// Most of the divisor's error comes from an underflow.
#[test]
fn a_weight_of_a_chain_allows_for_underflow() {
    const FINEST: i32 = 60;
    type Finest = Beside<FINEST>;
    let reciprocal = off_by(TINY, || {
        let lost = Finest::from_input(0.0)
            .times(&Finest::from_input(0.0))
            .times(&Finest::from_input(power_of_two(18)));
        Finest::literal(1, 1).over(&Finest::from_input(0.25).plus(&lost)).expect("a quotient")
    });
    let product = Finest::from_input(1.0).times(&reciprocal);
    let error = product.error().to_f64().expect("a number");
    let bound = f64::from(reciprocal.bounded.weight(0)) * Worst::<FINEST>::UNIT;
    assert!(error <= bound && error > 16.0 * Worst::<FINEST>::UNIT);
}

/// Tests the limits on inputs by computations with hardware floats.
macro_rules! floats_at_the_end_of_their_range {
    ($($name:ident: $float:ty, $least:expr;)*) => {$(
        #[test]
        fn $name() {
            use crate::scalar::bounded::Bounded;
            for count in 1..9 {
                let formula = |a: $float, b: $float, x: $float| {
                    let tiny = Bounded::<$float>::from_input(a) * Bounded::from_input(b);
                    (0..count).fold(tiny, |product, _| product * Bounded::from_input(x))
                };
                let x = formula(1.0, 1.0, 1.0).largest_input().size() as $float;
                let (a, b) = ($least, 0.5);
                let value = formula(a, b, x);
                let exact = (0..count).fold(f64::from(a) * 2.0_f64.powi(100) * 0.5, |product, _| product * f64::from(x));
                assert_eq!(value.value(), 0.0);
                assert!(f64::from(value.error()) * 2.0_f64.powi(100) >= exact, "{count} inputs of {x:e}");
            }
        }
    )*};
}

floats_at_the_end_of_their_range! {
    doubles_at_the_end_of_their_range: f64, f64::from_bits(1);
    singles_at_the_end_of_their_range: f32, f32::from_bits(1);
}
