use kahan_syntax::rational::Rational;

use super::RationalFunction;
use crate::poly::{Budget, Monomial, OverBudget, Polynomial, Variable, gcd};
use crate::prime_field::SplitMix64;

fn random_polynomial(rng: &mut SplitMix64, terms: usize) -> Polynomial {
    Polynomial::from_terms((0..terms).map(|_| {
        let powers = (0..3).map(|index| (Variable(index), u32::try_from(rng.below(2)).unwrap()));
        let monomial: Monomial = powers.collect();
        let numerator = i64::try_from(rng.below(9)).unwrap() - 4;
        (monomial, Rational::new(numerator, 1 + i64::try_from(rng.below(3)).unwrap()))
    }))
}

fn random(rng: &mut SplitMix64) -> RationalFunction {
    loop {
        let (numerator, denominator) = (random_polynomial(rng, 3), random_polynomial(rng, 2));
        if let Some(function) = RationalFunction::new(numerator, denominator) {
            return function;
        }
    }
}

fn assert_normal(function: &RationalFunction) {
    assert!(gcd(&function.numerator, &function.denominator).is_one(), "{function:?}");
    assert!(function.denominator.content().is_one(), "{function:?}");
}

#[test]
fn rational_functions_form_a_field() {
    let mut rng = SplitMix64::new(11);
    for _ in 0..25 {
        let [p, q, r] = [0; 3].map(|_| random(&mut rng));
        for result in [&p + &q, &p - &q, &p * &q, p.derivative(Variable(0))] {
            assert_normal(&result);
        }
        assert_eq!(&p + &q, &q + &p);
        assert_eq!(&(&p + &q) + &r, &p + &(&q + &r));
        assert_eq!(&(&p * &q) * &r, &p * &(&q * &r));
        assert_eq!(&p * &(&q + &r), &(&p * &q) + &(&p * &r));
        assert!((&p - &p).is_zero());
        assert_eq!(&p + &-&p, RationalFunction::zero());
        match p.checked_div(&q) {
            Some(quotient) => assert_eq!(&quotient * &q, p),
            None => assert!(q.is_zero()),
        }
    }
}

#[test]
fn equal_functions_are_equal_as_data() {
    let (x, y) = (RationalFunction::variable(Variable(0)), RationalFunction::variable(Variable(1)));
    let difference_of_squares = &(&x * &x) - &(&y * &y);
    assert_eq!(difference_of_squares.checked_div(&(&x - &y)), Some(&x + &y));
    let minus_two = RationalFunction::constant(Rational::from(-2));
    let half = x.checked_div(&(&minus_two * &y)).unwrap();
    assert_eq!(*half.denominator(), Polynomial::variable(Variable(1)));
    assert_eq!(half, -&(&x * &RationalFunction::constant(Rational::new(1, 2))).checked_div(&y).unwrap());
    assert_eq!((&x + &y).as_polynomial(), Some((&x + &y).numerator()));
    assert_eq!(half.as_polynomial(), None);
}

#[test]
fn the_derivative_obeys_the_quotient_rule() {
    let mut rng = SplitMix64::new(12);
    let x = Variable(1);
    let mut compared = 0;
    for _ in 0..20 {
        let (p, q) = (random(&mut rng), random(&mut rng));
        let Some(quotient) = p.checked_div(&q) else { continue };
        let rule = &(&p.derivative(x) * &q) - &(&p * &q.derivative(x));
        assert_eq!(Some(quotient.derivative(x)), rule.checked_div(&(&q * &q)));
        compared += 1;
    }
    assert!(compared >= 15, "{compared} quotients");
}

#[test]
fn zero_has_no_reciprocal_and_no_function_a_zero_denominator() {
    assert_eq!(RationalFunction::zero().recip(), None);
    assert_eq!(RationalFunction::zero().recip(), None);
    assert_eq!(RationalFunction::one().checked_div(&RationalFunction::zero()), None);
    assert_eq!(RationalFunction::new(Polynomial::one(), Polynomial::zero()), None);
    assert_eq!(
        RationalFunction::new(Polynomial::zero(), Polynomial::variable(Variable(3))),
        Some(RationalFunction::zero())
    );
}

#[test]
fn an_operation_over_budget_says_so() {
    let mut rng = SplitMix64::new(14);
    let (p, q) = (random(&mut rng), random(&mut rng));
    assert_eq!(p.add_within(&q, &mut Budget::new(1000, 2)), Err(OverBudget));
    assert_eq!(p.add_within(&q, &mut Budget::new(1000, 100_000)), Ok(&p + &q));
}
