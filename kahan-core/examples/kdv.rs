//! Two solitons of the Korteweg–de Vries equation on a ring of 512 sites. Prints how well the map
//! conserves integrals over 100 000 steps, and draws a picture if a file is named.
//!
//! `cargo run --release -p kahan-core --example kdv [picture.svg]`

use std::error::Error;
use std::fmt::Write as _;

use kahan_core::LatticeAt;
use kahan_core::prelude::*;

kahan! {
    /// The equation u_t = −6 u u_x − u_xxx, discretised by central differences of width h.
    pub struct Kdv { h }
    for i in periodic {
        u[i]dot = -3*(u[i+1]^2 - u[i-1]^2)/(2*h) - (u[i+2] - 2*u[i+1] + 2*u[i-1] - u[i-2])/(2*h^3);
    }
    integral mass = sum(u[i]);
    hamiltonian H = sum((u[i+1] - u[i])^2/(2*h^2) - u[i]^3);
}

const SITES: usize = 512;
const STEPS: u64 = 100_000;

fn main() -> Result<(), Box<dyn Error>> {
    let h = 0.15;
    let eps = 5e-4; // half the time step
    let soliton = |speed: f64, x: f64| 0.5 * speed / (0.5 * speed.sqrt() * x).cosh().powi(2);
    let site = |i: usize| h * i as f64;
    let mut u: Vec<f64> =
        (0..SITES).map(|i| soliton(4.0, site(i) - 15.0) + soliton(1.0, site(i) - 30.0)).collect();
    let mut chain = Kdv { h }.at(eps, SITES)?;

    let mut profiles = vec![u.clone()];
    let first = kept(&mut chain, &u);
    let mut changes = [const { Vec::new() }; 4];
    for k in 1..=STEPS {
        chain.step(&mut u);
        if k % 100 == 0 {
            let now = kept(&mut chain, &u);
            for ((changes, now), first) in changes.iter_mut().zip(now).zip(first) {
                changes.push(now / first - 1.0);
            }
        }
        if k <= 12_000 && k % 1_000 == 0 {
            profiles.push(u.clone());
        }
    }
    println!("{STEPS} steps of {} to t = {}", 2.0 * eps, 2.0 * eps * STEPS as f64);
    for (name, changes) in ["mass", "momentum", "energy", "modified energy"].into_iter().zip(&changes) {
        let largest = changes.iter().fold(0.0_f64, |largest, change| largest.max(change.abs()));
        let trend = trend(changes);
        println!(
            "{name:<16} changes by {largest:.1e} of itself at most, by {trend:+.1e} along a straight line"
        );
    }
    if let Some(path) = std::env::args().nth(1) {
        std::fs::write(path, picture(&profiles))?;
    }
    Ok(())
}

fn kept(chain: &mut LatticeAt<Kdv<f64>, f64>, u: &[f64]) -> [f64; 4] {
    let momentum = u.iter().map(|u| u * u).sum();
    [chain.integrals(u)[0], momentum, chain.hamiltonian(u), chain.modified_energy(u)]
}

/// Returns the rise of the least-squares line through equally spaced values, from first to last.
fn trend(values: &[f64]) -> f64 {
    let middle = (values.len() - 1) as f64 / 2.0;
    let place = |k: usize| k as f64 - middle;
    let above: f64 = values.iter().enumerate().map(|(k, value)| place(k) * value).sum();
    let below: f64 = (0..values.len()).map(|k| place(k).powi(2)).sum();
    above / below * 2.0 * middle
}

fn picture(profiles: &[Vec<f64>]) -> String {
    let (width, gap, scale) = (720.0, 26.0, 40.0);
    let height = gap * (profiles.len() - 1) as f64 + 2.0 * scale + 40.0;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" \
         font-size=\"13\">\n<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n"
    );
    // Draws the last profile first, so that all earlier profiles lie in front of it.
    for (k, profile) in profiles.iter().enumerate().rev() {
        let base = height - 24.0 - gap * k as f64;
        let mut points = format!("8,{base:.1}");
        for (i, u) in profile.iter().enumerate().step_by(2) {
            let x = 8.0 + (width - 16.0) * i as f64 / (SITES - 1) as f64;
            let _ = write!(points, " {x:.0},{:.1}", base - scale * u);
        }
        let _ = writeln!(
            svg,
            "<polygon points=\"{points} {:.1},{base:.1}\" fill=\"#dbe7f5\" stroke=\"#1f4e8c\" stroke-width=\"1.2\"/>",
            width - 8.0
        );
    }
    svg + &format!(
        "<text x=\"8\" y=\"{:.1}\" fill=\"#333\">t = 0 in front, behind it t = 1, 2, … 12: the tall soliton overtakes the \
         small one</text>\n</svg>\n",
        height - 6.0
    )
}
