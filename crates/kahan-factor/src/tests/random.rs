//! Tests seeded random products. Some of their factors are irreducible by Eisenstein's criterion.

use kahan_algebra::poly::{Monomial, Polynomial, Variable};
use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;

use super::{all_factors, p, product};

pub(super) fn random_factor(rng: &mut SplitMix64, variables: u16, terms: u64, degree: u64) -> Polynomial {
    let mut factor = Polynomial::from_terms((0..terms).map(|_| {
        let powers =
            (0..rng.below(degree + 1)).map(|_| (Variable(rng.below(u64::from(variables)) as u16), 1));
        let monomial: Monomial = powers.collect::<Vec<_>>().into_iter().collect();
        (monomial, Rational::from(rng.below(21) as i64 - 10))
    }));
    factor = factor.div_monomial(&factor.monomial_content()).unwrap().primitive_part();
    factor
}

#[test]
fn random_products_have_the_factors_of_their_factors() {
    let mut rng = SplitMix64::new(11);
    for _ in 0..60 {
        let variables = 2 + rng.below(5) as u16;
        let mut expected: Vec<(Polynomial, u32)> = Vec::new();
        let mut whole = Polynomial::one();
        for _ in 0..2 + rng.below(3) {
            let terms = 2 + rng.below(5);
            let factor = random_factor(&mut rng, variables, terms, 3);
            let exponent = 1 + rng.below(3) as u32;
            if factor.degree() == 0 || whole.len() * factor.len().pow(exponent) > 30_000 {
                continue;
            }
            whole = &whole * &product(&[(factor.clone(), exponent)]);
            for (part, multiplicity) in all_factors(&factor) {
                match expected.iter_mut().find(|(known, _)| *known == part) {
                    Some((_, sum)) => *sum += multiplicity * exponent,
                    None => expected.push((part, multiplicity * exponent)),
                }
            }
        }
        assert!(whole.degree() > 0, "a product of constants");
        let found = all_factors(&whole);
        assert_eq!(found.len(), expected.len(), "{found:?} {expected:?}");
        assert!(expected.iter().all(|factor| found.contains(factor)), "{found:?} {expected:?}");
    }
}

#[test]
fn irreducible_factors_stay_so_in_other_variables() {
    let mut rng = SplitMix64::new(12);
    for _ in 0..40 {
        let whole = &random_factor(&mut rng, 4, 5, 4) * &random_factor(&mut rng, 4, 5, 3);
        let turned = whole.map_variables(|variable| Variable(9 - variable.0));
        let mut moved = Polynomial::zero();
        for (exponent, coefficient) in whole.coefficients_in(Variable(0)) {
            moved = &moved + &(&coefficient * &product(&[(p("a + 1"), exponent)]));
        }
        assert_eq!(all_factors(&whole).len(), all_factors(&turned).len(), "{whole:?}");
        let without_a = |all: Vec<(Polynomial, u32)>| all.into_iter().map(|(_, e)| e).sum::<u32>();
        assert_eq!(without_a(all_factors(&whole)), without_a(all_factors(&moved)), "{whole:?}");
    }
}

/// Returns a polynomial that is irreducible by Eisenstein's criterion at a prime.
///
/// The prime divides all coefficients except the leading one. The constant term is the prime or its
/// negative, and is coprime to the leading coefficient.
pub(super) fn random_irreducible(
    rng: &mut SplitMix64,
    variables: u16,
    terms: u64,
    degree: u32,
) -> Polynomial {
    let main = Variable(rng.below(u64::from(variables)) as u16);
    let prime = [2, 3, 5, 7, 11][rng.below(5) as usize];
    let height = 1 + rng.below(u64::from(degree).min(4)) as u32;
    let mut sum = Polynomial::constant(Rational::from(if rng.below(2) == 0 { prime } else { -prime }));
    for _ in 2..terms {
        let term = random_term(rng, variables, degree);
        let (_, others) = term.split(|variable| variable == main);
        if height > 1 {
            let power = 1 + rng.below(u64::from(height) - 1) as u32;
            let coefficient = Rational::from(prime * (1 + rng.below(40) as i64));
            sum = &sum + &Polynomial::term(others.mul(&Monomial::power(main, power)), coefficient);
        }
    }
    let (_, lead) = random_term(rng, variables, degree / 2).split(|variable| variable == main);
    let unit = 1 + prime * rng.below(5) as i64;
    (&sum + &Polynomial::term(lead.mul(&Monomial::power(main, height)), Rational::from(unit)))
        .primitive_part()
}

fn random_term(rng: &mut SplitMix64, variables: u16, degree: u32) -> Monomial {
    let powers =
        (0..rng.below(u64::from(degree) + 1)).map(|_| (Variable(rng.below(u64::from(variables)) as u16), 1));
    powers.collect::<Vec<_>>().into_iter().collect()
}

#[test]
fn products_of_irreducible_factors_come_back_exactly() {
    let mut rng = SplitMix64::new(15);
    for round in 0..120 {
        let variables = 1 + rng.below(6) as u16;
        let mut given: Vec<(Polynomial, u32)> = Vec::new();
        for _ in 0..2 + rng.below(3) {
            let terms = 2 + rng.below(5);
            let degree = 2 + rng.below(3) as u32;
            let factor = random_irreducible(&mut rng, variables, terms, degree);
            let size = product(&given).len() * factor.len();
            let exponent = 1 + rng.below(if size > 300 { 1 } else { 3 }) as u32;
            if given.iter().all(|(known, _)| *known != factor) {
                given.push((factor, exponent));
            }
        }
        let found = all_factors(&product(&given));
        assert_eq!(found.len(), given.len(), "round {round}: {given:?} became {found:?}");
        assert!(given.iter().all(|factor| found.contains(factor)), "round {round}: {given:?} {found:?}");
    }
}

#[test]
fn factors_have_irreducible_images_elsewhere() {
    let mut rng = SplitMix64::new(16);
    let mut seen = 0;
    for _ in 0..30 {
        let whole = &random_factor(&mut rng, 3, 5, 4) * &random_factor(&mut rng, 3, 4, 4);
        for (factor, _) in all_factors(&whole) {
            let Some(main) = factor.variables().into_iter().next_back() else { continue };
            let has_image = (0..60).any(|_| {
                let others = factor.variables().into_iter().filter(|variable| *variable != main);
                let image = others.fold(factor.clone(), |image, variable| {
                    image.substitute(variable, &Rational::from(100 + rng.below(1000) as i64))
                });
                let found = all_factors(&image);
                image.degree() == factor.degree_in(main) && matches!(found.as_slice(), [(_, 1)])
            });
            assert!(has_image, "{factor:?}");
            seen += 1;
        }
    }
    assert!(seen >= 60, "{seen} factors");
}
