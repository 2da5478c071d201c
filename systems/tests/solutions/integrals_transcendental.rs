//! Tests the transcendental integrals of the maps of E7 and E8, and the digamma bracket.

use kahan_core::prelude::*;
use kahan_systems::special::{Float256, Real};
use kahan_systems::{E1, E2, E7, E8, e7, e8};

use crate::solutions::exact_orbits::{Point, cases, orbit, precise, rational};
use crate::solutions::measure::{assert_close, assert_close_above, number, ten_to_minus};

fn paper() -> (Point<Float256>, Float256) {
    (Point::from(["3/7", "11/13", "23/47"].map(number)), number("1/2"))
}

/// Returns points whose orbits stay at x > 0, and one whose orbit passes from x < 0 to x > 0.
fn starts() -> Vec<(Point<BigRational>, BigRational)> {
    [("1/2", ["3/7", "11/13", "23/47"]), ("1/5", ["2/3", "-5/4", "7/9"]), ("1/3", ["-5/13", "2/5", "1"])]
        .map(|(eps, point)| (Point::from(point.map(rational)), rational(eps)))
        .into()
}

#[test]
fn values_at_the_point_of_the_paper() {
    // The values are from mpmath 1.3 at 80 digits: the integrals H by `gamma` and `digamma`, K7 by
    // `hyper` (the 4F3 at 1), and K8 by summation and the Abel-Plana formula (`quad`).
    let (start, eps) = paper();
    let xi = number("19/17");
    let h = e7::integral_h(&xi, &start, &eps);
    assert_close(&h, &number("2.18319135445432058268361453433172771594065472759015729716269"), 57, "H7");
    let k = e7::integral_k(&xi, &start, &eps).unwrap();
    assert_close(&k, &number("0.969813458916686255401322482798752855412245122117085849535125"), 57, "K7");
    assert_close(
        &e8::integral_h(&start, &eps),
        &number("2.82908410714125857287708671789420928778151745055807239222547"),
        57,
        "H8",
    );
    let k = e8::integral_k(&start, &eps).unwrap();
    assert_close(&k, &number("0.961999693511117684366704402090088418757481115166269850732003"), 57, "K8");
}

#[test]
fn integrals_agree_with_the_tables_of_the_map() {
    // The files in tests/data have entries `H_eps_decimal` with at least 40 digits.
    for system in ["e7", "e8"] {
        let path = format!("{}/../tests/data/{system}.json", env!("CARGO_MANIFEST_DIR"));
        let data: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
        let tables = data["cases"].as_array().unwrap();
        let mut compared = 0;
        for (case, table) in cases(system).iter().zip(tables) {
            let Some(expected) = table["H_eps_decimal"].as_str() else { continue };
            let (start, eps) = (precise(&case.start), Float256::from_rational(&case.eps));
            let value = match &case.parameters[..] {
                [xi] => e7::integral_h(&Float256::from_rational(xi), &start, &eps),
                _ => e8::integral_h(&start, &eps),
            };
            assert_close_above(&value, &number(expected), 35, &ten_to_minus(30), system);
            compared += 1;
        }
        assert!(compared >= 5, "{system}: {compared}");
    }
}

#[test]
fn integrals_are_constant_on_exact_orbits() {
    for (start, eps) in starts() {
        let precise_eps = Float256::from_rational(&eps);
        for xi in ["19/17", "1/3", "5/2", "2"] {
            let value = number(xi);
            let points = orbit(E7 { xi: rational(xi) }, &start, &eps, [4, 6]);
            let of = |point: &Point<BigRational>| {
                let point = precise(point);
                (
                    e7::integral_h(&value, &point, &precise_eps),
                    e7::integral_k(&value, &point, &precise_eps).unwrap(),
                )
            };
            let (h, k) = of(&points[0].1);
            for (_, point) in &points[1..] {
                assert_close(&of(point).0, &h, 65, &format!("H7, xi = {xi}, {start} to {point}"));
                assert_close_above(&of(point).1, &k, 60, &number("1"), "K7");
            }
        }
        let points = orbit(E8, &start, &eps, [4, 6]);
        let of = |point: &Point<BigRational>| {
            let point = precise(point);
            (e8::integral_h(&point, &precise_eps), e8::integral_k(&point, &precise_eps).unwrap())
        };
        let (h, k) = of(&points[0].1);
        for (_, point) in &points[1..] {
            assert_close(&of(point).0, &h, 65, "H8");
            assert_close_above(&of(point).1, &k, 60, &number("1"), "K8");
        }
    }
}

