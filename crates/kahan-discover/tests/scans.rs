//! Tests scans of grids for special values.

use kahan_algebra::rational::Rational;
use kahan_algebra::{lexer, read};
use kahan_discover::{DiscoverError, Options, Scan, ScannedQuantity, Unwatched, scan};

mod support;
use support::*;

/// Returns an axis of a grid between two integers, with steps of 1/`parts`.
fn axis(name: &str, from: i64, to: i64, parts: i64) -> ScannedQuantity {
    let values = (from * parts..=to * parts).map(|above| Rational::new(above, parts)).collect();
    ScannedQuantity { name: name.to_owned(), values }
}

fn scanned(text: &str, name: &str) -> Scan {
    scan(&system(text), &[axis(name, -2, 2, 4)], &Options::default(), &Unwatched).unwrap()
}

fn with_integrals(scan: &Scan, wanted: usize) -> Vec<Rational> {
    let chosen =
        scan.special().filter(|point| point.sight.as_ref().is_some_and(|sight| sight.integrals == wanted));
    chosen.map(|point| point.values[0].clone()).collect()
}

#[test]
fn the_parameters_that_join_integrable_fields_are_special() {
    let special = [Rational::from(-1), Rational::zero(), Rational::from(1)];
    let e7 = scanned(E7, "xi");
    assert_eq!((e7.generic.integrals, e7.points.len(), e7.out_of_time), (0, 17, false));
    assert_eq!(with_integrals(&e7, 2), special);
    let e9 = scanned(E9, "xi");
    assert_eq!(with_integrals(&e9, 2), special);
    assert!(e9.special().all(|point| point.values[0] != Rational::new(3, 4)));
}

#[test]
fn the_time_steps_of_lotka_volterra_are_special() {
    let found = scanned(LOTKA_VOLTERRA, "eps");
    assert_eq!(with_integrals(&found, 1), [Rational::from(-1), Rational::from(1)]);
    assert_eq!(with_integrals(&found, 2), [Rational::zero()]);
}

#[test]
fn grids_have_axes_and_names_are_checked() {
    let half = Rational::new(1, 2);
    let axis =
        |name: &str| ScannedQuantity { name: name.to_owned(), values: vec![half.clone(), Rational::one()] };
    let options = Options::default();
    let found = scan(&system(E7), &[axis("xi"), axis("eps")], &options, &Unwatched).unwrap();
    assert_eq!(found.points.len(), 4);
    assert_eq!(found.points[1].values, [half.clone(), Rational::one()]);
    let error = scan(&system(E7), &[axis("zeta")], &options, &Unwatched).unwrap_err();
    assert_eq!(error, DiscoverError::UnknownParameter("zeta".to_owned()));
    let divided = scan(
        &system("xdot = y/a; ydot = x^2;"),
        &[ScannedQuantity { name: "a".to_owned(), values: vec![Rational::zero(), Rational::one()] }],
        &options,
        &Unwatched,
    );
    assert_eq!(divided.unwrap().points[0].sight, None);
}

fn on_grid(text: &str, names: &[&str], from: i64, to: i64) -> Scan {
    let axes: Vec<ScannedQuantity> = names.iter().map(|name| axis(name, from, to, 1)).collect();
    let watch = Recording::default();
    let found = scan(&system(text), &axes, &Options::default(), &watch).unwrap();
    let told: Vec<String> = watch.findings().into_iter().map(|finding| finding.text).collect();
    let said = found.relations.iter().flat_map(|relation| &relation.claims);
    assert_eq!(told, said.cloned().collect::<Vec<_>>(), "{text}");
    let total = found.points.len();
    let mut looks = watch.looks();
    looks.retain(|look| look.ends_with("points"));
    assert_eq!(looks, (0..=total).map(|done| format!("{done} of {total} points")).collect::<Vec<_>>());
    found
}

/// Returns each relation with the number of its points and of its claims. Asserts that the claims
/// hold under the relation, and fail without it.
fn relations<'a>(text: &str, scan: &'a Scan) -> Vec<(&'a str, usize, usize)> {
    let mistakes = |claim: &str| read(&lexer::lex(&format!("{text} {claim}")).tokens).diagnostics().to_vec();
    for claim in scan.relations.iter().flat_map(|proposal| &proposal.claims) {
        assert_eq!(mistakes(claim), [], "{claim}");
        assert!(!mistakes(&format!("{};", claim.split(" when ").next().unwrap())).is_empty(), "{claim}");
    }
    let all = scan.relations.iter().map(|proposal| {
        let ending = format!(" when {};", proposal.relation);
        assert!(proposal.claims.iter().all(|claim| claim.ends_with(&ending)), "{:?}", proposal.claims);
        (proposal.relation.as_str(), proposal.points, proposal.claims.len())
    });
    all.collect()
}

#[test]
fn linear_relations_are_proposed_and_proved() {
    let text = "xdot = x*(y - z) + a*y^2; ydot = y*(z - x) + b*y^2; zdot = z*(x - y) + c*y^2;";
    let found = on_grid(text, &["a", "b", "c"], -1, 1);
    assert_eq!(relations(text, &found), [("c = -a - b", 7, 1)]);
    assert_eq!(found.relations[0].claims, ["integral H1 = x + y + z when c = -a - b;"]);
    assert_eq!(found.relations[0].sight.integrals, 1);
    assert_eq!(relations(text, &on_grid(text, &["a", "b", "c"], 1, 2)), []);
    let text = "xdot = a*x*y - z*x; ydot = b*z*x + y^2; zdot = 0;";
    let found = on_grid(text, &["a", "b"], -3, 3);
    let names: Vec<&str> = relations(text, &found).into_iter().map(|(name, ..)| name).collect();
    assert!(names.contains(&"b = 0"), "{names:?}");
    assert!(found.relations.iter().flat_map(|known| &known.claims).all(|claim| !claim.contains("= z when")));
}

#[test]
fn products_are_proposed_and_proved() {
    let oscillators = "xdot = a1*a2*y; ydot = -a1*a2*x; udot = a5*a6*v; vdot = -a5*a6*u;";
    let found = on_grid(oscillators, &["a1", "a2", "a5", "a6"], 1, 4);
    assert_eq!(relations(oscillators, &found), [("a1*a2 = a5*a6", 32, 2)]);
    let volterra = "xdot = x*(c*y + z); ydot = y*(x + a*z); zdot = z*(b*x + y);";
    let found = on_grid(volterra, &["a", "b", "c"], -2, 2);
    assert_eq!(relations(volterra, &found), [("c*a*b = -1", 4, 2)]);
}

#[test]
fn what_is_only_seen_is_not_claimed() {
    let text = "xdot = x*(1 - y); ydot = y*(x - 1) + a*x^2;";
    let found = on_grid(text, &["a", "eps"], -4, 4);
    assert_eq!(relations(text, &found), [("eps = -1", 9, 0), ("eps = 1", 9, 0)]);
    assert_eq!(relations(text, &on_grid(text, &["a", "eps"], -2, 2)), []);
    assert_eq!(relations(E7, &on_grid(E7, &["xi"], -1, 1)), []);
}

#[test]
fn the_names_of_claims_are_free() {
    let text = "xdot = x*(y - z) + a*y^2; ydot = y*(z - x) + b*y^2; zdot = z*(x - y) + c*y^2; \
         integral H1 = x + y + z when a = -b - c;";
    let found = on_grid(text, &["a", "b", "c"], -1, 1);
    assert_eq!(relations(text, &found).len(), 1);
    assert_eq!(found.relations[0].claims, ["integral H2 = x + y + z when c = -a - b;"]);
}
