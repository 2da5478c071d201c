//! Finds the cheapest scalar, order and ε for several tolerances.
//!
//! A `Scene` is a time span with a tolerance. The errors of settings are measured over the whole
//! span. Costs are modelled, so the choice is reproducible. A setting prints as a line of Rust.

use kahan_core::prelude::*;
use kahan_dynamics::Scene;

kahan! {
    /// Predator and prey.
    struct LotkaVolterra;
    xdot = x*(1 - y);
    ydot = y*(x - 1);
}

/// Prints the setting chosen for each tolerance. Returns the tolerance, the order, and the change
/// of the flow's integral.
pub(crate) fn run() -> Vec<(f64, u32, f64)> {
    let start = vector![1.5, 1.0];
    let part = |value: f64| value - value.ln();
    let level = |x: SVector<f64, 2>| part(x[LotkaVolterra::X]) + part(x[LotkaVolterra::Y]);
    let mut choices = Vec::new();
    for tolerance in [1e-2, 1e-5, 1e-8] {
        let setting =
            Scene::trajectory(20.0, tolerance).choose(&LotkaVolterra, &start).expect("a setting serves");
        let change = (level(setting.run(&LotkaVolterra, start)) - level(start)).abs();
        println!("{tolerance:e}: {setting}\n      x − ln x + y − ln y changed by {change:.1e}");
        choices.push((tolerance, setting.scheme().order(), change));
    }
    choices
}

fn main() {
    run();
}