#[test]
fn special_cases_are_the_integrals_of_e1_and_e2() {
    let int = Float256::from_int;
    for (start, eps) in starts() {
        let (start, eps) = (precise(&start), Float256::from_rational(&eps));
        let one = E1.integrals(&start, eps);
        assert_close(&e7::integral_h(&int(1), &start, &eps), &one[0], 74, "H1");
        assert_close(&e7::integral_k(&int(1), &start, &eps).unwrap(), &one[1], 68, "K1");
        let two = E2.integrals(&start, eps);
        let scaled = int(4) * eps.square() * two[0];
        assert_close(&e7::integral_h(&int(-1), &start, &eps), &scaled, 74, "H2");
        assert!(e7::integral_k(&int(-1), &start, &eps).is_err());
        let negated = E1.bracket_P(&start, eps).map(|value| -value);
        assert_same(&e7::bracket_of_h(&int(1), &start, &eps), &negated);
        let negated = E2.bracket_P(&start, eps).map(|value| -value);
        assert_same(&e7::bracket_of_h(&int(-1), &start, &eps), &negated);
    }
}

#[track_caller]
fn assert_same(value: &SMatrix<Float256, 3, 3>, expected: &SMatrix<Float256, 3, 3>) {
    for (value, expected) in value.iter().zip(expected.iter()) {
        assert_close_above(value, expected, 65, &ten_to_minus(6), "bracket");
    }
}

#[test]
fn the_digamma_bracket_is_invariant_and_has_its_casimir() {
    for (start, eps) in starts() {
        let (start, eps) = (precise(&start), Float256::from_rational(&eps));
        for xi in ["19/17", "-1/2", "2/3", "-7/3"].map(number) {
            let map = E7 { xi };
            let jacobian = map.jacobian(&start, eps);
            let moved = jacobian * e7::bracket_of_h(&xi, &start, &eps) * jacobian.transpose();
            let next = map.step(&start, eps);
            assert_same(&e7::bracket_of_h(&xi, &next, &eps), &moved);
            // The bracket P must satisfy P ∇H = 0. Central differences and one Richardson
            // extrapolation give ∇H.
            let gradient = Point::from([0, 1, 2].map(|i| {
                let slope = |h: Float256| {
                    let along = |sign: i64| {
                        let mut point = start;
                        point[i] += Float256::from_int(sign) * h;
                        e7::integral_h(&xi, &point, &eps)
                    };
                    (along(1) - along(-1)) / (Float256::from_int(2) * h)
                };
                let (fine, coarse) =
                    (slope(ten_to_minus(14)), slope(Float256::from_int(2) * ten_to_minus(14)));
                fine + (fine - coarse) / Float256::from_int(3)
            }));
            let flow = e7::bracket_of_h(&xi, &start, &eps) * gradient;
            assert!(flow.iter().all(|value| value.abs() < ten_to_minus(45)), "{flow}");
        }
    }
}

#[test]
fn floats_reach_their_precision() {
    // The errors are relative to 256-bit arithmetic at the same floats, in units of 2⁻⁵².
    let (mut worst_h, mut worst_k) = (0.0_f64, 0.0_f64);
    for (start, eps) in starts() {
        let float = start.map(|value| <f64 as Real>::from_rational(&value));
        let eps = <f64 as Real>::from_rational(&eps);
        let (start, precise_eps) = (float.map(Float256::from), Float256::from(eps));
        for xi in [1.25, 0.3125, 2.5] {
            let precise_xi = Float256::from(xi);
            let pairs = [
                (e7::integral_h(&xi, &float, &eps), e7::integral_h(&precise_xi, &start, &precise_eps)),
                (e8::integral_h(&float, &eps), e8::integral_h(&start, &precise_eps)),
            ];
            for (value, expected) in pairs {
                worst_h = worst_h.max(crate::solutions::measure::ulps_above(value, &expected, 0.0));
            }
            let pairs = [
                (e7::integral_k(&xi, &float, &eps), e7::integral_k(&precise_xi, &start, &precise_eps)),
                (e8::integral_k(&float, &eps), e8::integral_k(&start, &precise_eps)),
            ];
            for (value, expected) in pairs {
                worst_k = worst_k.max(crate::solutions::measure::ulps_above(
                    value.unwrap(),
                    &expected.unwrap(),
                    0.0,
                ));
            }
        }
    }
    println!("H: {worst_h:.1} ulp, K: {worst_k:.1} ulp");
    assert!(worst_h < 48.0 && worst_k < 64.0, "H {worst_h} ulp, K {worst_k} ulp");
}
