//! The tasks that are timed. A unit of work is [`POINTS`] steps, divisions or multiply-adds.

use std::hint::black_box;
use std::time::Instant;

use kahan_bench_fields::serve::Task;
use kahan_bench_fields::{self as fields, EPS, start};
use kahan_core::prelude::*;
use kahan_core::{Ensemble, KahanAt, Level, Reciprocal};

use crate::bounds;
use crate::counted::operations;

/// The number of trajectories, chosen so that their states fit into the first-level cache.
pub(crate) const POINTS: usize = 512;

const SEGMENT: usize = 1024;

pub(crate) fn all() -> Vec<Task> {
    let mut tasks = bounds();
    tasks.extend(system("LotkaVolterra", fields::LotkaVolterra, start::LOTKA_VOLTERRA));
    tasks.extend(system("EulerTop", fields::euler_top(), start::SPACE));
    tasks.extend(system("E1", fields::E1, start::SPACE));
    tasks.extend(system("E3", fields::E3, start::SPACE));
    tasks.extend(system("E6", fields::E6, start::SPACE));
    tasks
}

fn timed(run: impl FnOnce()) -> f64 {
    let begun = Instant::now();
    run();
    begun.elapsed().as_secs_f64()
}

fn bounds() -> Vec<Task> {
    let task = |what, run: fn(usize)| Task {
        system: "bound",
        what,
        operations: 0,
        seconds: Box::new(move |units| timed(|| run(units * POINTS))),
    };
    let mut tasks = Vec::new();
    if Level::Avx2.is_available() {
        tasks.push(task("divisions, AVX2", bounds::divisions_avx2));
    }
    if Level::Avx512.is_available() {
        tasks.push(task("multiply-adds, AVX-512", bounds::multiply_adds_avx512));
    }
    tasks
}

fn system<M, const N: usize>(name: &'static str, map: M, start: [f64; N]) -> Vec<Task>
where
    M: KahanMap<f64, N> + Sync + Copy + 'static,
    M::Prepared: Sync,
{
    let points = (0..POINTS).map(|k| SVector::from(start.map(|x| x * (1.0 + 1e-4 * k as f64)))).collect();
    let ensemble = Ensemble::new(points);
    let at = map.at(EPS);
    let operations = operations(at.prepared());
    let advance = |what, ensemble: Ensemble<f64, N>| Task {
        system: name,
        what,
        operations,
        seconds: Box::new(move |steps| advance(&ensemble, &map.at(EPS), steps)),
    };
    let mut tasks = vec![Task {
        system: name,
        what: "single trajectory",
        operations,
        seconds: Box::new(move |units| single(start, &map.at(EPS), units * POINTS)),
    }];
    tasks.push(advance("ensemble", ensemble.clone()));
    let levels = [
        ("ensemble, baseline", Level::Baseline),
        ("ensemble, AVX2", Level::Avx2),
        ("ensemble, AVX-512", Level::Avx512),
    ];
    for (what, level) in levels {
        tasks.extend(ensemble.clone().at_level(level).map(|ensemble| advance(what, ensemble)));
    }
    if let Some(ensemble) = ensemble.at_level(Level::Avx512) {
        tasks.push(advance("ensemble, AVX-512, estimated", ensemble.with_reciprocal(Reciprocal::Estimated)));
    }
    tasks
}

fn advance<M, const N: usize>(ensemble: &Ensemble<f64, N>, at: &KahanAt<M, f64, N>, steps: usize) -> f64
where
    M: KahanMap<f64, N> + Sync,
    M::Prepared: Sync,
{
    let mut seconds = 0.0;
    for done in (0..steps).step_by(SEGMENT) {
        let mut ensemble = ensemble.clone();
        seconds += timed(|| ensemble.advance(black_box(at), SEGMENT.min(steps - done) as u64));
        black_box(&ensemble);
    }
    seconds
}

fn single<M: KahanMap<f64, N>, const N: usize>(
    start: [f64; N],
    at: &KahanAt<M, f64, N>,
    steps: usize,
) -> f64 {
    let at = black_box(at);
    timed(|| {
        for done in (0..steps).step_by(SEGMENT) {
            let mut x = black_box(SVector::from(start));
            for _ in 0..SEGMENT.min(steps - done) {
                x = at.step(&x);
            }
            black_box(x);
        }
    })
}
