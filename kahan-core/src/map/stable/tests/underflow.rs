//! Values next to underflow: errors of η that products carry as far as the range lets them, beside
//! the allowance.

use num_traits::{Signed, ToPrimitive};

use super::worst::{Beside, Q, Worst, off_by};
use crate::scalar::bounded::underflow;
use crate::scalar::bounded::{Number, power_of_two};

const FINE: i32 = 40;
/// Nothing is rounded, and every operation is off by η.
const TINY: (i64, i64) = (0, 1);

type Value = Beside<FINE>;

/// How often an error of η may double: 30 times are allowed for, 20 of them are products of inputs.
fn assert_allowed(value: &Value) {
    let error = value.error();
    assert!(error.is_positive() && value.part() <= 1.0, "{} of the bound: {value:?}", value.part());
}

/// The largest input that a formula allows, a power of two; the formula is made with inputs of 1 to
/// ask it.
fn largest_input(formula: impl Fn(&Value) -> Value) -> f64 {
    power_of_two(formula(&Value::given(1.0)).bounded.largest_input() as i32)
}

#[test]
fn an_operation_that_underflows_is_allowed_for() {
    let (zero, one) = (Value::given(0.0), Value::given(1.0));
    for value in off_by(TINY, || [zero.times(&one), zero.plus(&zero), zero.over(&one).expect("a quotient")]) {
        assert_allowed(&value);
    }
}

/// Σ of products with an underflowed one, as large as the bits of products let them be.
#[test]
fn products_carry_an_underflow_as_far_as_their_inputs_let_them() {
    for count in 2..8 {
        let formula = |x: &Value| {
            let tiny = Value::given(0.0).times(&Value::given(0.0));
            off_by((0, 0), || (0..count).fold(tiny.clone(), |product, _| product.times(x)))
        };
        let largest = largest_input(formula);
        let value = off_by(TINY, || formula(&Value::given(largest)));
        assert_allowed(&value);
    }
}

#[test]
fn sums_and_constants_take_their_bits() {
    // Doubled 18 times: one input is left a size of 2 bits.
    let formula = |x: &Value| {
        let tiny = Value::given(0.0).times(&Value::given(0.0));
        off_by((0, 0), || (0..18).fold(tiny.times(x), |sum, _| sum.plus(&sum)))
    };
    let bits = formula(&Value::given(1.0)).bounded.largest_input();
    // A sum of sums is worth one bit each.
    assert!(bits <= 2);
    assert_allowed(&off_by(TINY, || formula(&Value::given(power_of_two(bits as i32)))));

    let formula = |x: &Value| {
        let tiny = Value::given(0.0).times(&Value::given(0.0));
        let large = Value::literal(1 << 7, 1);
        off_by((0, 0), || tiny.times(x).times(&large).times(&large))
    };
    let largest = largest_input(formula);
    assert!(largest <= power_of_two(20 - 14));
    assert_allowed(&off_by(TINY, || formula(&Value::given(largest))));
}

/// Divided by the least divisor, an error of η grows by its bits, and by as many again where the
/// divisor has that error.
#[test]
fn quotients_take_the_bits_of_divisors_twice() {
    let least = power_of_two(-(Worst::<FINE>::RANGE.bits_of_divisors as i32)) * 1.01;
    let formula = |x: &Value| {
        let divisor = |least: f64| Value::given(least).plus(&Value::given(0.0));
        let first = Value::given(0.0).times(&Value::given(0.0)).times(x);
        first.over(&divisor(least)).and_then(|v| v.over(&divisor(least))).expect("a quotient")
    };
    let bits = formula(&Value::given(1.0)).bounded.largest_input();
    assert!(bits <= (20 - 16) / 2, "{bits}");
    assert_allowed(&off_by(TINY, || formula(&Value::given(power_of_two(bits as i32)))));
    // v̂·(b̂ − b)/b̂ with a v̂ of 1/b̂.
    let formula = |x: &Value| Value::given(1.0).times(x).over(&Value::given(least).plus(&Value::given(0.0)));
    let largest =
        power_of_two(formula(&Value::given(1.0)).expect("a quotient").bounded.largest_input() as i32);
    assert_allowed(&off_by(TINY, || formula(&Value::given(largest)).expect("a quotient")));
    // Below the least divisor there is no quotient.
    assert!(Value::given(1.0).over(&Value::given(least / 1.02)).is_none());
}

