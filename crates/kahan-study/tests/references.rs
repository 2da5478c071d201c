//! Reference trajectories: two independent methods agree, and a disagreement is an error.

use kahan_algebra::rational::Rational;
use kahan_core::num_rational::BigRational;
use kahan_core::prelude::*;
use kahan_core::{Dd, KahanMap};
use kahan_study::reference::{Method, NoReference, Reference, Trajectory, TrajectoryLimits};
use kahan_systems::{E1, E2, E3, E4, E5, E6, E7, E8, E9, EulerTop, LotkaVolterra};

fn q(texts: &[&str]) -> Vec<BigRational> {
    texts.iter().map(|text| Rational::parse(text).expect("a number").to_big()).collect()
}

fn dd(text: &str) -> Dd {
    let (high, low) = Rational::parse(text).expect("a number").to_double_double();
    Dd::new(high, low)
}

fn reference<M: KahanMap<Dd, N>, const N: usize>(
    map: &M,
    command: &str,
    parameters: &[&str],
    start: &[&str],
    end: f64,
    allowed: f64,
) -> Result<Reference, NoReference> {
    let (parameters, start) = (q(parameters), q(start));
    let asked = Trajectory { command, parameters: &parameters, start: &start, end, allowed };
    Reference::of(map, &asked, &TrajectoryLimits::default())
}

/// The flows of these tests amplify a rounding error of 2⁻¹⁰⁶ ≈ 1.2e-32 to at most 1.2e-28. Eight
/// times as much is allowed, because there are several rounding errors.
const AGREEMENT: f64 = 1e-27;

#[test]
fn the_series_agrees_with_every_closed_solution_of_the_catalog() {
    let start = ["3/10", "2/5", "-1/5"];
    let closed = |command: &str, reference: Result<Reference, NoReference>| {
        let reference = reference.unwrap_or_else(|why| panic!("{command}: {why}"));
        let certificate = reference.certificate();
        assert_eq!(certificate.method, Method::ClosedSolution, "{command}");
        assert!(certificate.difference < AGREEMENT, "{command}: {certificate:?}");
        // A difference of 0 would mean that a method was compared with itself.
        assert!(certificate.difference > 0.0, "{command}");
    };
    let top = EulerTop { a1: dd("1"), a2: dd("-3"), a3: dd("1/3") };
    closed("euler", reference(&top, "euler", &["1", "-3", "1/3"], &start, 2.0, AGREEMENT));
    closed("e1", reference(&E1, "e1", &[], &start, 2.0, AGREEMENT));
    closed("e2", reference(&E2, "e2", &[], &start, 2.0, AGREEMENT));
    closed("e3", reference(&E3, "e3", &[], &start, 2.0, AGREEMENT));
    closed("e4", reference(&E4, "e4", &[], &start, 2.0, AGREEMENT));
    closed("e5", reference(&E5, "e5", &[], &start, 2.0, AGREEMENT));
    closed("e6", reference(&E6, "e6", &[], &start, 2.0, AGREEMENT));
    closed("e7", reference(&E7 { xi: dd("19/17") }, "e7", &["19/17"], &start, 2.0, AGREEMENT));
    closed("e8", reference(&E8, "e8", &[], &start, 2.0, AGREEMENT));
    closed("e9", reference(&E9 { xi: dd("1/2") }, "e9", &["1/2"], &start, 2.0, AGREEMENT));
}

#[test]
fn the_series_agrees_with_the_composition_where_there_is_no_closed_solution() {
    let allowed = 1e-18;
    let reference = reference(&LotkaVolterra, "lv", &[], &["1/2", "5/3"], 3.0, allowed).expect("a reference");
    let certificate = reference.certificate();
    assert!(matches!(certificate.method, Method::Composition { .. }), "{certificate:?}");
    assert!(certificate.difference > 0.0 && certificate.difference <= allowed, "{certificate:?}");

    // The sum of x − ln x over both variables is an integral of the flow.
    let energy = |x: Vec<Dd>| x.into_iter().map(f64::from).map(|x| x - x.ln()).sum::<f64>();
    let begin = energy(reference.flow().at(Dd::from(0.0)));
    for k in 1..=30 {
        assert!(
            (energy(reference.flow().at(Dd::from(f64::from(k) / 10.0))) - begin).abs() < 4e-15,
            "t = {k}/10"
        );
    }
    assert_eq!(reference.flow().end(), 3.0);
    assert!((1.66..5.0).contains(&reference.flow().scale()), "{}", reference.flow().scale());
}

#[test]
fn a_path_that_is_not_the_solution_is_refused() {
    let start = ["3/10", "2/5", "-1/5"];
    for (command, wrong) in [
        ("e5", reference(&E6, "e5", &[], &start, 1.0, 1e-9)),
        ("e6", reference(&E5, "e6", &[], &start, 1.0, 1e-9)),
        ("e7", reference(&E7 { xi: dd("1000001/1000000") }, "e7", &["1"], &start, 1.0, 1e-9)),
    ] {
        match wrong.map(|reference| reference.certificate()) {
            Err(NoReference::Disagree { difference, until, .. }) => {
                assert!(difference > 1e-9 && until < 0.1, "{command}: {difference:e} until {until}");
            }
            other => panic!("{command}: {other:?}"),
        }
    }
}

