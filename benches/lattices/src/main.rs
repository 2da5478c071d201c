//! Times steps of long chains, in nanoseconds per site, and the loop a = b + s·c over arrays, in
//! nanoseconds per element. `cargo run --release -p kahan-bench-lattices` in this folder prints a
//! table.

mod families;
mod midpoint;

use std::hint::black_box;
use std::time::Instant;

use kahan_core::prelude::*;
use kahan_core::{LatticeScalar, Level};

use families::{Kdv, Toda, Volterra};

const ROUNDS: usize = 7;
/// The number of site updates in a round.
const WORK: usize = 20_000_000;

fn main() {
    for level in [Level::Avx512, Level::Avx2].into_iter().filter(|level| level.is_available()) {
        println!("{level:?}\n");
        table(level);
    }
    midpoint::table();
}

fn table(level: Level) {
    println!(
        "| sites | Volterra | the same in f32 | KdV, five points | Toda, two arrays | triad, an element |"
    );
    println!("|---:|---:|---:|---:|---:|---:|");
    for sites in [1_000, 10_000, 100_000, 1_000_000, 10_000_000] {
        let h = 0.1;
        let mut contenders: Vec<Box<dyn FnMut() -> f64>> = vec![
            chain(level, &Volterra, sites, 0.05_f64, |i| 1.0 + 0.5 * (0.01 * i).sin()),
            chain(level, &Volterra, sites, 0.05_f32, |i| (1.0 + 0.5 * (0.01 * i).sin()) as f32),
            chain(level, &Kdv { h }, sites, 0.5 * h * h * h, |i| (0.01 * i).sin()),
            chain(level, &Toda, sites, 0.05, |i| 0.5 + 0.1 * (0.01 * i).sin()),
            triad(sites),
        ];
        let mut least = vec![f64::INFINITY; contenders.len()];
        for _ in 0..ROUNDS {
            for (time, contender) in least.iter_mut().zip(&mut contenders) {
                *time = time.min(contender());
            }
        }
        let figures: Vec<String> = least.iter().map(|time| format!("{time:.2}")).collect();
        println!("| {sites} | {} |", figures.join(" | "));
    }
    println!();
}

fn chain<T: LatticeScalar + Copy, M: LatticeMap<T> + 'static>(
    level: Level,
    map: &M,
    sites: usize,
    eps: T,
    start: impl Fn(f64) -> T,
) -> Box<dyn FnMut() -> f64> {
    let at = map.at(eps, sites).expect("parameters of this many sites");
    let at = at.at_level(level).expect("an available level");
    let start: Vec<T> = (0..sites * M::BLOCK).map(|i| start(i as f64)).collect();
    let steps = (WORK / sites).clamp(2, 2_000) as u64;
    Box::new(move || {
        let mut state = start.clone();
        at.advance(&mut state, 1);
        let begun = Instant::now();
        at.advance(black_box(&mut state), steps);
        begun.elapsed().as_secs_f64() * 1e9 / (steps as f64 * sites as f64)
    })
}

fn triad(sites: usize) -> Box<dyn FnMut() -> f64> {
    let (mut a, b, c) = (vec![0.0_f64; sites], vec![1.0_f64; sites], vec![2.0_f64; sites]);
    let times = (WORK / sites).max(2);
    Box::new(move || {
        let begun = Instant::now();
        for k in 0..times {
            let scale = black_box(k as f64);
            for ((a, b), c) in a.iter_mut().zip(&b).zip(&c) {
                *a = b + scale * c;
            }
            black_box(&mut a);
        }
        begun.elapsed().as_secs_f64() * 1e9 / (times as f64 * sites as f64)
    })
}
