//! Tests that plans compute their polynomials.

use kahan_algebra::arithmetic::{Exact, Modular};
use kahan_algebra::plan::{Input, Operation, PlanBuilder};
use kahan_algebra::poly::{Monomial, Polynomial, Variable};
use kahan_algebra::prime_field::{PrimeField, SplitMix64};
use kahan_algebra::rational::Rational;

fn random_case(random: &mut SplitMix64) -> (Polynomial, Vec<Rational>) {
    let small =
        |random: &mut SplitMix64| Rational::new(random.below(13) as i64 - 6, 1 + random.below(4) as i64);
    let count = 1 + random.below(12);
    let terms: Vec<(Monomial, Rational)> = (0..count)
        .map(|_| {
            let powers = (0..4u16).map(|v| (Variable(v), random.below(4) as u32)).filter(|(_, e)| *e > 0);
            (powers.collect::<Monomial>(), small(random))
        })
        .collect();
    (Polynomial::from_terms(terms), (0..4).map(|_| small(random)).collect())
}

fn value(polynomial: &Polynomial, point: &[Rational]) -> Rational {
    polynomial.terms().fold(Rational::zero(), |sum, (monomial, coefficient)| {
        let term = monomial.powers().iter().fold(coefficient.clone(), |product, (variable, exponent)| {
            &product
                * &point[usize::from(variable.0)].pow(*exponent as i32).expect("the exponent is positive")
        });
        &sum + &term
    })
}

fn value_at(point: &[Rational], input: &Input) -> Option<Rational> {
    input.variable().map(|Variable(k)| point[usize::from(k)].clone())
}

#[test]
fn the_nested_form_of_a_polynomial_has_its_values() {
    let mut random = SplitMix64::new(20);
    for _ in 0..500 {
        let (polynomial, point) = random_case(&mut random);
        let mut builder = PlanBuilder::default();
        let node = builder.polynomial(&polynomial);
        let plan = builder.finish(&[node]);
        let results = plan.evaluate(&Exact, |input| value_at(&point, input));
        assert_eq!(results, [Some(value(&polynomial, &point))], "{polynomial:?} at {point:?}");
    }
}

#[test]
fn two_arithmetics_agree_on_one_plan() {
    let mut random = SplitMix64::new(21);
    let field = PrimeField::random(&mut random);
    for _ in 0..200 {
        let (a, point) = random_case(&mut random);
        let (b, _) = random_case(&mut random);
        let mut builder = PlanBuilder::default();
        let (a, b) = (builder.polynomial(&a), builder.polynomial(&b));
        let quotient = builder.divide(a, b);
        let plan = builder.finish(&[quotient]);
        let exact = plan.evaluate(&Exact, |input| value_at(&point, input)).remove(0);
        let modular =
            plan.evaluate(&Modular(field), |input| field.reduce(&value_at(&point, input)?)).remove(0);
        assert_eq!(exact.map(|value| field.reduce(&value)), modular.map(Some));
    }
}

#[test]
fn what_is_common_is_computed_once() {
    let [x, y] = [0, 1].map(|v| Polynomial::variable(Variable(v)));
    let square = &(&x * &x) + &(&y * &y);
    let mut builder = PlanBuilder::default();
    let outputs = [&square, &(&x * &square), &(&y * &square)].map(|p| builder.polynomial(p));
    let plan = builder.finish(&outputs);
    let products = plan.operations.iter().filter(|step| matches!(step, Operation::Multiply(..))).count();
    // The products are x·x, y·y, x·s and y·s.
    assert_eq!(products, 4, "{plan:?}");
}

#[test]
fn a_division_by_zero_spoils_only_the_results_that_need_it() {
    let mut builder = PlanBuilder::default();
    let x = builder.input(Variable(0));
    let one = builder.constant(&Rational::one());
    let inverse = builder.divide(one, x);
    let plan = builder.finish(&[inverse, x]);
    assert_eq!(plan.evaluate(&Exact, |_| Some(Rational::zero())), [None, Some(Rational::zero())]);
}
