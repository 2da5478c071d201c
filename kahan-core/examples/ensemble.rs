//! Advances 2 500 springs that start close together and lose their common phase.
//!
//! Larger oscillations have longer periods. Therefore phases drift, and the mean velocity decays.

use kahan_core::prelude::*;

kahan! {
    /// A weight on a spring that hardens on one side.
    struct Spring;
    xdot = v;
    vdot = -x - x^2;
    integral H = (3*x^2 + 3*v^2 + 2*x^3 - eps^2*(x^2 + v^2 + 2*x*v^2))/(1 + eps^2*(1 + 2*x));
}

/// Returns the last mean velocity, and the largest change of any spring's energy H.
pub(crate) fn run() -> (f64, f64) {
    let eps = 0.05;
    let map = Spring.at(eps);
    let (x, v) = (Axis { start: -0.1, end: 0.1, count: 50 }, Axis { start: 0.2, end: 0.4, count: 50 });
    let mut springs = Ensemble::grid([x, v]);
    let energies = |springs: &Ensemble<f64, 2>| -> Vec<f64> {
        springs.points().map(|point| Spring.integrals(&point, eps)[0]).collect()
    };
    let (first, mut mean) = (energies(&springs), 0.0);
    for time in [0, 100, 200, 300, 400] {
        springs.advance(&map, if time == 0 { 0 } else { 1_000 });
        let v = springs.column(1);
        mean = v.iter().sum::<f64>() / v.len() as f64;
        let largest = v.iter().fold(0.0, |largest, v| v.abs().max(largest));
        println!("t = {time:3}   mean of v = {mean:+.4}   largest |v| = {largest:.4}");
    }
    let change = first.iter().zip(energies(&springs)).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
    println!("H changed by {change:.1e} at most");
    (mean, change)
}

fn main() {
    run();
}
