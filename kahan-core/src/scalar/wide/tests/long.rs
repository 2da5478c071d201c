//! Compares numbers on the heap with rationals.

use std::vec::Vec;

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::scalar::wide::{Capacity, LongNumber, equilibrate_row};
use crate::scalar::{Size, Wide};
use crate::{Constant, Scalar};

type Q = BigRational;

fn floats() -> Vec<f64> {
    let sizes = [-300, -20, 0, 3, 40, 290];
    sizes.iter().flat_map(|size| [1.1, -0.7].map(|x| x * f64::from(*size).exp2())).chain([0.0]).collect()
}

fn long(x: f64) -> LongNumber {
    LongNumber::new(Wide::from(x), Capacity::Most)
}

fn rational(x: f64) -> Q {
    Q::from_float(x).expect("finite")
}

#[test]
fn sums_and_products_are_exact() {
    let all = floats();
    for (&a, &b) in all.iter().flat_map(|a| all.iter().map(move |b| (a, b))) {
        for &c in &all {
            let value = long(a) * long(b) + long(c) - long(b);
            let exact = rational(a) * rational(b) + rational(c) - rational(b);
            assert_eq!(value.at_most().is_zero(), exact.is_zero());
            assert!(value.leading().radius().is_zero());
            let nearest = value.leading().to_f64();
            let error = (rational(nearest) - &exact).abs();
            assert!(error <= exact.abs() * rational(f64::EPSILON / 2.0), "{a:e} {b:e} {c:e}");
            assert!((value.clone() - value).is_zero());
        }
    }
}

#[test]
fn quotients_know_their_digits() {
    let third = LongNumber::one().quotient(long(3.0)).expect("a quotient");
    let rest = third.clone() * long(3.0) - LongNumber::one();
    assert!(rest.is_zero());
    let divisor = long(1e300) + long(3e-300);
    let quotient = LongNumber::one().quotient(divisor.clone()).expect("a quotient");
    let rest = (quotient * divisor - LongNumber::one()).at_most();
    assert!(!rest.is_zero() && rest < Size::from(1.0).scaled(-16_000));
    assert!(LongNumber::one().quotient(LongNumber::zero()).is_none());
    let undefined = LongNumber::one() / LongNumber::zero();
    assert!((LongNumber::zero() * undefined.clone()).at_most().is_unknown());
    assert!((undefined + long(1.0)).at_most().is_unknown());
}

#[test]
fn constants_and_pivots_are_those_of_the_numbers() {
    let seventh = LongNumber::constant(&Constant::ratio(1, 7));
    assert!((seventh * long(7.0) - LongNumber::one()).is_zero());
    assert!(long(-3.0).is_better_pivot(&long(2.0)) && !LongNumber::zero().is_better_pivot(&long(1e-300)));
    assert_eq!((-long(0.75)).approximate(), -0.75);
}

#[test]
fn a_levelled_row_is_the_same_equation() {
    let (mut row, mut right) = ([long(3e200), long(-5e-300), LongNumber::zero()], long(7e100));
    equilibrate_row(row.iter_mut(), &mut right);
    let largest = row[0].at_most();
    assert!(largest >= Size::from(1.0) && largest <= Size::from(2.0 + 1e-9));
    let ratio = |a: &LongNumber, b: f64| a.clone() / long(b);
    assert!((ratio(&row[0], 3e200) - ratio(&right, 7e100)).is_zero());
    assert!((ratio(&row[1], -5e-300) - ratio(&right, 7e100)).is_zero() && row[2].is_zero());
}

#[test]
fn more_room_is_asked_for_until_a_step_is_settled() {
    let known = long(1.5);
    // Two equal quotients are cut off at different digits; their difference may be nonzero.
    let divisor = || long(1e300) + long(3e-300);
    let lost = LongNumber::new(Wide::one(), Capacity::Few) / divisor() - LongNumber::one() / divisor();
    let are_settled = |components: &[(LongNumber, bool)]| {
        LongNumber::are_settled(components.iter().map(|(number, is_in_range)| (number, *is_in_range)))
    };
    assert!(are_settled(&[(known.clone(), true), (LongNumber::zero(), true)]));
    assert!(!are_settled(&[(known.clone(), true), (lost.clone(), true)]));
    assert!(are_settled(&[(known, false), (lost.clone(), true)]));
    assert!(!are_settled(&[(long(1.0), true), (lost, false)]));
}

#[test]
fn a_rounding_is_within_half_a_unit() {
    let third = LongNumber::one() / long(3.0);
    let unit = f64::EPSILON / 2.0;
    let is_within =
        |number: &LongNumber, relative| number.is_within(relative, Wide::from(number.leading().to_f64()));
    assert!(is_within(&third, unit) && !is_within(&third, unit / 4.0));
    assert!(is_within(&long(1.5), 0.0) && is_within(&LongNumber::zero(), 0.0));
    // Three quarters of the smallest float round to the smallest float.
    let few = long(f64::from_bits(1)) * long(0.75);
    assert!(is_within(&few, 0.25) && !is_within(&few, 0.24));
    let divisor = long(1e300) + long(3e-300);
    let near_one = LongNumber::one() / divisor.clone() * divisor;
    let lost = near_one.clone() - near_one;
    assert!(lost.is_zero() && !is_within(&lost, 1e300));
    assert!(!is_within(&(LongNumber::one() / LongNumber::zero()), 1e300));
}
