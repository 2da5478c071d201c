//! Special values are found from the equations alone.

use kahan_algebra::rational::Rational;
use kahan_discover::{Axis, DiscoverError, Options, Scan, scan};

mod support;
use support::*;

fn scanned(text: &str, name: &str, from: i64, to: i64, step: Rational) -> Scan {
    let axis = Axis::range(name, &Rational::from(from), &Rational::from(to), &step).unwrap();
    let options = Options { seconds: 3600.0, ..Options::default() };
    scan(&system(text), &[axis], &options, &mut |_, _| {}).unwrap()
}

/// The values with as many integrals as this.
fn with_integrals(scan: &Scan, wanted: usize) -> Vec<Rational> {
    let chosen =
        scan.special().filter(|point| point.sight.as_ref().is_some_and(|sight| sight.integrals == wanted));
    chosen.map(|point| point.values[0].clone()).collect()
}

#[test]
fn the_parameters_that_join_integrable_fields_are_special() {
    let quarter = Rational::new(1, 4);
    // At 0 the field does not move y, and a second integral is left in the plane of x and z.
    let special = [Rational::from(-1), Rational::zero(), Rational::from(1)];
    let e7 = scanned(E7, "xi", -2, 2, quarter.clone());
    assert_eq!((e7.generic.integrals, e7.points.len(), e7.out_of_time), (0, 17, false));
    assert_eq!(with_integrals(&e7, 2), special);
    let e9 = scanned(E9, "xi", -2, 2, quarter);
    assert_eq!(with_integrals(&e9, 2), special);
    // Nothing is special at 3/4.
    assert!(e9.special().all(|point| point.values[0] != Rational::new(3, 4)));
}

#[test]
fn the_time_steps_of_lotka_volterra_are_special() {
    let found = scanned(LOTKA_VOLTERRA, "eps", -2, 2, Rational::new(1, 4));
    assert_eq!(with_integrals(&found, 1), [Rational::from(-1), Rational::from(1)]);
    // At eps = 0 the map is the identity.
    assert_eq!(with_integrals(&found, 2), [Rational::zero()]);
}

#[test]
fn grids_have_axes_and_names_are_checked() {
    let half = Rational::new(1, 2);
    let axis = |name: &str| Axis { name: name.to_owned(), values: vec![half.clone(), Rational::one()] };
    let mut calls = 0;
    let options = Options { seconds: 3600.0, ..Options::default() };
    let found = scan(&system(E7), &[axis("xi"), axis("eps")], &options, &mut |_, _| calls += 1).unwrap();
    assert_eq!((found.points.len(), calls), (4, 4));
    assert_eq!(found.points[1].values, [half.clone(), Rational::one()]);
    let error = scan(&system(E7), &[axis("zeta")], &options, &mut |_, _| {}).unwrap_err();
    assert_eq!(error, DiscoverError::UnknownParameter("zeta".to_owned()));
    assert!(Axis::range("xi", &half, &Rational::one(), &Rational::zero()).is_none());
    // A parameter that the field is divided by has a value without a map.
    let divided = scan(
        &system("xdot = y/a; ydot = x^2;"),
        &[Axis { name: "a".to_owned(), values: vec![Rational::zero(), Rational::one()] }],
        &options,
        &mut |_, _| {},
    );
    assert_eq!(divided.unwrap().points[0].sight, None);
}
