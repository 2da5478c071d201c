//! Compares the chosen setting with a reference trajectory, and with all cheaper settings.

use kahan_core::prelude::*;
use kahan_core::{Composition, ExtendScalars, PreparedStep};
use kahan_dynamics::{Scene, Scheme};

use crate::scene::trajectory::Trajectory;
use crate::systems::{E2, E6, EulerTop, Henon, Lorenz, LotkaVolterra};

/// The largest allowed ratio of the chosen cost to the smallest possible cost.
const RATIO: f64 = 3.0;

/// Checks that each choice meets its tolerance, and that no setting at 1/`RATIO` of its cost does.
fn check<M, const N: usize>(name: &str, map: M, x0: [f64; N], horizon: f64, steps: usize, tolerances: &[f64])
where
    M: ExtendScalars<f64, N>,
{
    let x0 = SVector::from(x0);
    let reference = Trajectory::new(&map, &x0, horizon, steps);
    let doubt = reference.doubt(&Trajectory::new(&map, &x0, horizon, steps / 2));
    let stage = <M::Prepared as PreparedStep<f64, N>>::COST;
    for &tolerance in tolerances {
        // With order 8 and half the steps, `doubt` is 2⁸ times the error of the reference.
        assert!(doubt < 0.1 * tolerance, "{name}: the reference is known to {doubt:e} only");
        let scene = Scene::trajectory(horizon, tolerance);
        let chosen = scene.choose(&map, &x0).unwrap_or_else(|why| panic!("{name}, {tolerance:e}: {why}"));
        let error = reference.error(&chosen, &map, x0, 256, f64::INFINITY);
        let cost = chosen.steps() as f64 * chosen.scheme().cycles(stage);
        println!("{name}, {tolerance:e}: {chosen} costs {cost:.0}, errs {error:.1e}");
        assert!(error <= tolerance, "{name}: {chosen} errs {error:e} for {tolerance:e}");

        for scheme in Scheme::all() {
            // At a fixed cost, a scheme is usually most accurate with the largest number of steps.
            // Smaller numbers of steps are tried, too, because a setting may be accurate by chance.
            let mut steps = cost / RATIO / scheme.cycles(stage);
            for _ in 0..8 {
                if steps < 1.0 {
                    break;
                }
                let cheap = scene.setting(scheme, steps as u64);
                let error = reference.error(&cheap, &map, x0, 64, tolerance);
                assert!(error > tolerance, "{name}: {cheap} errs {error:e}, at a third of {chosen}");
                steps /= 1.1;
            }
        }
    }
}

const TOLERANCES: [f64; 9] = [1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13, 2e-14];

#[test]
fn e6_is_served_at_no_more_than_three_times_the_least_cost() {
    check("E6", E6, [0.25, -0.5, 1.0], 20.0, 2048, &TOLERANCES);
}

#[test]
fn the_euler_top_is_served_at_no_more_than_three_times_the_least_cost() {
    check("Euler", EulerTop { a1: 1.0, a2: -3.0, a3: 1.5 }, [0.5, 0.25, -0.75], 20.0, 2048, &TOLERANCES);
}

#[test]
fn lotka_volterra_is_served_at_no_more_than_three_times_the_least_cost() {
    check("LV", LotkaVolterra, [1.5, 1.0], 20.0, 2048, &TOLERANCES);
}

#[test]
fn e2_is_served_at_no_more_than_three_times_the_least_cost() {
    check("E2", E2, [0.5, -0.75, 1.0], 20.0, 2048, &TOLERANCES);
}

#[test]
fn a_little_of_lorenz_is_served_at_no_more_than_three_times_the_least_cost() {
    check("Lorenz", Lorenz, [1.0, 1.0, 20.0], 4.0, 4096, &TOLERANCES[..7]);
}

/// Regression test: extrapolation once missed these tolerances.
#[test]
fn points_whose_laws_bend_are_served_too() {
    let top = || EulerTop { a1: 1.0, a2: -3.0, a3: 1.5 };
    check("Euler", top(), [0.007, -0.954, 0.267], 15.0, 1024, &[1e-6, 1e-9]);
    check("Euler", top(), [1.345, -1.104, 1.171], 15.0, 1024, &[1e-6, 1e-9]);
    check("E6", E6, [-0.24, -0.816, -0.605], 20.0, 1024, &[1e-2, 1e-3]);
    check("Henon", Henon, [-0.058, -0.245, -0.266, 0.229], 30.0, 1024, &[1e-4, 1e-9]);
}

#[test]
fn the_integrals_of_e6_are_kept_as_was_asked_for() {
    let x0 = vector![0.25, -0.5, 1.0];
    for (horizon, tolerance) in [(500.0, 1e-6), (500.0, 3e-14), (500.0, 1e-14), (20_000.0, 2e-13)] {
        let setting = Scene::integrals(horizon, tolerance).choose(&E6, &x0).unwrap();
        assert_eq!(setting.scheme().composition, Composition::KAHAN);
        let values = |x: &SVector<f64, 3>| E6.integrals(&x.map(Dd::from), Dd::from(setting.eps()));
        let (mut begin, mut worst) = (None, 0.0_f64);
        setting.visit(&E6, x0, |_, x| {
            let now = values(x);
            let begin = begin.get_or_insert(now);
            let change = now.zip_map(begin, |now, begin| f64::from(((now - begin) / begin).abs()));
            worst = worst.max(change.max());
        });
        println!("E6, integrals {tolerance:e}: {setting} drifts {worst:.1e}");
        assert!(worst > 0.0 && worst <= tolerance, "{setting} drifts {worst:e} for {tolerance:e}");
    }
}

#[test]
fn a_long_orbit_meets_its_tolerance_too() {
    check("LV", LotkaVolterra, [1.5, 1.0], 500.0, 8192, &[1e-3, 1e-6, 1e-9]);
}
