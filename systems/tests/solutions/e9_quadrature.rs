//! Compares the quadrature of E9 with closed solutions and with the differential equation.

use kahan_core::num_traits::Zero;
use kahan_core::prelude::*;
use kahan_systems::special::{Float256, Modulus, Real, integrate};
use kahan_systems::{E9, e9};

use crate::solutions::exact_orbits::{Point, assert_on_orbit, cases, orbit, precise};
use crate::solutions::measure::{assert_close, number, ten_to_minus};

fn start() -> Point<Float256> {
    Point::from(["3/7", "11/13", "23/47"].map(number))
}

#[test]
fn integrals_of_known_value() {
    let one = Float256::from_int(1);
    assert_close(&integrate(&Float256::zero(), &one, Real::exp).value, &one.exp_m1(), 74, "exp");
    // The integrand has a singularity at the left end.
    let root = integrate(&Float256::zero(), &one, |x: &Float256| one / x.sqrt()).value;
    assert_close(&root, &Float256::from_int(2), 37, "inverse root");
    let back = integrate(&one, &Float256::zero(), Real::exp).value;
    assert_close(&back, &-one.exp_m1(), 74, "backwards");
    assert!((integrate(&0.0, &1.0, |x: &f64| x.cos()).value - 1.0_f64.sin()).abs() < 4.0 * f64::EPSILON);
}

#[test]
fn the_quadrature_is_the_time_of_the_closed_cases() {
    for xi in ["2", "1/2", "1", "-1"].map(number) {
        let quadrature = e9::Quadrature::through(&xi, &start()).unwrap();
        let trajectory = e9::FlowSolution::through(&xi, &start()).unwrap();
        // At all these times z > 0; therefore x decreases.
        let times = ["0", "1/20", "1/6"].map(number);
        let points = times.each_ref().map(|t| trajectory.at(t));
        let clock = points.each_ref().map(|point| quadrature.time_from_largest(&point[0]));
        for i in 0..3 {
            assert!(points[i][2].is_positive());
            assert_close(
                &(clock[i] - clock[0] + times[0] + number("1")),
                &(times[i] + number("1")),
                60,
                "time",
            );
            for j in 0..3 {
                assert_close(&quadrature.point(&points[i][0])[j], &points[i][j], 70, "point");
            }
        }
    }
}

#[test]
fn the_period_of_e4_is_four_quarter_periods() {
    // For ξ = −1, E9 is E4, and x is a sum of multiples of dn and cn at λ(t + α).
    let quadrature = e9::Quadrature::through(&Float256::from_int(-1), &start()).unwrap();
    let e9::FlowSolution::MinusOne(closed) =
        e9::FlowSolution::through(&Float256::from_int(-1), &start()).unwrap()
    else {
        panic!("E9 with xi = -1 is E4")
    };
    let Modulus { k, .. } = &closed.modulus;
    assert!(k.is_positive());
    let expected = Float256::from_int(4) * closed.modulus.quarter_period() / closed.lambda;
    assert_close(&quadrature.period().unwrap(), &expected, 65, "period");
}

#[test]
fn the_time_of_a_generic_case_satisfies_the_differential_equation() {
    // For two values of h, central differences of t(x) approximate dt/dx = −1/(xz) up to O(h²).
    for xi in ["-1/2", "3/2", "-7/3", "5"].map(number) {
        let quadrature = e9::Quadrature::through(&xi, &start()).unwrap();
        let x = start()[0];
        let slope = |h: &Float256| {
            let difference =
                quadrature.time_from_largest(&(x + *h)) - quadrature.time_from_largest(&(x - *h));
            difference / (Float256::from_int(2) * *h)
        };
        let field = E9 { xi }.field(&start());
        let h = ten_to_minus(16);
        let coarse = slope(&(Float256::from_int(2) * h));
        let fine = slope(&h);
        // The extrapolated slope has an error near 10^(−64); rounding adds about 10^(−60).
        let extrapolated = fine + (fine - coarse) / Float256::from_int(3);
        assert_close(&(extrapolated * field[0]), &Float256::from_int(1), 50, "dt/dx");
    }
}

#[test]
fn fixed_points_are_fixed_and_on_the_sphere() {
    let radius = e9::sphere_radius(&start());
    for (xi, count) in [("2", 2), ("-1/2", 6), ("-7/3", 6)] {
        let points = e9::fixed_points(&number(xi), &radius);
        assert_eq!(points.len(), count);
        for point in points {
            assert_close(&e9::sphere_radius(&point), &radius, 74, "radius");
            let field = E9 { xi: number(xi) }.field(&point);
            assert!(field.iter().all(|value| value.abs() < ten_to_minus(74)), "{field}");
        }
    }
}

#[test]
fn a_small_closed_trajectory_has_the_period_of_the_linearisation() {
    // The fixed point (√(−ξ) a, a, 0) lies on the unit sphere if a²(1 − ξ) = 1. Small closed
    // trajectories around it have the frequency ω with ω² = 2(1−ξ)(−ξ)a².
    let xi = number("-1/2");
    let fixed = &e9::fixed_points(&xi, &number("1"))[2];
    let mut near = *fixed;
    near[2] += ten_to_minus(12);
    let period = e9::Quadrature::through(&xi, &near).unwrap().period().unwrap();
    let one = Float256::from_int(1);
    let square = Float256::from_int(2) * (one - xi) * -xi * fixed[1].square();
    let expected = Float256::from_int(2) * Float256::pi() / square.sqrt();
    assert_close(&period, &expected, 20, "period");
}

#[test]
fn the_map_is_solved_where_it_is_e3_e4_or_plane() {
    let mut compared = 0;
    for case in cases("e9") {
        for xi in ["0", "1", "-1"] {
            let solution = e9::Solution::through(
                &number(xi),
                &precise(&case.start),
                &Float256::from_rational(&case.eps),
            );
            let Ok(solution) = solution else { continue };
            let map = E9 { xi: crate::solutions::exact_orbits::rational(xi) };
            let exact = orbit(map, &case.start, &case.eps, [3, 5]);
            compared += assert_on_orbit(&exact, |n| solution.at(n), 50, &format!("E9, xi = {xi}"));
        }
    }
    assert!(compared > 200, "{compared}");
    assert!(e9::Solution::through(&number("2"), &start(), &number("1/2")).is_err());
}
