//! Tests the settings (composition, precision and steps) that `choose` returns, and their text.

use kahan_core::Composition;
use kahan_core::prelude::*;
use kahan_dynamics::{Flow, NoSetting, Precision, Scene};

use crate::systems::{Burst, E6, EulerTop, Lorenz, LotkaVolterra};

const START: [f64; 3] = [0.25, -0.5, 1.0];

#[test]
fn the_line_that_is_printed_is_the_orbit_that_is_run() {
    let start = vector![1.5, 1.0];
    let setting = Scene::trajectory(20.0, 1e-9).choose(&LotkaVolterra, &start).unwrap();
    assert_eq!(setting.scheme().precision, Precision::Double);
    let (eps, steps) = (setting.eps(), setting.steps());
    let line =
        format!("let orbit = map.orbit(x, {eps:?}).composed(Composition::KAHAN_LI_8).take({});", steps + 1);
    assert_eq!(setting.to_string(), line);

    let orbit = LotkaVolterra.orbit(start, eps).composed(Composition::KAHAN_LI_8).take(steps as usize + 1);
    let points: Vec<_> = orbit.collect();
    assert_eq!(Some(&setting.run(&LotkaVolterra, start)), points.last());
    let mut visited = Vec::new();
    setting.visit(&LotkaVolterra, start, |n, x| {
        assert_eq!(n as usize, visited.len());
        visited.push(*x);
    });
    assert_eq!(visited, points);
}

#[test]
fn the_same_question_has_the_same_answer() {
    let top = EulerTop { a1: 1.0, a2: -3.0, a3: 1.5 };
    let choose = || Scene::trajectory(15.0, 1e-6).choose(&top, &START.into());
    assert_eq!(choose(), choose());
}

#[test]
fn a_trajectory_ends_at_the_horizon_and_for_integrals_epsilon_is_short() {
    for (horizon, tolerance) in [(10.0, 0.3), (10.0, 1e-2), (10.0, 1e-6), (10.0, 1e-20), (2e-4, 1e-12)] {
        let setting = Scene::trajectory(horizon, tolerance).choose(&E6, &START.into()).unwrap();
        let missed = (2.0 * setting.eps() * setting.steps() as f64 - horizon).abs();
        assert!(missed <= horizon * f64::EPSILON, "{missed:e}");
        assert!(setting.error() <= tolerance);
    }
    let setting = Scene::integrals(10.0, 1e-10).choose(&E6, &START.into()).unwrap();
    assert_eq!(kahan_core::nearest_short_eps(setting.eps()), setting.eps());
    assert!((2.0 * setting.eps() * setting.steps() as f64 - 10.0).abs() <= setting.eps());
}

#[test]
fn what_makes_no_sense_is_refused() {
    let choose = |scene: Scene| scene.choose(&E6, &START.into());
    assert!(matches!(
        choose(Scene::trajectory(0.0, 1e-6)),
        Err(NoSetting::NotPositive { name: "horizon", .. })
    ));
    assert!(matches!(
        choose(Scene::trajectory(1.0, f64::NAN)),
        Err(NoSetting::NotPositive { name: "tolerance", .. })
    ));
    assert!(matches!(
        choose(Scene::integrals(1.0, 1e-6).condition(-1.0)),
        Err(NoSetting::NotPositive { name: "condition", .. })
    ));
    let nowhere = Scene::trajectory(1.0, 1e-6).choose(&E6, &vector![0.0, f64::INFINITY, 0.0]);
    assert_eq!(nowhere, Err(NoSetting::NotFinite { index: 1 }));
}

#[test]
fn a_tolerance_below_the_roundings_of_every_scalar_is_out_of_reach() {
    let scene = |tolerance| Scene::trajectory(0.5, tolerance);
    let Err(NoSetting::OutOfReach { best }) = scene(1e-33).choose(&E6, &START.into()) else {
        panic!("u of Dd is 5e-32");
    };
    assert!(best > 1e-31 && best < 1e-27, "{best:e}");
    assert!(scene(best).choose(&E6, &START.into()).is_ok());
    assert!(scene(1e-3 * best).choose(&E6, &START.into()).is_err());
}

#[test]
fn a_solution_that_ends_before_the_horizon_is_lost_there() {
    let choose = |horizon| Scene::trajectory(horizon, 1e-6).choose(&Burst, &vector![1.0]);
    assert!(choose(0.75).is_ok());
    // Kahan's map is exact for this system. Therefore all orbits step over the pole and continue.
    for horizon in [1.25, 2.0, 3.1] {
        let Err(NoSetting::Lost { time }) = choose(horizon) else {
            panic!("1/(1 - t) has no value at t = 1")
        };
        assert!((time - 1.0).abs() < 1e-6, "{time}");
    }
}

#[test]
fn chaos_for_longer_than_f64_can_follow_is_refused() {
    // Errors grow like exp(0.9 t), to exp(90) here.
    let long = Scene::trajectory(100.0, 1e-6).choose(&Lorenz, &vector![1.0, 1.0, 20.0]);
    assert!(matches!(long, Err(NoSetting::Lost { .. } | NoSetting::TooLong { .. })), "{long:?}");
}

/// From (1, 1, 1) the motion starts slowly, and its first errors are no measure of later errors.
#[test]
fn chaos_after_a_quiet_beginning_is_followed_to_its_end() {
    let (start, horizon, tolerance) = (vector![1.0, 1.0, 1.0], 20.0, 1e-3);
    let setting = Scene::trajectory(horizon, tolerance).choose(&Lorenz, &start).unwrap();
    let flow = Flow::through(&Lorenz, start.map(Dd::from), horizon, 0.0, &mut |_| true).unwrap();
    let last = setting.run(&Lorenz, start).map(Dd::from);
    let error = flow.distance(Dd::from(horizon), last.as_slice());
    assert!(error <= tolerance && setting.error() <= tolerance, "{setting} errs {error:e}");
}

#[test]
fn a_point_at_rest_takes_one_step() {
    let rest = Scene::trajectory(5.0, 1e-9).choose(&LotkaVolterra, &vector![1.0, 1.0]).unwrap();
    assert!(rest.steps() <= 2, "{rest}");
    assert_eq!(rest.run(&LotkaVolterra, vector![1.0, 1.0]), vector![1.0, 1.0]);
}
