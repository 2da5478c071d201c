//! Measures the cost of observers on orbits of E6, and the time of stability maps.
//! `cargo run --release -p kahan-bench-observers` in this folder prints two tables.

use std::hint::black_box;
use std::time::Instant;

use kahan_bench_observers::{E6, HenonHeiles, MAP_EPS, cells};
use kahan_core::observe::{
    Drift, Extrema, Fli, Lyapunov, MeanLogDet, Megno, Observer, Rotation, Sali, Spectrum,
};
use kahan_core::prelude::*;

const ROUNDS: usize = 31;
const STEPS: u64 = 100_000;
const EPS: f64 = 1.0 / 64.0;

fn main() {
    orbits();
    stability_maps();
}

type Contender = (&'static str, Box<dyn Fn() -> f64>);

fn observed<O: Observer<f64>>(observers: impl Fn() -> O + 'static) -> Box<dyn Fn() -> f64> {
    Box::new(move || {
        let mut orbit = E6.orbit(black_box(vector![0.3, 0.8, 0.5]), EPS);
        let begun = Instant::now();
        black_box(orbit.observe(STEPS, observers()));
        begun.elapsed().as_secs_f64()
    })
}

fn orbits() {
    let map = || E6.at(EPS);
    let integrals = |x: &[f64]| E6.integrals(&vector![x[0], x[1], x[2]], EPS).data.0[0];
    let alone = || {
        let begun = Instant::now();
        black_box(E6.orbit(black_box(vector![0.3, 0.8, 0.5]), EPS).nth(STEPS as usize));
        begun.elapsed().as_secs_f64()
    };
    let contenders: [Contender; 11] = [
        ("the orbit alone", Box::new(alone)),
        ("no observer", observed(|| ())),
        ("extrema of three variables", observed(|| [0, 1, 2].map(|i| Extrema::of(move |x: &[f64]| x[i])))),
        ("drift of two integrals", observed(move || Drift::of(integrals))),
        ("largest exponent", observed(move || Lyapunov::new(map()))),
        ("three exponents", observed(move || Spectrum::new(map(), 3, 1))),
        ("mean log det", observed(move || MeanLogDet::new(map()))),
        ("FLI", observed(move || Fli::new(map()))),
        ("MEGNO", observed(move || Megno::new(map()))),
        ("SALI", observed(move || Sali::new(map()))),
        ("rotation number", observed(|| Rotation::of(STEPS, |x: &[f64]| [x[0], x[2]]))),
    ];
    let mut times = vec![Vec::new(); contenders.len()];
    for _ in 0..ROUNDS {
        for (times, (_, contender)) in times.iter_mut().zip(&contenders) {
            times.push(contender());
        }
    }
    println!("| E6 observed | ns a step | orbits |\n|---|---:|---:|");
    for ((name, _), own) in contenders.iter().zip(&times) {
        let mut ratios: Vec<f64> = own.iter().zip(&times[0]).map(|(own, alone)| own / alone).collect();
        ratios.sort_by(f64::total_cmp);
        let least = own.iter().copied().fold(f64::INFINITY, f64::min);
        println!("| {name} | {:.2} | {:.2} |", 1e9 * least / STEPS as f64, ratios[ROUNDS / 2]);
    }
}

fn stability_maps() {
    const SIDE: usize = 512;
    const STEPS: u64 = 1000;

    let map = HenonHeiles.at(MAP_EPS);
    println!(
        "\n| {SIDE} × {SIDE} points of Hénon and Heiles, {STEPS} steps | seconds | ns a step |\n|---|---:|---:|"
    );
    let row = |name: &str, run: &dyn Fn(Ensemble<f64, 4>)| {
        let times = (0..3).map(|_| {
            let grid = cells(SIDE);
            let begun = Instant::now();
            run(grid);
            begun.elapsed().as_secs_f64()
        });
        let least = times.fold(f64::INFINITY, f64::min);
        println!("| {name} | {least:.2} | {:.2} |", 1e9 * least / (SIDE * SIDE) as f64 / STEPS as f64);
    };
    row("advanced", &|mut grid| {
        grid.advance(&map, STEPS);
        black_box(grid);
    });
    row("observed by nobody", &|mut grid| {
        black_box(grid.observe(&map, STEPS, |_| ()));
    });
    row("SALI", &|mut grid| {
        black_box(grid.observe(&map, STEPS, |_| Sali::new(&map)));
    });
    row("FLI", &|mut grid| {
        black_box(grid.observe(&map, STEPS, |_| Fli::new(&map)));
    });
    row("MEGNO", &|mut grid| {
        black_box(grid.observe(&map, STEPS, |_| Megno::new(&map)));
    });
    row("largest exponent", &|mut grid| {
        black_box(grid.observe(&map, STEPS, |_| Lyapunov::new(&map)));
    });
}
