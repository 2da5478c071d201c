//! Tests Hilbert functions and degrees of systems with known answers.

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::rational::Rational;
use kahan_discover::Deadline;
use kahan_discover::maps::search_field::SearchField;
use kahan_discover::modular::modulus::Modulus;
use kahan_discover::orbits::degrees::{DegreeLimits, degrees};
use kahan_discover::orbits::growth::{Growth, GrowthVerdict};
use kahan_discover::orbits::hilbert::Hilbert;

mod support;
use support::*;

fn hilbert(text: &str, eps: Option<Rational>, degree: u32) -> Hilbert {
    let searched = SearchField::new(&system(text).field, eps);
    Hilbert::of(&searched, degree, &mut SplitMix64::new(5), &Deadline::never()).expect("the map has values")
}

fn check_hilbert(text: &str, integrals: usize, expected: &[usize]) {
    let found = hilbert(text, None, expected.len() as u32);
    assert_eq!(found.values, expected, "{text}");
    assert_eq!((found.integrals, found.agree, found.orbits), (integrals, true, 4), "{text}");
}

#[test]
fn hilbert_functions_of_known_systems() {
    let up_to = |function: fn(usize) -> usize| (1..=5).map(function).collect::<Vec<_>>();
    check_hilbert(E1, 2, &up_to(|d| 2 * d + 1));
    check_hilbert(E3, 2, &up_to(|d| 2 * d + 1));
    for text in [E2, E4, E5, E6, EULER] {
        check_hilbert(text, 2, &up_to(|d| 4 * d));
    }
    for text in [E7, E8, E9, LORENZ, ZHUKOVSKY] {
        check_hilbert(text, 0, &[4, 10, 20, 35, 56]);
    }
    check_hilbert(LOTKA_VOLTERRA, 0, &[3, 6, 10, 15, 21, 28]);
    check_hilbert(WEIERSTRASS, 1, &up_to(|d| 3 * d));
    check_hilbert(VOLTERRA, 2, &up_to(|d| 3 * d));
    check_hilbert(LAGRANGE, 4, &[6, 18, 38]);
    check_hilbert(HENON_HEILES, 1, &[5, 15, 35, 69, 121]);
}

#[test]
fn a_special_time_step_has_an_integral_that_others_have_not() {
    for eps in [1, -1] {
        let found = hilbert(LOTKA_VOLTERRA, Some(Rational::from(eps)), 6);
        assert_eq!(found.values, [3, 6, 10, 14, 18, 22]);
        assert_eq!(found.integrals, 1);
    }
}

fn check_degrees(text: &str, growth: &str, expected: &[usize]) {
    let searched = SearchField::new(&system(text).field, None);
    let mut random = SplitMix64::new(9);
    let map = searched.sample(Modulus::mersenne_61(), &mut random).unwrap().map;
    let limits = DegreeLimits { iterates: 16, degree: 600, deadline: &Deadline::never() };
    let found = degrees(&map, &mut random, limits);
    assert!(found.len() >= expected.len(), "{text}: {found:?}");
    assert_eq!(found[..expected.len()], *expected, "{text}");
    assert_eq!(GrowthVerdict::of(&found).growth.word(), growth, "{text}: {found:?}");
}

#[test]
fn degrees_of_known_systems() {
    let up_to = |function: fn(usize) -> usize| (0..=8).map(function).collect::<Vec<_>>();
    check_degrees(E1, "bounded", &[1, 2, 3, 3, 3]);
    check_degrees(E2, "bounded", &[1, 3, 5, 5, 5]);
    check_degrees(E3, "linear", &[1, 2, 4, 6, 8]);
    for text in [E4, E6, EULER] {
        check_degrees(text, "quadratic", &up_to(|n| 2 * n * n + 1));
    }
    check_degrees(E5, "linear", &[1, 3, 7, 11, 15]);
    for text in [E7, E8] {
        check_degrees(text, "linear", &[1, 3, 6, 9, 12]);
    }
    for text in [E9, ZHUKOVSKY] {
        check_degrees(text, "exponential", &[1, 3, 9, 27, 81]);
    }
    check_degrees(LOTKA_VOLTERRA, "exponential", &[1, 2, 4, 8, 16]);
    check_degrees(WEIERSTRASS, "quadratic", &[1, 2, 3, 5, 7, 11, 15, 20, 25, 32]);
    check_degrees(VOLTERRA, "quadratic", &[1, 3, 7, 15, 25, 39, 55, 75, 97]);
    check_degrees(LAGRANGE, "quadratic", &[1, 6, 18, 38, 66, 102]);
    check_degrees(HENON_HEILES, "exponential", &[1, 3, 7, 17, 39, 93, 215, 495]);
}

#[test]
fn the_entropy_is_the_logarithm_of_the_ratio() {
    let searched = SearchField::new(&system(E9).field, None);
    let mut random = SplitMix64::new(1);
    let map = searched.sample(Modulus::mersenne_61(), &mut random).unwrap().map;
    let found =
        degrees(&map, &mut random, DegreeLimits { iterates: 6, degree: 800, deadline: &Deadline::never() });
    let Growth::Exponential { entropy } = GrowthVerdict::of(&found).growth else { panic!("{found:?}") };
    // The ratio of the degrees is exactly 3. The quotient and the logarithm are rounded once each.
    assert!((entropy - 3f64.ln()).abs() <= 4.0 * f64::EPSILON);
}
