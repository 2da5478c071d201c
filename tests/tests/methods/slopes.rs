//! Measures the order of the method for nonlinear fields with solutions in closed form (Hone and
//! Petrera, Table 5). Linear fields cannot reveal a wrong bilinear form.

use kahan_core::prelude::*;
use kahan_systems::{E1, E2, E3, E5};

const TIME: f64 = 1.0;

fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let mean = |pick: fn(&(f64, f64)) -> f64| points.iter().map(pick).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let rise: f64 = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum();
    rise / points.iter().map(|point| (point.0 - x).powi(2)).sum::<f64>()
}

/// Returns the pairs (log ε, log error) at `TIME`. The errors are far above rounding.
fn errors<M: KahanMap<f64, 3> + Clone>(map: &M, flow: impl Fn(f64) -> [f64; 3]) -> Vec<(f64, f64)> {
    [16, 32, 64, 128, 256, 512]
        .map(|n: u16| {
            let eps = TIME / f64::from(2 * n);
            let end = map.orbit(SVector::from(flow(0.0)), eps).nth(usize::from(n)).expect("an orbit goes on");
            let error = (end - SVector::from(flow(TIME))).amax();
            assert!(error > 1e-12, "at n = {n} the error {error:e} is rounding, not method");
            (eps.ln(), error.ln())
        })
        .to_vec()
}

/// Asserts order two over a factor of 32 in ε. Measured slopes are within 2.1·10⁻⁴ of 2.
fn has_order_two<M: KahanMap<f64, 3> + Clone>(name: &str, map: &M, flow: impl Fn(f64) -> [f64; 3]) {
    let points = errors(map, flow);
    let slope = slope(&points);
    assert!((slope - 2.0).abs() < 0.005, "{name}: slope {slope}, points {points:?}");
}

#[test]
fn the_global_error_is_of_order_two() {
    // The variable `big` is t + 2, and increases from 2 to 3.
    has_order_two("E1", &E1, |t| {
        let (big, beta, gamma) = (t + 2.0, 0.7, 1.3);
        [1.0 / big, beta / big, gamma * big - beta * beta / big]
    });
    has_order_two("E2", &E2, |t| {
        let (big, beta, gamma) = (t + 2.0, 0.7, 1.3);
        [1.0 / big, beta * big, big * (gamma - beta * beta * big * big)]
    });
    has_order_two("E3", &E3, |t| {
        let (lambda, theta) = (1.2_f64, 0.6_f64);
        let argument = lambda * (t - 0.3);
        [
            lambda * theta.cos() / argument.cosh(),
            lambda * theta.sin() / argument.cosh(),
            lambda * argument.tanh(),
        ]
    });
    has_order_two("E5", &E5, |t| {
        let (lambda, mu) = (1.2_f64, 0.4);
        let argument = lambda * (t - 0.3);
        let sech = 1.0 / argument.cosh();
        [lambda * sech, -lambda * argument.tanh(), mu * argument.cosh() + lambda * sech]
    });
}
