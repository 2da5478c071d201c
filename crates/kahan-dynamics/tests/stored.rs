//! Tests that values do not change if they are written as JSON and read again.

use std::fmt::Debug;
use std::ops::ControlFlow;

use kahan_core::observe::{Direction, Drift, Extrema, FirstCrossings, Lyapunov, Section};
use kahan_core::prelude::*;
use kahan_core::{Axis, Dual, ProjectivePoint};
use kahan_dynamics::periodic::{branch, periodic_point};
use kahan_dynamics::{Scene, Scheme};
use serde_json::{from_str, from_value, json, to_string, to_value};

kahan! {
    struct LotkaVolterra { a }
    xdot = a*x*(1 - y);
    ydot = y*(x - 1);
}

fn read<T: serde::de::DeserializeOwned>(text: &str) -> T {
    from_value(from_str(text).unwrap()).unwrap()
}

fn comes_back<T>(value: &T)
where
    T: serde::Serialize + serde::de::DeserializeOwned + PartialEq + Debug,
{
    let text = to_string(value).unwrap();
    assert_eq!(read::<T>(&text), *value, "{text}");
}

#[test]
fn numbers_points_and_axes_come_back() {
    comes_back(&(Dd::from(1.0) / Dd::from(3.0)));
    comes_back(&vector![0.1, 1.0 / 3.0]);
    comes_back(&vector![Dd::from(0.1), Dd::from(2.0).sqrt()]);
    comes_back(&ProjectivePoint::from(vector![0.1, f64::MIN_POSITIVE]));
    comes_back(&Axis { start: 0.1, end: 0.7, count: 5 });
    Composition::ALL.iter().for_each(comes_back);
}

#[test]
fn a_composition_is_its_name_and_no_other() {
    assert_eq!(to_value(Composition::KAHAN_LI_8).unwrap(), json!("KAHAN_LI_8"));
    let refused = from_str::<Composition>("\"KAHAN_LI_9\"").unwrap_err().to_string();
    assert!(refused.contains("KAHAN_LI_9") && refused.contains("name of a composition"), "{refused}");
}

#[test]
fn reports_come_back() {
    let map = LotkaVolterra { a: 1.0 }.at(0.05);
    let section = Section::new(&map, |x: &[f64]| x[0] - x[1], Direction::Both, FirstCrossings::new(3));
    let observers =
        (section, Extrema::of(|x: &[f64]| x[0]), Drift::of(|x: &[f64]| [x[1]]), Lyapunov::new(&map));
    let (crossings, extremes, drifted, exponent) = map.orbit(vector![1.5, 1.0]).observe(1000, observers);
    assert_eq!(crossings.points.kept.len(), 3);
    comes_back(&crossings);
    comes_back(&extremes);
    comes_back(&drifted);
    comes_back(&exponent);
}

#[test]
fn a_setting_that_comes_back_runs_as_before() {
    let (map, start) = (LotkaVolterra { a: 1.0 }, vector![1.5, 1.0]);
    let scene = Scene::trajectory(5.0, 1e-6);
    let chosen = scene.choose(&map, &start).unwrap();
    let again: kahan_dynamics::Setting = read(&to_string(&chosen).unwrap());
    assert_eq!(again.run(&map, start), chosen.run(&map, start));
    comes_back(&scene);
    comes_back(&chosen);
    for scheme in Scheme::all() {
        comes_back(&scene.setting(scheme, 100));
    }
}

#[test]
fn cycles_and_branches_come_back() {
    let map = |a| LotkaVolterra { a: Dual::coordinate(a, 0) }.at(Dual::from_value(0.1));
    let cycle = periodic_point(&map(1.0), &[0.9, 1.1], 1).unwrap();
    comes_back(&cycle);
    comes_back(&branch(map, &cycle, [1.0, 2.0], 5, |_| ControlFlow::Continue(())));
}
