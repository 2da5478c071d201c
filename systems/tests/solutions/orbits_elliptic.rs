//! Compares the elliptic solutions of the maps of E4, E6 and the Euler top with exact orbits.

use kahan_core::prelude::*;
use kahan_systems::solution::{Branch, OutOfDomain};
use kahan_systems::special::{Float256, Jacobi, Real, jacobi};
use kahan_systems::{E4, E6, EulerTop, e4, e6, euler};

use crate::solutions::exact_orbits::{
    Case, Point, Rational, assert_on_orbit, cases, orbit, precise, rational, rounded, ulps,
};
use crate::solutions::measure::assert_close;

/// Returns cases on both branches with all signs of x, y, z and ε, also near |εz| = 1.
fn more() -> Vec<Case> {
    let mut all = Vec::new();
    let coordinates =
        [["3/2", "1/3", "3/5"], ["1/3", "3/2", "3/5"], ["3/2", "1/3", "5/2"], ["1/3", "3/2", "5/2"]];
    for coordinate in coordinates {
        for signs in 0..16 {
            let value = |i: usize| {
                let value = rational(if i == 3 { "1/2" } else { coordinate[i] });
                if signs >> i & 1 == 1 { -value } else { value }
            };
            all.push(Case {
                parameters: Vec::new(),
                eps: value(3),
                start: vector![value(0), value(1), value(2)],
            });
        }
    }
    let special = [
        ["3/2", "0", "3/5"],
        ["0", "3/2", "3/5"],
        ["-3/2", "0", "-5/2"],
        ["0", "3/2", "5/2"],
        ["0", "-3/2", "-5/2"],
        ["2/3", "2/3", "0"],
        ["2/3", "-2/3", "0"],
        ["2/3", "2/3", "1/7"],
        ["2/3", "1/7", "0"],
        ["1", "1/3", "1999999/1000000"],
        ["1", "1/3", "2000001/1000000"],
        ["1", "1/1000000", "1/3"],
    ];
    for point in special {
        let start = vector![rational(point[0]), rational(point[1]), rational(point[2])];
        all.push(Case { parameters: Vec::new(), eps: rational("1/2"), start });
    }
    all
}

/// Returns the argument v = 2δn + κ of the elliptic functions after n steps.
fn argument(solution: &e4::Solution<f64>, n: i64) -> f64 {
    2.0 * solution.delta * n as f64 + solution.kappa
}

#[test]
fn solutions_of_e4_are_the_orbits() {
    let (mut inner, mut outer, mut worst) = (0, 0, 0.0_f64);
    for case in cases("e4").into_iter().chain(more()) {
        let solution = e4::Solution::through(&precise(&case.start), &Float256::from_rational(&case.eps))
            .unwrap_or_else(|error| panic!("{}: {error}", case.start));
        let exact = orbit(E4, &case.start, &case.eps, [4, 6]);
        let compared = assert_on_orbit(&exact, |n| solution.at(n), 50, &format!("E4, {}", case.start));
        *(if solution.branch == Branch::Inner { &mut inner } else { &mut outer }) += compared;
        let float = rounded(&case);
        let solution = e4::Solution::through(&float.start, &float.eps).expect("in the domain");
        let units = ulps(E4, &float, 1.0, |n| argument(&solution, n), |n| solution.at(n));
        worst = worst.max(units);
    }
    assert!(inner > 500 && outer > 400, "{inner} and {outer} points");
    assert!(worst < 6.0, "{worst} ulp");
}

#[test]
fn parameters_of_e4_give_the_integrals() {
    let int = Float256::from_int;
    let mut inner = 0;
    for case in more() {
        let (start, eps) = (precise(&case.start), Float256::from_rational(&case.eps));
        let solution = e4::Solution::through(&start, &eps).unwrap();
        if solution.branch == Branch::Outer {
            continue;
        }
        inner += 1;
        let [h, k] = E4.integrals(&start, eps).into();
        let square = solution.modulus.k.square();
        let Jacobi { sn, cn, dn } = jacobi(&solution.delta, &solution.modulus);
        let (sn, cn, dn) = (sn.square(), cn.square(), dn.square());
        let top = (int(1) - square) * sn;
        let bottom = int(2) * eps.square() * (int(2) - (int(1) + square) * sn);
        assert_close(&(h.abs() * bottom), &top, 60, "H of E4");
        let expected = (Float256::half() - cn * dn / (cn + dn)) / eps.square();
        assert_close(&k, &expected, 60, "K of E4");
    }
    assert!(inner >= 10, "{inner} cases");
}