#[test]
fn a_point_that_is_no_number_is_infinitely_far() {
    let reference = reference(&E6, "e6", &[], &["3/10", "2/5", "-1/5"], 1.0, 1e-9).expect("a reference");
    let here = reference.flow().at(Dd::from(0.5));
    assert!(reference.distance(Dd::from(0.5), &here) < 1e-30);
    for i in 0..3 {
        let mut point = here.clone();
        point[i] = Dd::from(f64::NAN);
        assert_eq!(reference.distance(Dd::from(0.5), &point), f64::INFINITY);
        point[i] = here[i] + Dd::from(reference.flow().scale());
        assert!((reference.distance(Dd::from(0.5), &point) - 1.0).abs() < 1e-12);
    }
}

/// E1 has ẋ = −x², so x = 1/(t + 1/x₀) escapes at t = −1/x₀.
#[test]
fn a_solution_that_escapes_is_refused_with_its_time() {
    let refusal =
        reference(&E1, "e1", &[], &["-1/2", "1/3", "1"], 5.0, 1e-12).expect_err("it escapes at t = 2");
    let NoReference::Escapes { time } = refusal else { panic!("{refusal}") };
    assert!((time - 2.0).abs() < 1e-3, "{time}");
    assert!(
        refusal.to_string().contains("escapes to infinity, or beyond the largest double, near t = 2.0"),
        "{refusal}"
    );
}

#[test]
fn more_agreement_than_two_double_doubles_can_have_is_refused() {
    let refusal =
        reference(&LotkaVolterra, "lv", &[], &["1/2", "5/3"], 1.0, 1e-36).expect_err("beyond 32 digits");
    let NoReference::Disagree { difference, allowed, .. } = refusal else { panic!("{refusal}") };
    assert!(difference > allowed && difference < 1e-24, "{difference}");
    assert!(refusal.to_string().contains("1.0e-36"), "{refusal}");
}

kahan! {
    /// Field and Noyes' oregonator, which has a stiff relaxation oscillation.
    struct Oregonator;
    xdot = 77/2*(y - x*y + x - x^2/120000);
    ydot = (z - y - x*y)/77;
    zdot = 161/1000*(x - z);
}

kahan! {
    /// Robertson's kinetics. The variable y stays below 4·10⁻⁵, but determines the motion.
    struct Kinetics;
    xdot = -x/25 + 10000*y*z;
    ydot = x/25 - 10000*y*z - 30000000*y^2;
    zdot = 30000000*y^2;
}

#[test]
fn a_stiff_motion_is_certified_to_what_is_asked_for_and_not_far_beyond() {
    for allowed in [1e-5, 1e-8, 1e-14] {
        let reference = reference(&Oregonator, "", &[], &["4", "11/10", "4"], 2.0, allowed);
        let certificate = reference.expect("a reference").certificate();
        let Method::Composition { steps } = certificate.method else { panic!("{certificate:?}") };
        assert!(
            certificate.difference <= allowed && certificate.difference > 1e-6 * allowed,
            "{certificate:?}"
        );
        assert!(steps < 10_000, "{certificate:?}");
    }
}

#[test]
fn steps_that_are_too_long_are_not_taken_for_roundings() {
    let reference = reference(&Kinetics, "", &[], &["1", "0", "0"], 0.125, 1e-9).expect("a reference");
    let certificate = reference.certificate();
    assert!(certificate.difference <= 1e-9, "{certificate:?}");
}

/// The point (1, 2, 3) lies on the separatrix xz + y² = ½(x² + y² + z²) of E6, which leads to a
/// fixed point. Near the fixed point, errors grow like exp(2√7 t), so 32 digits last until t ≈ 13.
#[test]
fn a_separatrix_is_followed_as_far_as_32_digits_last() {
    let refusal = reference(&E6, "e6", &[], &["1", "2", "3"], 20.0, 1e-11).expect_err("too sensitive");
    let NoReference::Disagree { difference, until, .. } = refusal else { panic!("{refusal}") };
    assert!(difference > 0.1 && (6.0..14.0).contains(&until), "{difference}, {until}");
    assert!(refusal.to_string().contains("they agree until about t = "), "{refusal}");
    reference(&E6, "e6", &[], &["1", "2", "3"], 5.0, 1e-11).expect("a shorter horizon");
}

/// At a fixed point, the series is constant, and its radius of convergence is infinite.
#[test]
fn a_solution_that_rests_has_a_reference() {
    let reference = reference(&LotkaVolterra, "lv", &[], &["1", "1"], 100.0, 1e-20).expect("a reference");
    assert_eq!(reference.distance(Dd::from(57.0), &[Dd::from(1.0), Dd::from(1.0)]), 0.0);
    assert_eq!(reference.distance(Dd::from(57.0), &[Dd::from(1.5), Dd::from(1.0)]), 0.5);
    assert_eq!(reference.distance(Dd::from(57.0), &[Dd::from(f64::NAN), Dd::from(1.0)]), f64::INFINITY);
}
