//! Tests to 40 digits that solutions of the flows satisfy the differential equations, with central
//! differences of order 12 and h = 10^(−6).

use kahan_core::num_traits::Zero;
use kahan_core::prelude::*;
use kahan_systems::special::{Float256, Real};
use kahan_systems::{
    E1, E2, E3, E4, E5, E6, E7, E8, E9, EulerTop, e1, e2, e3, e4, e5, e6, e7, e8, e9, euler,
};

use crate::solutions::exact_orbits::{Point, norm};
use crate::solutions::measure::{number, ten_to_minus};

/// Returns f′(t) ≈ (1/h) Σ_{k=1}^{6} (−1)^{k+1} (6!)²/(k (6−k)! (6+k)!) (f(t+kh) − f(t−kh)), where
/// f is `at`.
fn derivative(at: &impl Fn(&Float256) -> Point<Float256>, t: &Float256) -> Point<Float256> {
    let h = ten_to_minus(6);
    let mut weight = Float256::from_int(-1);
    let mut sum = vector![Float256::zero(), Float256::zero(), Float256::zero()];
    for k in 1..=6 {
        weight *= -Float256::from_ratio(7 - k, 6 + k);
        let step = Float256::from_int(k) * h;
        let difference = at(&(*t + step)) - at(&(*t - step));
        let scale = weight / (Float256::from_int(k) * h);
        sum += difference.map(|value| value * scale);
    }
    sum
}

/// Asserts that the trajectory begins at the given point and satisfies the differential equation.
fn assert_solves(
    field: &impl QuadraticField<Float256, 3>,
    start: &Point<Float256>,
    at: impl Fn(&Float256) -> Point<Float256>,
    what: &str,
) {
    let close = |value: &Point<Float256>, expected: &Point<Float256>, digits: i64, what: &str| {
        let error = norm(&(*value - *expected));
        assert!(error <= ten_to_minus(digits) * norm(expected), "{what}: {value} for {expected}");
    };
    close(&at(&Float256::zero()), start, 60, what);
    for t in ["0", "1/3", "-2/11"].map(number) {
        close(&derivative(&at, &t), &field.field(&at(&t)), 45, &format!("{what} from {start} at t = {t}"));
    }
}

/// Returns points in all octants and of several sizes, without poles near the tested times.
fn points() -> Vec<Point<Float256>> {
    let coordinates = [["3/7", "11/13", "23/47"], ["7/3", "11/13", "8/5"], ["5/3", "1/9", "17/6"]];
    (0..8)
        .map(|signs| {
            let coordinate = coordinates[signs % 3];
            Point::from([0, 1, 2].map(|i| {
                let value = number(coordinate[i]);
                if signs >> i & 1 == 1 { -value } else { value }
            }))
        })
        .collect()
}

#[test]
fn table_5_solves_e1_to_e5() {
    for start in points() {
        let solution = e1::FlowSolution::through(&start).unwrap();
        assert_solves(&E1, &start, |t| solution.at(t), "E1");
        let solution = e2::FlowSolution::through(&start).unwrap();
        assert_solves(&E2, &start, |t| solution.at(t), "E2");
        let solution = e3::FlowSolution::through(&start).unwrap();
        assert_solves(&E3, &start, |t| solution.at(t), "E3");
        let solution = e4::FlowSolution::through(&start).unwrap();
        assert_solves(&E4, &start, |t| solution.at(t), "E4");
        let solution = e5::FlowSolution::through(&start).unwrap();
        assert_solves(&E5, &start, |t| solution.at(t), "E5");
    }
}

#[test]
fn e4_is_solved_on_the_planes_and_at_its_fixed_points() {
    for point in [["0", "2/3", "1/5"], ["-2/3", "0", "1/5"], ["0", "-2/3", "-1/5"]] {
        let start: Point<Float256> = Point::from(point.map(number));
        let solution = e4::FlowSolution::through(&start).unwrap();
        assert_solves(&E4, &start, |t| solution.at(t), "E4");
    }
    let fixed: Point<Float256> = Point::from(["2/3", "-2/3", "0"].map(number));
    let solution = e4::FlowSolution::through(&fixed).unwrap();
    assert_eq!(solution.at(&number("17/5")), fixed);
    assert!(e4::FlowSolution::through(&Point::from(["0", "0", "1"].map(number))).is_err());
}

#[test]
fn e6_and_the_euler_tops_are_solved() {
    let int = Float256::from_int;
    for start in points() {
        let solution = e6::FlowSolution::through(&start).unwrap();
        assert_solves(&E6, &start, |t| solution.at(t), "E6");
        for [a1, a2, a3] in [[1, -3, 1], [-2, -1, 3], [4, -1, -2], [1, 2, -5]] {
            let solution = euler::FlowSolution::through(&[int(a1), int(a2), int(a3)], &start).unwrap();
            let top = EulerTop { a1: int(a1), a2: int(a2), a3: int(a3) };
            assert_solves(&top, &start, |t| solution.at(t), "the Euler top");
        }
    }
    let condition = |a: [f64; 3]| euler::Reduction::of(&a).map_err(|error| error.condition);
    assert_eq!(condition([1.0, 2.0, 3.0]), Err("a1, a2, a3 of different signs"));
    assert_eq!(condition([-1.0, 2.0, 0.0]), Err("a1, a2, a3 != 0"));
}

#[test]
fn table_5_solves_e7_and_e8() {
    for start in points() {
        for xi in ["19/17", "-1/2", "0", "3"].map(number) {
            let solution = e7::FlowSolution::through(&xi, &start).unwrap();
            assert_solves(&E7 { xi }, &start, |t| solution.at(t), "E7");
        }
        let solution = e8::FlowSolution::through(&start).unwrap();
        assert_solves(&E8, &start, |t| solution.at(t), "E8");
    }
}

#[test]
fn beyond_its_pole_a_trajectory_is_no_number() {
    let start = vector![0.5, 1.0, 1.0];
    let before = e7::FlowSolution::through(&2.0, &start).unwrap().at(&-1.5);
    assert!(before.iter().all(|value| value.is_finite()));
    for t in [-2.0, -2.5] {
        let beyond = [
            e7::FlowSolution::through(&2.0, &start).unwrap().at(&t),
            e8::FlowSolution::through(&start).unwrap().at(&t),
        ];
        assert!(beyond.iter().all(|point| !point[1].is_finite() && !point[2].is_finite()), "{t}");
    }
}

#[test]
fn the_closed_cases_of_e9_are_solved() {
    for start in points() {
        for xi in ["2", "1/2", "1", "-1", "0"].map(number) {
            let solution = e9::FlowSolution::through(&xi, &start).unwrap();
            assert_solves(&E9 { xi }, &start, |t| solution.at(t), "E9");
        }
    }
    assert!(e9::FlowSolution::through(&number("3"), &points()[0]).is_err());
}
