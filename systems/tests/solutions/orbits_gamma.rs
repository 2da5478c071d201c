//! Compares exact orbits of the maps of E7 and E8 with solutions in terms of Γ and ψ.

use kahan_systems::special::Float256;
use kahan_systems::{E7, E8, e7, e8};

use crate::solutions::exact_orbits::{assert_on_orbit, cases, orbit, precise, rounded, ulps};

#[test]
fn solutions_of_e7_are_the_orbits() {
    let (mut compared, mut worst) = (0, 0.0_f64);
    for case in cases("e7") {
        let xi = Float256::from_rational(&case.parameters[0]);
        let solution = e7::Solution::through(&xi, &precise(&case.start), &Float256::from_rational(&case.eps));
        let Ok(solution) = solution else { continue };
        let exact = orbit(E7 { xi: case.parameters[0].clone() }, &case.start, &case.eps, [8, 12]);
        compared += assert_on_orbit(&exact, |n| solution.at(n), 50, &format!("E7, {}", case.start));
        let float = rounded(&case);
        let solution =
            e7::Solution::through(&float.parameters[0], &float.start, &float.eps).expect("in the domain");
        let map = E7 { xi: Float256::from(float.parameters[0]) };
        let units = ulps(map, &float, 1.0, |n| n as f64, |n| solution.at(n));
        worst = worst.max(units);
    }
    assert!(compared > 150, "{compared}");
    assert!(worst < 16.0, "{worst} ulp");
}

#[test]
fn solutions_of_e8_are_the_orbits() {
    let (mut compared, mut worst) = (0, 0.0_f64);
    for case in cases("e8") {
        let solution = e8::Solution::through(&precise(&case.start), &Float256::from_rational(&case.eps));
        let Ok(solution) = solution else { continue };
        let exact = orbit(E8, &case.start, &case.eps, [8, 12]);
        compared += assert_on_orbit(&exact, |n| solution.at(n), 50, &format!("E8, {}", case.start));
        let float = rounded(&case);
        let solution = e8::Solution::through(&float.start, &float.eps).expect("in the domain");
        let units = ulps(E8, &float, 1.0, |n| n as f64, |n| solution.at(n));
        worst = worst.max(units);
    }
    assert!(compared > 150, "{compared}");
    assert!(worst < 24.0, "{worst} ulp");
}
