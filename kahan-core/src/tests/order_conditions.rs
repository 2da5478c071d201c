//! Tests that the coefficients of compositions satisfy the order conditions.
//!
//! A symmetric one-step method of step h is exp(hY₁ + h³Y₃ + h⁵Y₅ + …) with derivations Yₖ. A
//! composition is a product of these exponentials with γᵢh in place of h. The composition has order
//! p if the product equals exp(hY₁) up to hᵖ (E. Hairer, C. Lubich, G. Wanner, Geometric Numerical
//! Integration, III.3).

use std::collections::BTreeMap;
use std::vec::Vec;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::{Composition, Constant};

type Q = BigRational;

/// A series in words over the letters 1, 3, 5, 7, truncated by grade (the sum of a word's letters).
/// The coefficients are multiples of 2⁻²⁰⁰.
type Series = BTreeMap<Vec<u32>, BigInt>;

const BITS: u32 = 200;

fn one() -> BigInt {
    BigInt::one() << BITS
}

fn product(a: &Series, b: &Series, grade: u32) -> Series {
    let mut product = Series::new();
    for (left, p) in a {
        for (right, q) in b {
            let word = [left.as_slice(), right].concat();
            if word.iter().sum::<u32>() <= grade {
                *product.entry(word).or_insert_with(BigInt::zero) += (p * q) >> BITS;
            }
        }
    }
    product
}

fn exponential(letters: &Series, grade: u32) -> Series {
    let mut power: Series = [(Vec::new(), one())].into();
    let mut sum = power.clone();
    for k in 1..=grade {
        power = product(&power, letters, grade);
        power.values_mut().for_each(|value| *value /= k);
        for (word, value) in &power {
            *sum.entry(word.clone()).or_insert_with(BigInt::zero) += value;
        }
    }
    sum
}

/// Returns the largest difference of composition and flow in any coefficient up to this grade.
fn residual(composition: Composition, grade: u32) -> Q {
    let mut composed: Series = [(Vec::new(), one())].into();
    for gamma in composition.coefficients() {
        let gamma = gamma.to_ratio();
        let fixed = |value: Q| (value * Q::from_integer(one())).to_integer();
        let letter = |letter: u32| (Vec::from([letter]), fixed(gamma.pow(letter as i32)));
        let letters = (1..=grade).step_by(2).map(letter).collect();
        composed = product(&composed, &exponential(&letters, grade), grade);
    }
    let flow = exponential(&[(Vec::from([1]), one())].into(), grade);
    let difference =
        |(word, value): (&Vec<u32>, &BigInt)| (value - flow.get(word).unwrap_or(&BigInt::zero())).abs();
    Q::new(composed.iter().map(difference).max().unwrap_or_default(), one())
}

fn ten_to_minus(digits: u32) -> Q {
    Q::new(BigInt::one(), BigInt::from(10).pow(digits))
}

/// Coefficients of 40 decimals change the conditions by less than 10⁻³⁸.
#[test]
fn the_coefficients_satisfy_the_order_conditions_to_40_digits() {
    for composition in Composition::ALL {
        let residual = residual(composition, composition.order());
        assert!(residual <= ten_to_minus(38), "{composition:?}: {residual}");
    }
}

/// Conditions of even grade hold automatically; therefore grade p + 1 fails first.
#[test]
fn the_order_is_not_higher_than_stated() {
    for composition in Composition::ALL {
        let residual = residual(composition, composition.order() + 1);
        assert!(residual >= ten_to_minus(4), "{composition:?}: {residual}");
    }
}

#[test]
fn the_coefficients_are_decimals_of_40_digits_and_sum_to_one() {
    let scale = Q::from_integer(BigInt::from(10).pow(40));
    for composition in Composition::ALL {
        let gammas: Vec<Q> = composition.coefficients().map(Constant::to_ratio).collect();
        assert!(gammas.iter().all(|gamma| (gamma * &scale).is_integer()), "{composition:?}");
        assert_eq!(gammas.into_iter().sum::<Q>(), Q::one(), "{composition:?}");
    }
}

#[test]
fn the_roundings_of_the_coefficients_are_the_nearest() {
    let half = Q::new(BigInt::one(), 2.into());
    let rational = |x: f64| Q::from_float(x).unwrap();
    for gamma in Composition::ALL.iter().flat_map(Composition::coefficients) {
        let exact = gamma.to_ratio();
        let double = gamma.to_f64();
        let unit = rational(double.abs().next_up()) - rational(double.abs());
        assert!((&exact - rational(double)).abs() <= &half * unit, "{gamma:?}");
        let single = gamma.to_f32();
        let unit = rational(single.abs().next_up().into()) - rational(single.abs().into());
        assert!((&exact - rational(single.into())).abs() <= &half * unit, "{gamma:?}");
        let (high, low) = gamma.to_double_double();
        let rest = exact - rational(high);
        let unit = rational(low.abs().next_up()) - rational(low.abs());
        assert!((rest - rational(low)).abs() <= half.clone() * unit, "{gamma:?}");
    }
}
