//! Tests integrals by polarisation and rotation (see `Rule`), which need no search.

use kahan_algebra::rational::Rational;
use kahan_discover::{Options, Report, discover};

mod support;
use support::*;

const FIRST_STAGE: &str = "linear and quadratic integrals of the flow";

fn lines(report: &Report) -> Vec<&str> {
    report.integrals.iter().map(|formula| formula.text.as_str()).collect()
}

/// Checks the integrals up to degree 2. `FIRST_STAGE` must find the first `at_once` of them.
fn check(text: &str, options: Options, at_once: usize, expected: &[&str]) {
    let options = Options { degree: Some(2), iterates: 4, seconds: 3600.0, ..options };
    let report = discover(&system(text), &options, &Recording::default()).expect("there is a map");
    assert_eq!(lines(&report), expected, "{text}");
    system(&format!("{text} {}", claims(&report).join(" ")));
    let first = Recording::default().ending_after(at_once);
    discover(&system(text), &options, &first).expect("there is a map");
    assert_eq!(first.findings().len(), at_once, "{text}");
    assert!(first.looks().iter().all(|stage| stage == FIRST_STAGE), "{text}");
}

const PENDULUM: &str = "xdot = p; pdot = -g/l*s; sdot = c*p; cdot = -s*p;";

#[test]
fn lifted_fields_show_relations_and_energies_at_once() {
    let usual = Options::default;
    let van_der_pol = "xdot = y; ydot = mu*(y - w*y) - x; wdot = 2*x*y;";
    check(van_der_pol, usual(), 1, &["integral H1 = w - x^2 + eps^2*y^2;"]);
    let energy = "integral H1 = 2*g*l*c - l^2*p^2 + eps^2*g^2*s^2;";
    check(PENDULUM, usual(), 1, &[energy, "integral H2 = (s^2 + c^2)/(1 + eps^2*p^2);"]);
    let morse = "integral H1 = 4*u - 2*v - p^2 + 4*eps^2*(u - v)^2;";
    check("xdot = p; pdot = 2*v - 2*u; udot = -u*p; vdot = -2*v*p;", usual(), 1, &[morse]);
    let toda = "p1dot = -a; p2dot = a - b; p3dot = b; adot = a*(p1 - p2); bdot = b*(p2 - p3);";
    let energy = "integral H2 = 2*a + 2*b + p1^2 + p2^2 + p3^2 - 2*eps^2*(a^2 - a*b + b^2);";
    check(toda, usual(), 2, &["integral H1 = p1 + p2 + p3;", energy]);
    // Kepler's problem for the position (x, y), the velocity (p, q) and r² = x² + y². The lift has
    // a = r⁻³, b = (xp + yq)/r², c = (p² + q²)/r², F = ax, G = ay, u = −1/r.
    let kepler = "xdot = p; ydot = q; pdot = -F; qdot = -G; adot = -3*a*b; bdot = c - 2*b^2 - a; \
        cdot = -2*b*(a + c); Fdot = a*p - 3*b*F; Gdot = a*q - 3*b*G; udot = F*p + G*q;";
    let energy = "integral H1 = 2*u + p^2 + q^2 - eps^2*(F^2 + G^2);";
    check(kepler, usual(), 1, &[energy, "integral H2 = (p*G - q*F)/a;"]);
}

#[test]
fn what_is_fixed_is_put_into_the_rules() {
    let eps = Some(Rational::new(1, 2));
    let parameters = vec![("g".to_owned(), Rational::from(3))];
    let expected = [
        "integral H1 = 9*s^2 + 24*l*c - 4*l^2*p^2 when g = 3, eps = 1/2;",
        "integral H2 = (s^2 + c^2)/(4 + p^2) when g = 3, eps = 1/2;",
    ];
    check(PENDULUM, Options { eps, parameters, ..Options::default() }, 1, &expected);
}

#[test]
fn long_chains_show_theirs_at_once() {
    let n = 50;
    let site = |i: usize| {
        let (left, right) = ((i + n - 1) % n, (i + 1) % n);
        format!(
            "x{i}dot = p{i}; p{i}dot = x{left} - 2*x{i} + x{right} - g*s{i}; s{i}dot = c{i}*p{i}; c{i}dot = -s{i}*p{i};"
        )
    };
    let chain: Vec<String> = (0..n).map(site).collect();
    let watch = Recording::default().ending_after(n);
    let report = discover(&system(&chain.join(" ")), &Options::default(), &watch).expect("there is a map");
    assert_eq!(watch.findings().len(), n);
    assert!(watch.looks().iter().all(|stage| stage == FIRST_STAGE));
    let lines = lines(&report);
    let (energy, rotations) = lines.split_last().expect("there are integrals");
    assert!(energy.starts_with("integral H1 = 2*x0^2 - 2*x0*x1 - 2*x0*x49 + p0^2 - 2*g*c0 + 2*x1^2"));
    assert_eq!(rotations.len(), n);
    for (i, line) in rotations.iter().enumerate() {
        assert_eq!(*line, format!("integral H{} = (s{i}^2 + c{i}^2)/(1 + eps^2*p{i}^2);", i + 2));
    }
}

/// For the Euler top, integrals with a common denominator are preferred to those by rotation.
#[test]
fn integrals_with_one_denominator_come_before_those_of_rotations() {
    check(
        EULER,
        Options::default(),
        0,
        &[
            "integral H1 = (a3*x^2 - a1*z^2)/(1 - eps^2*a2*a3*x^2);",
            "integral H2 = (a2*x^2 - a1*y^2)/(1 - eps^2*a2*a3*x^2);",
        ],
    );
}