#[test]
fn steps_divided_by_eps_take_the_bits_of_steps() {
    let least = Value::given(power_of_two(-(Worst::<FINE>::RANGE.bits_of_steps as i32)));
    let formula = |x: &Value| {
        let tiny = Value::given(0.0).times(&Value::given(0.0)).times(x);
        off_by((0, 0), || {
            let large = Value::literal(1, 1).over_input(&least);
            tiny.times(&large).times(&large).times(&large)
        })
    };
    let largest = largest_input(formula);
    assert!(largest <= power_of_two(20 - 18));
    assert_allowed(&off_by(TINY, || formula(&Value::given(largest))));
}

/// A numerator of 0 that underflowed, times a reciprocal: nothing but the allowance speaks of its
/// error.
#[test]
fn a_weight_allows_for_underflow_in_numerator_and_reciprocal() {
    let as_float = |error: Q| error.to_f64().expect("a number");
    let (numerator, reciprocal, product) = off_by(TINY, || {
        let numerator = Value::given(0.0).times(&Value::given(1.0));
        let reciprocal = Value::given(1.0).over(&Value::given(0.125)).expect("a quotient");
        (numerator.clone(), reciprocal.clone(), numerator.times(&reciprocal))
    });
    let roundings = numerator.bounded.roundings();
    let magnitude = numerator.bounded.magnitude();
    let weight = reciprocal.bounded.weight(roundings);
    let bound = (magnitude + underflow::<Worst<FINE>>(roundings)) * weight;
    assert!(as_float(product.error()) <= bound);
    // The reciprocal's own: an increment of 0 times η, where r̂ is 0 beside it.
    let (reciprocal, product) = off_by(TINY, || {
        let reciprocal = Value::given(0.0).over(&Value::given(1.0)).expect("a quotient");
        (reciprocal.clone(), Value::given(1.0).times(&reciprocal))
    });
    assert!(as_float(product.error()) <= reciprocal.bounded.weight(0));
}

/// A reciprocal of a whole constant, which is finer than what its divisor lost below the range.
#[test]
fn a_weight_of_a_chain_allows_for_underflow() {
    const FINEST: i32 = 60;
    type Finest = Beside<FINEST>;
    let reciprocal = off_by(TINY, || {
        let lost = Finest::given(0.0).times(&Finest::given(0.0)).times(&Finest::given(power_of_two(18)));
        Finest::literal(1, 1).over(&Finest::given(0.25).plus(&lost)).expect("a quotient")
    });
    let product = Finest::given(1.0).times(&reciprocal);
    let error = product.error().to_f64().expect("a number");
    assert!(error <= reciprocal.bounded.weight(0) && error > 16.0 * Worst::<FINEST>::UNIT);
}

/// The same with the machine's floats: the least numbers, carried as far as their ranges allow.
macro_rules! floats_at_the_end_of_their_range {
    ($($name:ident: $float:ty, $least:expr;)*) => {$(
        #[test]
        fn $name() {
            use crate::scalar::bounded::Bounded;
            for count in 1..9 {
                let formula = |a: $float, b: $float, x: $float| {
                    let tiny = Bounded::<$float>::given(a) * Bounded::given(b);
                    (0..count).fold(tiny, |product, _| product * Bounded::given(x))
                };
                let x = 2.0_f64.powi(formula(1.0, 1.0, 1.0).largest_input() as i32) as $float;
                // Half of the least number, which is lost.
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
