//! Tests chaos indicators on a regular and on a chaotic orbit of the Hénon–Heiles system.

use kahan_core::observe::{Drift, Fli, Megno, Sali};
use kahan_core::prelude::*;

use super::HenonHeiles;
use crate::systems::E6;

const EPS: f64 = 0.05;

/// Returns two initial points of energy 1/8, one on a torus and one in the chaotic region.
fn starts() -> [SVector<f64, 4>; 2] {
    let at_rest_in_x = |y: f64, q: f64| {
        let potential = y * y / 2.0 - y * y * y / 3.0;
        vector![0.0, y, (2.0 * (0.125 - potential) - q * q).sqrt(), q]
    };
    [at_rest_in_x(0.55, 0.0), at_rest_in_x(-0.25, 0.0)]
}

#[test]
fn indicators_tell_a_torus_from_the_chaotic_sea() {
    let map = HenonHeiles.at(EPS);
    let [torus, sea] = starts()
        .map(|start| map.orbit(start).observe(20_000, (Sali::new(&map), Fli::new(&map), Megno::new(&map))));
    assert!(torus.0 > 0.01 && sea.0 < 1e-12, "SALI {torus:?} {sea:?}");
    assert!(torus.1 < 12.0 && sea.1 > 40.0, "FLI {torus:?} {sea:?}");
    // MEGNO approaches 2 slowly.
    assert!((torus.2.mean - 2.0).abs() < 0.25 && sea.2.mean > 20.0, "MEGNO {torus:?} {sea:?}");
}

#[test]
fn indicators_are_their_definitions() {
    let map = HenonHeiles.at(EPS);
    let [start, _] = starts();
    let steps = 500;
    let (fli, megno) = map.orbit(start).observe(steps, (Fli::new(&map), Megno::new(&map)));
    // This is the initial direction that the observers use.
    let mut v = SVector::<f64, 4>::from_fn(|i, _| ((37 * i + 11) % 64 + 1) as f64 / 64.0);
    v /= v.norm();
    let (mut greatest, mut weighted, mut sum, mut y) = (0.0_f64, 0.0, 0.0, 0.0);
    for (k, x) in (1..=steps).zip(map.orbit(start)) {
        let next = map.jacobian(&x) * v;
        weighted += k as f64 * (next.norm() / v.norm()).ln();
        v = next;
        y = 2.0 * weighted / k as f64;
        sum += y;
        greatest = greatest.max(v.norm().ln());
    }
    assert!((fli - greatest).abs() < 1e-11, "{fli} {greatest}");
    assert!(
        (megno.last - y).abs() < 1e-10 && (megno.mean - sum / steps as f64).abs() < 1e-10,
        "{megno:?} {y}"
    );
}

#[test]
fn integrals_of_the_map_drift_by_rounding_and_those_of_the_flow_do_not_stay() {
    let eps = 0.05;
    let of_the_map = Drift::of(|x: &[f64]| E6.integrals(&vector![x[0], x[1], x[2]], eps).data.0[0]);
    let of_the_flow = Drift::of(|x: &[f64]| [x[0] * x[2] + x[1] * x[1]]);
    let mut orbit = E6.orbit(vector![0.3, 0.8, 0.5], eps);
    let ([h, k], [flow]) = orbit.observe(10_000, (of_the_map, of_the_flow));
    for drifted in [h, k] {
        assert!(drifted.last <= drifted.max && drifted.max > 0.0 && drifted.max < 1e-12, "{drifted:?}");
    }
    assert!(flow.max > 1e-4, "{flow:?}");
}

#[test]
fn a_value_that_was_no_number_is_not_forgotten() {
    let gone_once = Drift::of(|x: &[f64]| [if x[0] > 0.5 && x[0] < 0.6 { f64::NAN } else { 1.0 }]);
    let [drifted] = E6.orbit(vector![0.3, 0.8, 0.5], 0.05).observe(1000, gone_once);
    assert!(drifted.max.is_nan() && drifted.last == 0.0);
}
