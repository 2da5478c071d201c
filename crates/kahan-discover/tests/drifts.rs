//! Tests of drifts, in fields with known drifts and in fields without any.

use kahan_discover::orbits::hilbert::default_degree;
use kahan_discover::{Options, Report, Unwatched, discover};

mod support;
use support::*;

fn report(text: &str, degree: Option<u32>) -> Report {
    let system = system(text);
    let degree = degree.or(Some(default_degree(system.field.dimension())));
    let options = Options { degree, iterates: 8, iterate_degree: 100, ..Options::default() };
    discover(&system, &options, &Unwatched).expect("there is a map")
}

fn drifts(text: &str, report: &Report) -> Vec<String> {
    check_lines(text, report);
    report.drifts.iter().map(|drift| drift.text.clone()).collect()
}

#[test]
fn drifts_are_found_where_they_are_known() {
    let cases: [(&str, &[&str]); 10] = [
        ("xdot = x^2;", &["drift F1 = 1/x by F1 - 2*eps;"]),
        ("xdot = a*x;", &["drift F1 = x by F1*(1 + eps*a)/(1 - eps*a);"]),
        ("xdot = 1 + x^2;", &["drift F1 = x by (F1 + 2*eps)/(1 - 2*eps*F1);"]),
        ("xdot = x^2 - 1;", &["drift F1 = (1 - x)/(1 + x) by F1*(1 + 2*eps)/(1 - 2*eps);"]),
        (
            "xdot = x + y; ydot = y;",
            &[
                "drift F1 = x/y by F1 + 2*eps/((1 + eps)*(1 - eps));",
                "drift F2 = y by F2*(1 + eps)/(1 - eps);",
            ],
        ),
        ("xdot = x^2 - y^2; ydot = 2*x*y;", &["drift F1 = x/(x^2 + y^2) by F1 - 2*eps;"]),
        ("xdot = 0; ydot = x*y;", &["drift F1 = y by F1*(1 + eps*H1)/(1 - eps*H1);"]),
        // The last three fields have no drifts, although the first two of them have integrals.
        ("xdot = -x*z; ydot = -y*z; zdot = x^2 + y^2;", &[]),
        ("xdot = y; ydot = 6*x^2 - a;", &[]),
        ("xdot = x*(1 - y); ydot = y*(x - 1);", &[]),
    ];
    for (text, expected) in cases {
        assert_eq!(drifts(text, &report(text, None)), expected, "{text}");
    }
}

#[test]
fn first_order_recurrences_are_found() {
    // For E8 and E7, the drifts are the recurrences in section 6 of Hone and Petrera.
    let e8 = "xdot = -x^2; ydot = -x*(x + y); zdot = 2*y*(x + y) + x*z;";
    let of_e8 = [
        "drift F1 = 1/x by F1 + 2*eps;",
        "drift F2 = y/x by F2 - 2*eps/(F1 + eps);",
        "drift F3 = z/x by F3*(F1 + 3*eps)/(F1 - eps) - 4*eps*(eps*(1 + F2 - F2^2) - F1*F2*(1 + F2))/((F1 + eps)*(F1 - eps));",
    ];
    let e7 = "struct E7 { xi } xdot = -x^2; ydot = -xi*x*y; zdot = 2*xi*y^2 + x*z;";
    let of_e7 = [
        "drift F1 = 1/x by F1 + 2*eps;",
        "drift F2 = y/x by F2*(F1 + eps*(2 - xi))/(F1 + eps*xi);",
        "drift F3 = z/x by F3*(F1 + 3*eps)/(F1 - eps) + 4*eps*xi*F2^2*(F1 + eps*(2 - xi))/((F1 - eps)*(F1 + eps*xi));",
    ];
    for (text, expected) in [(e8, of_e8), (e7, of_e7)] {
        assert_eq!(drifts(text, &report(text, Some(2))), expected, "{text}");
    }
}

#[test]
fn what_grows_evenly_is_said_in_words() {
    let words = |text: &str| {
        let sentences = report(text, None).sentences;
        sentences.into_iter().find(|sentence| sentence.starts_with("Every step adds")).expect(text)
    };
    assert_eq!(
        words("xdot = x^2;"),
        "Every step adds -2*eps to F1, so F1 + n*2*eps is constant, n the number of steps."
    );
    assert_eq!(
        words("struct S { n } xdot = n;"),
        "Every step adds 2*eps*n to F1, so F1 - k*2*eps*n is constant, k the number of steps."
    );
    assert!(
        words("xdot = -1; ydot = -3*y - 3;")
            .ends_with("along orbits F1/(-2*eps) - log|F2|/log|(1 - 3*eps)/(1 + 3*eps)| is constant.")
    );
    assert!(words("xdot = a*x; ydot = b*y;").ends_with(
        "along orbits log|F1|/log|(1 + eps*b)/(1 - eps*b)| - log|F2|/log|(1 + eps*a)/(1 - eps*a)| is constant."
    ));
}

#[test]
fn what_is_fixed_stands_behind_when() {
    let system = system("struct S { a } xdot = a*x;");
    let half = kahan_algebra::rational::Rational::new(1, 2);
    let options = Options {
        parameters: vec![("a".to_owned(), half.clone())],
        eps: Some(half),
        degree: Some(2),
        ..Options::default()
    };
    let report = discover(&system, &options, &Unwatched).expect("there is a map");
    let found: Vec<&str> = report.drifts.iter().map(|drift| drift.text.as_str()).collect();
    assert_eq!(found, ["drift F1 = x by 5*F1/3 when a = 1/2, eps = 1/2;"]);
}
