//! Tests that rational solutions and recurrences equal exact orbits.

use kahan_core::num_traits::Zero;
use kahan_core::{Integrals, KahanMap};
use kahan_systems::solution::{ReciprocalMap, ReciprocalOrbit};
use kahan_systems::{E1, E2, E7, E8, e7, e8};

use crate::solutions::exact_orbits::{Case, Point, Rational, cases, orbit, rational};

fn assert_equal(exact: &[(i64, Point<Rational>)], at: impl Fn(i64) -> Point<Rational>) -> usize {
    for (n, point) in exact {
        assert_eq!(&at(*n), point, "n = {n}");
    }
    exact.len()
}

fn regular(case: &Case) -> bool {
    let scaled = &case.eps * &case.start[0];
    !scaled.is_zero() && &scaled * &scaled != rational("1")
}

fn rational_solutions<S>(name: &str, system: S) -> usize
where
    S: KahanMap<Rational, 3> + Integrals<Rational, 3, 2> + ReciprocalMap<Rational> + Copy,
{
    let mut compared = 0;
    for case in cases(name) {
        let solution = ReciprocalOrbit::<S, Rational>::through(&case.start, &case.eps);
        assert_eq!(solution.is_ok(), regular(&case));
        if let Ok(solution) = solution {
            compared += assert_equal(&orbit(system, &case.start, &case.eps, [12, 12]), |n| solution.at(n));
            let integrals = system.integrals(&case.start, case.eps.clone());
            assert_eq!([&integrals[0], &integrals[1]], [&solution.beta, &solution.gamma]);
        }
    }
    compared
}

#[test]
fn solutions_of_e1_and_e2_are_the_orbits() {
    let compared = rational_solutions("e1", E1) + rational_solutions("e2", E2);
    assert!(compared > 400, "{compared}");
}

#[test]
fn recurrences_of_e7_and_e8_are_the_orbits() {
    let mut compared = 0;
    for case in cases("e7") {
        let xi = &case.parameters[0];
        if let Ok(recurrence) = e7::Recurrence::through(xi, &case.start, &case.eps) {
            compared += assert_equal(&orbit(E7 { xi: xi.clone() }, &case.start, &case.eps, [9, 9]), |n| {
                recurrence.at(n)
            });
        }
    }
    for case in cases("e8") {
        if let Ok(recurrence) = e8::Recurrence::through(&case.start, &case.eps) {
            compared += assert_equal(&orbit(E8, &case.start, &case.eps, [9, 9]), |n| recurrence.at(n));
        }
    }
    assert!(compared > 300, "{compared}");
}
