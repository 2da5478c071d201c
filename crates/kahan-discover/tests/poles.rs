//! Tests of singularity patterns for systems with known answers.

use kahan_algebra::rational::Rational;
use kahan_discover::orbits::growth::{Growth, GrowthVerdict};
use kahan_discover::poles::{Pattern, Poles};
use kahan_discover::{DiscoverError, Options, Unwatched, poles};

mod exact_germ;
mod support;
use exact_germ::ExactGerm;
use support::*;

fn found(text: &str, eps: Option<Rational>, steps: usize) -> Poles {
    let options = Options { eps, ..Options::default() };
    poles(&system(text), &options, steps, &Unwatched).expect("there is a map")
}

/// Returns for each curve its name, whether it is confined, and the dimensions of its images.
fn verdicts(found: &Poles) -> Vec<(String, Option<bool>, Vec<usize>)> {
    let dimensions =
        |pattern: &Pattern| pattern.images[..pattern.steps].iter().map(|image| image.dimension).collect();
    found.patterns.iter().map(|p| (p.name(&found.symbols), p.confined, dimensions(p))).collect()
}

#[test]
fn patterns_of_known_systems() {
    let weierstrass = [
        ("-1 + 12*eps^2*x", Some(true), vec![0, 0, 0, 1]),
        ("1 - 24*eps^2*x - 24*eps^3*y + 24*eps^4*a", Some(true), vec![0, 0, 0, 0, 0, 1]),
        ("infinity", Some(true), vec![0, 1]),
    ];
    let expected = weierstrass.map(|(curve, confined, images)| (curve.to_owned(), confined, images));
    assert_eq!(verdicts(&found(WEIERSTRASS, None, 8)), expected);
    // Lotka and Volterra's map contracts three lines, which are not confined.
    let generic = found(LOTKA_VOLTERRA, None, 8);
    assert!(
        verdicts(&generic).iter().all(|(_, confined, images)| *confined == Some(false) && *images == [0; 8])
    );
    assert_eq!(generic.patterns.len(), 3);
    let e4 = found(E4, None, 4);
    let expected = [(true, vec![2]), (true, vec![0, 0, 2]), (true, vec![0, 0, 2])];
    let e4: Vec<_> =
        verdicts(&e4).into_iter().map(|(_, confined, images)| (confined == Some(true), images)).collect();
    assert_eq!(e4, expected);
}

#[test]
fn patterns_imply_the_degrees_that_are_measured() {
    let fields = [
        LOTKA_VOLTERRA,
        WEIERSTRASS,
        E1,
        E2,
        E3,
        E4,
        E5,
        E6,
        E7,
        E8,
        E9,
        EULER,
        VOLTERRA,
        LORENZ,
        HENON_HEILES,
    ];
    for text in fields {
        let found = found(text, None, 7);
        let implied = found.implied_degrees.as_ref().expect(text);
        let both = implied.len().min(found.degrees.len());
        assert!(both >= 7, "{text}");
        assert_eq!(implied[..both], found.degrees[..both], "{text}");
    }
}

#[test]
fn confinement_alone_proves_nothing() {
    let confines = |found: &Poles| found.patterns.iter().all(|pattern| pattern.confined == Some(true));
    let growth = |found: &Poles| GrowthVerdict::of(&found.degrees).growth;
    let chaotic = found(HENON_HEILES, None, 8);
    assert!(confines(&chaotic) && matches!(growth(&chaotic), Growth::Exponential { .. }));
    let linear = found(E3, None, 8);
    assert!(!confines(&linear) && growth(&linear) == Growth::Linear);
}

/// Compares patterns at ε = 1/3 with images of points that are computed exactly over ℚ(δ).
fn check_against_exact_germs(text: &str, steps: usize, expected: usize) {
    let eps = Rational::new(1, 3);
    let found = found(text, Some(eps.clone()), steps);
    let mut checked = 0;
    for pattern in &found.patterns {
        let Some(curve) = &pattern.curve else { continue };
        let Some(mut germ) = ExactGerm::on(&system(text).field, &eps, curve, 2) else { continue };
        let Some(mut other) = ExactGerm::on(&system(text).field, &eps, curve, 5) else { continue };
        for image in &pattern.images {
            germ.step();
            other.step();
            assert_eq!(
                (germ.dimension(), germ.is_infinite()),
                (image.dimension, image.is_infinite),
                "{text}"
            );
            assert_eq!(germ.place() == other.place(), image.dimension == 0, "{text}");
        }
        checked += 1;
    }
    assert_eq!(checked, expected, "{text}");
}

#[test]
fn every_verdict_is_that_of_the_moved_curve() {
    check_against_exact_germs(LOTKA_VOLTERRA, 4, 3);
    check_against_exact_germs("xdot = y; ydot = 6*x^2 - 2;", 6, 2);
    check_against_exact_germs(E1, 4, 3);
    check_against_exact_germs(E3, 4, 2);
}

#[test]
fn what_has_no_poles_to_follow_says_why() {
    let refused = |text: &str, eps| {
        poles(&system(text), &Options { eps, ..Options::default() }, 3, &Unwatched).expect_err(text)
    };
    assert_eq!(refused(E1, Some(Rational::zero())), DiscoverError::ZeroStep);
    assert_eq!(refused("xdot = x;", Some(Rational::from(1))), DiscoverError::NoMap);
    assert_eq!(refused("xdot = x;", Some(Rational::from(-1))), DiscoverError::Collapse);
}
