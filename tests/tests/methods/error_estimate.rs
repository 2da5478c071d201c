//! Compares the error estimate with the exact flow: its sign, its order and its accumulation.

use kahan_core::prelude::*;
use kahan_core::{Dd, ExtendScalars};
use kahan_systems::{E2, E6, EulerTop, LotkaVolterra};
use kahan_tests::taylor::{distance, flow};

fn point<const N: usize>(entries: [f64; N]) -> SVector<Dd, N> {
    SVector::from(entries.map(Dd::from))
}

fn top() -> EulerTop<Dd> {
    let [a1, a2, a3] = [1.0, -2.0, 1.5].map(Dd::from);
    EulerTop { a1, a2, a3 }
}

/// Returns the sizes of x̃ − flow and of x̃ − flow − estimate after one step.
fn local<M: KahanMap<Dd, N>, const N: usize>(map: &M, start: [f64; N], eps: f64) -> [f64; 2] {
    let (x, half_step) = (point(start), Dd::from(eps));
    let next = map.step(&x, half_step);
    let flow = flow(map, x, half_step + half_step, 1);
    let corrected: SVector<Dd, N> = next - map.at(half_step).local_error(&x);
    [distance(&next, &flow), distance(&corrected, &flow)]
}

/// Tests the estimate for one step. Errors of 10⁻¹² to 10⁻²⁰ are above rounding.
fn estimates_the_step<M: KahanMap<Dd, N>, const N: usize>(name: &str, map: &M, start: [f64; N]) {
    let sizes = [11, 12, 13].map(|k| local(map, start, 2_f64.powi(-k)));
    for pair in sizes.windows(2) {
        let slopes = [0, 1].map(|k| (pair[0][k] / pair[1][k]).log2());
        assert!((slopes[0] - 3.0).abs() < 0.05, "{name}: the error is of order 3, {slopes:?}, {sizes:?}");
        assert!((slopes[1] - 4.0).abs() < 0.05, "{name}: what is left is of order 4, {slopes:?}, {sizes:?}");
    }
    assert!(sizes.iter().all(|[error, rest]| rest < &(0.05 * error)), "{name}: {sizes:?}");
}

#[test]
fn the_estimate_is_the_leading_term_of_a_step() {
    estimates_the_step("E2", &E2, [0.5, 0.75, -0.5]);
    estimates_the_step("E6", &E6, [0.5, 0.75, -0.25]);
    estimates_the_step("Euler", &top(), [0.5, 1.0, 0.75]);
    estimates_the_step("LV", &LotkaVolterra, [1.5, 0.75]);
}

/// Tests that the accumulated estimate raises the order of the error from 2 to 4.
fn estimates_the_orbit<M: ExtendScalars<Dd, N>, const N: usize>(name: &str, map: &M, start: [f64; N]) {
    let (time, x) = (Dd::from(4.0), point(start));
    let end = flow(map, x, time, 64);
    let sizes = [512, 1024, 2048].map(|steps| {
        let eps = time / Dd::from(2.0 * f64::from(steps));
        let last =
            map.orbit(x, eps).with_error_estimate().nth(steps as usize).expect("a float orbit goes on");
        let corrected: SVector<Dd, N> = last.point - last.error;
        [distance(&last.point, &end), distance(&corrected, &end)]
    });
    for pair in sizes.windows(2) {
        let slopes = [0, 1].map(|k| (pair[0][k] / pair[1][k]).log2());
        assert!((slopes[0] - 2.0).abs() < 0.05, "{name}: {slopes:?}, {sizes:?}");
        assert!((slopes[1] - 4.0).abs() < 0.1, "{name}: {slopes:?}, {sizes:?}");
    }
    assert!(sizes.iter().all(|[error, rest]| rest < &(1e-3 * error)), "{name}: {sizes:?}");
}

#[test]
fn the_accumulated_estimate_is_the_leading_term_of_an_orbit() {
    estimates_the_orbit("E6", &E6, [0.5, 0.75, -0.25]);
    estimates_the_orbit("Euler", &top(), [0.5, 1.0, 0.75]);
    estimates_the_orbit("LV", &LotkaVolterra, [1.5, 0.75]);
}

#[test]
fn estimating_changes_no_point() {
    let (start, eps) = (vector![0.5, 0.75, -0.25], 0.01);
    let orbit = || E6.orbit(start, eps).compensated();
    let estimated: Vec<_> = orbit().with_error_estimate().take(50).collect();
    assert!(estimated.iter().map(|estimated| estimated.point).eq(orbit().take(50)));
    assert_eq!(estimated[0].error, vector![0.0, 0.0, 0.0]);
    assert!(estimated[1..].iter().all(|estimated| estimated.error.amax() > 0.0));
}
