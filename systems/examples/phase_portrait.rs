//! Draws the picture of the README: orbits of Kahan's Lotka–Volterra map, one colour an orbit, one
//! dot a step.
//!
//! `cargo run --release -p kahan-systems --example phase_portrait > docs/lotka_volterra.svg`

use kahan_core::prelude::*;
use kahan_systems::LotkaVolterra;

/// Half the time step: Δt = 0.294, about twenty steps a cycle.
const EPS: f64 = 0.147;
const STEPS: usize = 360;
/// One colour an orbit, from the centre outwards.
const COLOURS: [&str; 9] =
    ["#2166ac", "#2b83ba", "#35978f", "#4dac26", "#b8a000", "#e08214", "#d6604d", "#c51b7d", "#762a83"];
/// Pixels a unit of x or y, and the units shown.
const SCALE: f64 = 120.0;
const SHOWN: f64 = 3.6;

fn main() {
    let size = SCALE * SHOWN;
    println!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size} {size}" width="{size}" height="{size}">"#
    );
    println!(r#"<rect width="100%" height="100%" fill="white"/>"#);
    for (orbit, colour) in COLOURS.iter().enumerate() {
        let start = vector![1.0 - 0.088 * (orbit + 1) as f64, 1.0];
        println!(r#"<path fill="none" stroke="{colour}" stroke-width="3" stroke-linecap="round" d=""#);
        for x in LotkaVolterra.orbit(start, EPS).take(STEPS) {
            println!("M{:.1} {:.1}h0", SCALE * x[0], size - SCALE * x[1]);
        }
        println!(r#""/>"#);
    }
    println!("</svg>");
}
