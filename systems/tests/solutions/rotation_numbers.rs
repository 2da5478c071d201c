//! Compares observed rotation numbers with those of closed elliptic solutions. On an orbit of the
//! map of E4, the argument v increases by 2δ in each step. The functions sn and cn have the period
//! 4K, and dn has 2K.

use kahan_core::observe::{Extrema, Extremes, Rotation};
use kahan_core::prelude::*;
use kahan_systems::solution::Branch;
use kahan_systems::special::Float256;
use kahan_systems::{E4, EulerTop, e4, euler};

const STEPS: u64 = 100_000;
const EPS: f64 = 0.0625;

/// Returns for each variable its extremes, its rotations per step, and their estimated error.
fn observed<M: KahanMap<f64, 3>>(map: &M, start: SVector<f64, 3>) -> [(Extremes<f64>, f64, f64); 3] {
    let orbit = || map.orbit(start, EPS).compensated();
    let velocity = |x: &[f64]| map.field(&vector![x[0], x[1], x[2]]);
    let seen =
        [0, 1, 2].map(|i| (Extrema::of(move |x: &[f64]| x[i]), Extrema::of(move |x: &[f64]| velocity(x)[i])));
    let extremes = orbit().observe(STEPS / 10, seen).map(|(x, v)| [x.unwrap(), v.unwrap()]);
    let turns =
        [0, 1, 2].map(|i| Rotation::between(STEPS, move |x: &[f64]| [x[i], velocity(x)[i]], extremes[i]));
    let turns = orbit().observe(STEPS, turns);
    std::array::from_fn(|i| (extremes[i][0], turns[i].value, turns[i].error))
}

/// Returns 2δ/(4K), the rotations of sn and cn per step. `None` means that tests skip the orbit.
fn half_turn(solution: &e4::Solution<Float256>) -> Option<f64> {
    let quarter = solution.modulus.quarter_period();
    let turns = (solution.delta / (quarter + quarter)).to_f64().abs();
    let is_ordinary = solution.modulus.k.to_f64() <= 0.99 && solution.branch == Branch::Inner;
    (turns * STEPS as f64 >= 100.0 && is_ordinary).then_some(turns)
}

fn precise(x: SVector<f64, 3>) -> SVector<Float256, 3> {
    x.map(Float256::from)
}

/// Returns the distance of two rotation numbers, modulo integers and sign.
fn distance(a: f64, b: f64) -> f64 {
    let apart = |d: f64| (d - d.round()).abs();
    apart(a - b).min(apart(a + b))
}

fn starts(count: usize) -> impl Iterator<Item = SVector<f64, 3>> {
    (0..count).map(move |i| {
        let (height, angle) = (1.8 * (i as f64 + 0.5) / count as f64 - 0.9, 2.4 * i as f64);
        let radius = (1.0 - height * height).sqrt();
        vector![radius * angle.cos(), radius * angle.sin(), height]
    })
}

#[test]
fn variables_of_the_euler_top_turn_as_their_elliptic_functions() {
    let coefficients = [1.5, -0.625, 1.75];
    let [a1, a2, a3] = coefficients;
    let mut compared = 0;
    for start in starts(10) {
        let solution = euler::Solution::through(
            &coefficients.map(Float256::from),
            &precise(start),
            &Float256::from(EPS),
        );
        let Some(turns) = half_turn(&solution.expect("a top that is E4").orbit) else { continue };
        for (extremes, found, error) in observed(&EulerTop { a1, a2, a3 }, start) {
            let keeps_its_sign = extremes.least * extremes.greatest > 0.0;
            let exact = if keeps_its_sign { 2.0 * turns } else { turns };
            assert!(distance(found, exact) < 1e-12, "{start} {found} {exact} {error}");
            compared += 1;
        }
    }
    assert!(compared >= 20, "{compared}");
}

#[test]
fn variables_of_e4_turn_as_their_elliptic_functions() {
    let mut compared = 0;
    for start in starts(10) {
        let solution = e4::Solution::through(&precise(start), &Float256::from(EPS)).expect("no fixed point");
        let Some(turns) = half_turn(&solution) else { continue };
        for (_, found, error) in observed(&E4, start) {
            assert!(distance(found, turns) < 1e-12, "{start} {found} {turns} {error}");
            compared += 1;
        }
    }
    assert!(compared >= 20, "{compared}");
}
