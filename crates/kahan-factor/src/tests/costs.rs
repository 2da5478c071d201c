//! Tests bounds on the work of factorisations. Work is counted equally on every machine.

use kahan_algebra::poly::{Budget, Monomial, Polynomial, Variable};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;

use super::random::{random_factor, random_irreducible};
use super::{assert_sound, p, product};
use crate::factors;

#[test]
fn an_exhausted_budget_leaves_square_free_parts() {
    let polynomial =
        product(&[(p("x^2 + y"), 2), (p("x^2 + z*y^2 + 3"), 2), (p("x*y*z"), 1), (p("x^3 - z^3 + y^3"), 1)]);
    let mut is_complete = false;
    for work in [0, 10, 100, 1000, 3000, 10_000, 10_000_000] {
        let factors = factors(&polynomial, &mut Budget::new(100_000, work));
        assert_sound(&polynomial, &factors);
        let largest = factors.factors.iter().map(|(factor, _)| factor.degree()).max().unwrap();
        // Even the smallest budget leaves only square-free factors, which have degree at most 5.
        assert!(largest <= 5, "{factors:?}");
        assert!(factors.is_complete >= is_complete, "more work leaves nothing behind");
        is_complete = factors.is_complete;
    }
    assert!(is_complete);
    assert!(!factors(&polynomial, &mut Budget::new(100_000, 0)).is_complete);
}

#[test]
fn an_exhausted_budget_leaves_square_free_contents() {
    let given = [(p("u^2 + v"), 2), (p("v^2*w^2 + u^3 + 1"), 3), (p("x*w + y^2"), 1)];
    let factors = factors(&product(&given), &mut Budget::new(100_000, 0));
    assert!(!factors.is_complete);
    assert_sound(&product(&given), &factors);
    assert_eq!(factors.factors.len(), 3);
    assert!(given.iter().all(|factor| factors.factors.contains(factor)), "{factors:?}");
}

#[test]
fn equal_inputs_have_equal_answers() {
    let whole = product(&[(p("x^2*y + z^3 - t"), 2), (p("t^2*y + z^2*x - 5"), 1)]);
    let budget = Budget::new(100_000, 20_000_000);
    let (mut first, mut second) = (budget.clone(), budget);
    assert_eq!(factors(&whole, &mut first), factors(&whole, &mut second));
    assert_eq!(first.work_left(), second.work_left());
}

/// Factors a product of random irreducible polynomials and returns the work.
fn work(rng: &mut SplitMix64, variables: u16, terms: u64, degree: u32, count: usize) -> u64 {
    let given: Vec<(Polynomial, u32)> =
        (0..count).map(|_| (random_irreducible(rng, variables, terms, degree), 1)).collect();
    let mut budget = Budget::new(100_000, u64::MAX);
    let found = factors(&product(&given), &mut budget);
    assert!(found.is_complete && found.factors.len() == count, "{found:?}");
    u64::MAX - budget.work_left()
}

#[test]
fn sparse_products_and_irreducible_ones_are_cheap() {
    let mut rng = SplitMix64::new(13);
    for (variables, terms, degree, count, most) in [
        (10, 30, 8, 2, 200_000),
        (8, 6, 4, 4, 400_000),
        (5, 20, 4, 3, 1_000_000),
        (3, 8, 5, 3, 200_000),
        (10, 1000, 12, 1, 20_000),
        (4, 300, 8, 1, 20_000),
    ] {
        let work = work(&mut rng, variables, terms, degree, count);
        assert!(work <= most, "{variables} {terms} {degree} {count}: {work}");
    }
}

/// An irreducible polynomial needs no lift, even if it is linear in no variable.
#[test]
fn one_irreducible_image_is_enough() {
    let mut rng = SplitMix64::new(14);
    let mut whole = random_factor(&mut rng, 6, 300, 8);
    for index in 0..6 {
        whole = &whole + &Polynomial::term(Monomial::power(Variable(index), 9), Rational::ONE);
    }
    let mut budget = Budget::new(100_000, 100_000);
    let factors = factors(&whole, &mut budget);
    assert!(factors.is_complete && factors.factors.len() == 1);
}

#[test]
fn tall_polynomials_keep_to_the_budget() {
    for text in
        ["x^2 - y^1048575", "x^1048576 - 1", "x^70000 - y^1048576 + z^3", "x^2*y^999999 - z^1000000*x + 5"]
    {
        let polynomial = p(text).primitive_part();
        let factors = factors(&polynomial, &mut Budget::new(100_000, 1_000_000));
        assert!(!factors.is_complete, "{text}");
        assert_eq!(factors.factors, [(polynomial, 1)]);
    }
}

fn spent(polynomial: &Polynomial) -> u64 {
    let mut budget = Budget::new(100_000, u64::MAX);
    assert!(factors(polynomial, &mut budget).is_complete);
    u64::MAX - budget.work_left()
}

/// A polynomial of degree 1 in a variable is irreducible if its two coefficients are coprime.
#[test]
fn linear_polynomials_are_cheapest() {
    let mut rng = SplitMix64::new(17);
    let coefficient = random_factor(&mut rng, 6, 300, 8);
    let rest = random_factor(&mut rng, 6, 300, 8);
    let linear = &(&coefficient * &Polynomial::variable(Variable(7))) + &rest;
    assert!(spent(&linear) <= 2 * linear.len() as u64);
}

/// Most polynomials are proved irreducible by the degrees of factors modulo several primes.
#[test]
fn degrees_modulo_primes_settle_most() {
    let mut rng = SplitMix64::new(18);
    let mut sum = 0;
    for _ in 0..20 {
        let mut whole = p("x^16");
        for power in 0..16 {
            let c = Rational::from(rng.below(1 << 40) as i64);
            whole = &whole + &Polynomial::term(Monomial::power(Variable(23), power), c);
        }
        sum += spent(&whole);
    }
    assert!(sum <= 110_000, "{sum}");
}

/// Long coefficients need several primes. Divisions are tried only after the last prime.
#[test]
fn wrong_candidates_are_not_divided_by() {
    let mut rng = SplitMix64::new(19);
    let long = Rational::parse("12345678901234567890123456789012345678901234567891").unwrap();
    let mut factor = || {
        let terms = random_factor(&mut rng, 5, 30, 6);
        &terms.scale(&long) + &p("a^7 + b^7 + c^7 + d^7 + e^7")
    };
    let whole = &factor() * &factor();
    assert!(spent(&whole) <= 365_000, "{}", spent(&whole));
}

#[test]
fn the_better_of_several_images_is_lifted() {
    let mut rng = SplitMix64::new(20);
    let mut sum = 0;
    for _ in 0..30 {
        let other = &random_factor(&mut rng, 5, 30, 6) + &p("a^7 + b^7 + c^7 + d^7 + e^7");
        sum += spent(&(&p("b^2 - a^3") * &other));
    }
    assert!(sum <= 400_000, "{sum}");
}