#[test]
fn e6_is_an_euler_top_and_e4_another_exactly() {
    let int = |n: i64| Rational::from_integer(n.into());
    let top = |a: [i64; 3]| EulerTop { a1: int(a[0]), a2: int(a[1]), a3: int(a[2]) };
    for case in cases("e6") {
        let [x, y, z] = case.start.clone().into();
        let map = |p: &Point<Rational>| vector![&p[0] - &p[2], &p[0] + &p[2], p[1].clone()];
        let left = map(&E6.step(&case.start, case.eps.clone()));
        assert_eq!(left, top([1, -3, 1]).step(&map(&case.start), case.eps.clone()));
        let map = |p: &Point<Rational>| vector![&p[0] - &p[1], &p[0] + &p[1], p[2].clone()];
        let left = map(&E4.step(&vector![x.clone(), y.clone(), z.clone()], case.eps.clone()));
        assert_eq!(left, top([-1, -1, 1]).step(&map(&vector![x, y, z]), case.eps.clone()));
    }
}

#[test]
fn solutions_of_e6_are_the_orbits() {
    let (mut compared, mut in_floats, mut worst) = (0, 0, 0.0_f64);
    for case in cases("e6").into_iter().chain(more()) {
        let solution = e6::Solution::through(&precise(&case.start), &Float256::from_rational(&case.eps));
        let solution = match solution {
            Ok(solution) => solution,
            Err(OutOfDomain { condition }) => {
                let scaled = &case.eps * (&case.start[0] + &case.start[2]);
                assert!(condition == "eps^2 z^2 != 1" && &scaled * &scaled == rational("1"), "{condition}");
                continue;
            }
        };
        let exact = orbit(E6, &case.start, &case.eps, [4, 6]);
        compared += assert_on_orbit(&exact, |n| solution.at(n), 50, &format!("E6, {}", case.start));
        let float = rounded(&case);
        let Ok(solution) = e6::Solution::through(&float.start, &float.eps) else { continue };
        let units = ulps(E6, &float, 2.0, |n| argument(&solution.top.orbit, n), |n| solution.at(n));
        worst = worst.max(units);
        in_floats += 1;
    }
    assert!(compared > 700 && in_floats > 40, "{compared}, {in_floats} in floats");
    assert!(worst < 6.0, "{worst} ulp");
}

fn top<T: Scalar>(a: &[T]) -> EulerTop<T> {
    EulerTop { a1: a[0].clone(), a2: a[1].clone(), a3: a[2].clone() }
}

#[test]
fn solutions_of_the_euler_top_are_the_orbits() {
    let (mut compared, mut refused, mut worst) = (0, 0, 0.0_f64);
    let mut all = cases("euler");
    for (i, mut case) in more().into_iter().enumerate() {
        let coefficients =
            [["1/2", "-2/3", "5/4"], ["-3", "-1", "2/7"], ["1", "2", "-5"], ["-1/9", "4", "2"]];
        case.parameters = coefficients[i % 4].map(rational).to_vec();
        all.push(case);
    }
    for case in all {
        let zero = rational("0");
        let signs = case.parameters.iter().filter(|&a| a > &zero).count();
        let nonzero = case.parameters.iter().all(|a| a != &zero);
        let coefficients = [0, 1, 2].map(|i| Float256::from_rational(&case.parameters[i]));
        let eps = Float256::from_rational(&case.eps);
        let Ok(solution) = euler::Solution::through(&coefficients, &precise(&case.start), &eps) else {
            assert!(!nonzero || signs == 0 || signs == 3, "{}", case.start);
            refused += 1;
            continue;
        };
        let exact = orbit(top(&case.parameters), &case.start, &case.eps, [3, 5]);
        compared += assert_on_orbit(&exact, |n| solution.at(n), 50, &format!("Euler, {}", case.start));
        let float = rounded(&case);
        let coefficients = [float.parameters[0], float.parameters[1], float.parameters[2]];
        let solution =
            euler::Solution::through(&coefficients, &float.start, &float.eps).expect("in the domain");
        let rate = coefficients.iter().fold(0.0_f64, |rate, a| rate.max(a.abs()));
        let units = ulps(
            top(&coefficients.map(Float256::from)),
            &float,
            rate,
            |n| argument(&solution.orbit, n),
            |n| solution.at(n),
        );
        worst = worst.max(units);
    }
    assert!(compared > 700 && refused == 4, "{compared} points, {refused} tops refused");
    assert!(worst < 16.0, "{worst} ulp");
}
