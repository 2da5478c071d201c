//! Compares the hyperbolic solutions of the maps of E3 and E5 on both branches with exact orbits.

use kahan_core::prelude::*;
use kahan_systems::solution::{Branch, OutOfDomain};
use kahan_systems::special::{Float256, Real};
use kahan_systems::{E3, E5, e3, e5};

use crate::solutions::exact_orbits::{
    Case, Point, Rational, Rounded, assert_on_orbit, cases, orbit, precise, rational, rounded, ulps,
};
use crate::solutions::measure::assert_close;

fn more() -> Vec<Case> {
    let points = [
        ("1/2", ["3/2", "1/3", "5/2"]),
        ("1/2", ["3/2", "-1/3", "-5/2"]),
        ("-1/2", ["-3/2", "7/3", "5/2"]),
        ("1/3", ["1/7", "-10/3", "1/5"]),
        ("1/3", ["-1/7", "10/3", "2"]),
        ("-1/3", ["2/7", "10/3", "-1/9"]),
        ("1/2", ["5/3", "1/7", "2000001/1000000"]),
        ("1/2", ["5/3", "1999999/1000000", "1/5"]),
        ("1/1000", ["5/3", "1/7", "-2/5"]),
    ];
    let build = |(eps, [x, y, z]): (&str, [&str; 3])| Case {
        parameters: Vec::new(),
        eps: rational(eps),
        start: vector![rational(x), rational(y), rational(z)],
    };
    points.map(build).into()
}

/// Returns the argument T = 2δn + κ of the hyperbolic functions after n steps.
fn argument(delta: f64, kappa: f64, n: i64) -> f64 {
    2.0 * delta * n as f64 + kappa
}

type Exact = Vec<(i64, Point<Rational>)>;

/// Checks a solution in 256 bits to 50 digits. Returns the largest error in `f64`, in ulp.
fn run(
    system: &str,
    exact: impl Fn(&Case) -> Exact,
    precise_at: impl Fn(&Case) -> Result<(Branch, Box<dyn Fn(i64) -> Point<Float256>>), OutOfDomain>,
    float_error: impl Fn(&Rounded) -> Result<f64, OutOfDomain>,
) -> f64 {
    let (mut inner, mut outer, mut worst) = (0, 0, 0.0_f64);
    for case in cases(system).into_iter().chain(more()) {
        let Ok((branch, at)) = precise_at(&case) else { continue };
        let compared = assert_on_orbit(&exact(&case), at, 50, &format!("{system}, {}", case.start));
        *(if branch == Branch::Inner { &mut inner } else { &mut outer }) += compared;
        let float = rounded(&case);
        let units = float_error(&float).expect("rounding keeps the case in the domain");
        worst = worst.max(units);
    }
    assert!(inner > 60 && outer > 60, "{inner} and {outer} points");
    worst
}

#[test]
fn solutions_of_e3_are_the_orbits() {
    let worst = run(
        "e3",
        |case| orbit(E3, &case.start, &case.eps, [6, 9]),
        |case| {
            let solution = e3::Solution::through(&precise(&case.start), &Float256::from_rational(&case.eps))?;
            Ok((solution.branch, Box::new(move |n| solution.at(n))))
        },
        |case| {
            let solution = e3::Solution::through(&case.start, &case.eps)?;
            Ok(ulps(E3, case, 1.0, |n| argument(solution.delta, solution.kappa, n), |n| solution.at(n)))
        },
    );
    assert!(worst < 4.0, "{worst} ulp");
}

#[test]
fn solutions_of_e5_are_the_orbits() {
    let worst = run(
        "e5",
        |case| orbit(E5, &case.start, &case.eps, [6, 9]),
        |case| {
            let solution = e5::Solution::through(&precise(&case.start), &Float256::from_rational(&case.eps))?;
            Ok((solution.branch, Box::new(move |n| solution.at(n))))
        },
        |case| {
            let solution = e5::Solution::through(&case.start, &case.eps)?;
            Ok(ulps(E5, case, 1.0, |n| argument(solution.delta, solution.kappa, n), |n| solution.at(n)))
        },
    );
    assert!(worst < 4.0, "{worst} ulp");
}

#[test]
fn parameters_give_the_integrals() {
    let int = Float256::from_int;
    for case in more() {
        let (start, eps) = (precise(&case.start), Float256::from_rational(&case.eps));
        let [h, k] = E3.integrals(&start, eps).into();
        let e3::Solution { delta, theta, branch, .. } = e3::Solution::through(&start, &eps).unwrap();
        let tanh = if branch == Branch::Inner { delta.tanh() } else { int(1) / delta.tanh() };
        assert_close(&h, &(theta.sin() / theta.cos()), 70, "H of E3");
        assert_close(&k, &(tanh.square() / (int(2) * eps.square())), 68, "K of E3");

        let [h, k] = E5.integrals(&start, eps).into();
        let e5::Solution { delta, mu, branch, .. } = e5::Solution::through(&start, &eps).unwrap();
        let (tanh, factor) = match branch {
            Branch::Inner => (delta.tanh(), delta.sinh()),
            Branch::Outer => (int(1) / delta.tanh(), delta.cosh()),
        };
        assert_close(&h, &(tanh.square() / (int(2) * eps.square())), 68, "H of E5");
        assert_close(&k, &(mu * factor / eps + (tanh / eps).square()), 64, "K of E5");
    }
}

#[test]
fn degenerate_points_are_errors() {
    let at = |x: f64, y: f64, z: f64| vector![x, y, z];
    let condition = |error: OutOfDomain| error.condition;
    let e3 = |point| e3::Solution::through(&point, &0.5).map_err(condition).map(|solution| solution.branch);
    assert_eq!(e3(at(0.0, 0.0, 1.0)), Err("x^2 + y^2 > 0"));
    assert_eq!(e3(at(1.0, 1.0, 2.0)), Err("eps^2 z^2 != 1"));
    assert_eq!(e3(at(1.0, 1.0, -2.0)), Err("eps^2 z^2 != 1"));
    assert_eq!(e3(at(1.0, 1.0, -3.0)), Ok(Branch::Outer));
    let e5 = |point| e5::Solution::through(&point, &0.5).map_err(condition).map(|solution| solution.branch);
    assert_eq!(e5(at(0.0, 1.0, 1.0)), Err("x != 0"));
    assert_eq!(e5(at(1.0, 2.0, 1.0)), Err("eps^2 y^2 != 1"));
    assert_eq!(e5(at(1.0, 1.0, 1.0)), Ok(Branch::Inner));
    assert_eq!(e3::Solution::through(&at(1.0, 1.0, 1.0), &0.0).map_err(condition).err(), Some("eps != 0"));
}
