//! Prints invariants and nanoseconds per site of lattices with 10, 1000 and 1 000 000 sites.
use kahan_bench_own_lattices::*;
use kahan_core::LatticeAt;
use kahan_core::prelude::*;
use std::time::Instant;

type Kept<M> = fn(&mut LatticeAt<M, f64>, &[f64]) -> Vec<(&'static str, f64)>;

fn run<M: LatticeMap<f64>>(name: &str, mut chain: LatticeAt<M, f64>, mut x: Vec<f64>, kept: Kept<M>) {
    let n = chain.sites();
    let steps = (3_000_000 / n).clamp(5, 20_000) as u64;
    let before = kept(&mut chain, &x);
    let clock = Instant::now();
    chain.advance(&mut x, steps);
    let ns = clock.elapsed().as_nanos() as f64 / (steps as f64 * n as f64);
    let mut text = format!(
        "{name:<14} {n:>8} sites, {steps:>6} steps: {ns:7.1} ns a site and step, {:6.1} a variable;",
        ns / M::BLOCK as f64
    );
    for ((name, then), (_, now)) in before.into_iter().zip(kept(&mut chain, &x)) {
        text += &format!(" {name} {then:.4e} changes by {:.1e},", now - then);
    }
    let after = x.clone();
    chain.step(&mut x);
    let residual = chain.residual(&after, &x);
    chain.step_back(&mut x);
    let back = x.iter().zip(&after).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    println!(
        "{text} there and back {back:.1e}, residual {residual:?}, whole eliminations {}",
        chain.whole_eliminations()
    );
}

fn main() {
    for n in [10, 1000, 1_000_000] {
        let s = |i: usize, k: f64| (2.0 * std::f64::consts::PI * k * i as f64 / n as f64).sin();
        let grow: Vec<f64> = (0..n).map(|i| 1.0 + 0.3 * s(i, 2.0)).collect();
        let pairs = |a: f64, b: f64| {
            (0..n).flat_map(|i| [a + 0.1 * s(i, 1.0), b + 0.1 * s(i, 3.0)]).collect::<Vec<f64>>()
        };
        run(
            "predator-prey",
            PredatorPrey { du: 0.2, dv: 0.5, grow: grow.clone(), eat: 1.0, die: 0.4 }.at(0.02, n).unwrap(),
            pairs(0.6, 0.4),
            |_, _| vec![],
        );
        let mut left = vec![0.3; n];
        let mut right = vec![0.3; n];
        left[0] = 0.0;
        right[n - 1] = 0.0;
        run("no flux", NoFlux { left, right, grow }.at(0.02, n).unwrap(), pairs(0.6, 0.4), |_, _| vec![]);
        run(
            "bogoyavlensky",
            Bogoyavlensky.at(0.01, n).unwrap(),
            (0..n).map(|i| 1.0 + 0.3 * s(i, 1.0)).collect(),
            |c, x| vec![("S", c.integrals(x)[0]), ("product", x.iter().map(|x| x.ln()).sum())],
        );
        run(
            "flux",
            Flux { c: 0.3 }.at(0.01, n).unwrap(),
            (0..n).map(|i| 0.2 + 0.1 * s(i, 1.0)).collect(),
            |c, x| vec![("total", c.integrals(x)[0])],
        );
        run("wave", Wave { h: 0.5 }.at(0.05, n).unwrap(), pairs(0.0, 0.0), |c, x| {
            vec![("momentum", c.integrals(x)[0])]
        });
        run("fput", Fput { alpha: 0.25 }.at(0.05, n).unwrap(), pairs(0.0, 0.0), |c, x| {
            vec![("momentum", c.integrals(x)[0]), ("H", c.hamiltonian(x)), ("modified", c.modified_energy(x))]
        });
        run("fput open", FputOpen { alpha: 0.25 }.at(0.05, n).unwrap(), pairs(0.0, 0.0), |c, x| {
            vec![("H", c.hamiltonian(x)), ("modified", c.modified_energy(x))]
        });
    }
}
