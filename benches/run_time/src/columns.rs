//! Times many trajectories together, by the macro's code and by machine code made at run time.

use std::hint::black_box;

use kahan_bench_fields::EPS;
use kahan_bench_fields::serve::Task;
use kahan_core::prelude::*;
use kahan_core::{Ensemble, Level};
use kahan_runtime::MapAt;

use crate::pair::{Pair, in_segments, timed};

/// The number of trajectories, as in the benchmark of ensembles.
const POINTS: usize = 512;

pub(crate) fn of<M, const N: usize>(pair: &Pair<M, N>) -> Vec<Task>
where
    M: KahanMap<f64, N> + Sync + Copy + 'static,
    M::Prepared: Sync,
{
    let &Pair { system, generated, ref read, start } = pair;
    let points = (0..POINTS).map(|k| SVector::from(start.map(|x| x * (1.0 + 1e-4 * k as f64)))).collect();
    let ensemble = Ensemble::new(points);
    let columns: [Vec<f64>; N] = std::array::from_fn(|i| ensemble.column(i).to_vec());
    let at = read.at(EPS);
    let levels = [
        ("macro: ensemble, baseline", "run time: ensemble, baseline", Level::Baseline),
        ("macro: ensemble, AVX2", "run time: ensemble, AVX2", Level::Avx2),
        ("macro: ensemble, AVX-512", "run time: ensemble, AVX-512", Level::Avx512),
    ];
    let mut tasks = vec![
        of_macro(system, "macro: ensemble", generated, ensemble.clone()),
        of_run_time(system, "run time: ensemble", at.clone(), columns.clone()),
    ];
    for (of_the_macro, at_run_time, level) in levels {
        if let (Some(ensemble), Some(at)) = (ensemble.clone().at_level(level), at.at_level(level)) {
            tasks.push(of_macro(system, of_the_macro, generated, ensemble));
            tasks.push(of_run_time(system, at_run_time, at, columns.clone()));
        }
    }
    tasks
}

fn of_macro<M, const N: usize>(
    system: &'static str,
    what: &'static str,
    generated: M,
    ensemble: Ensemble<f64, N>,
) -> Task
where
    M: KahanMap<f64, N> + Sync + 'static,
    M::Prepared: Sync,
{
    in_segments(system, what, move |steps| {
        let (at, mut ensemble) = (generated.at(EPS), ensemble.clone());
        let seconds = timed(|| ensemble.advance(black_box(&at), steps as u64));
        black_box(&ensemble);
        seconds
    })
}

fn of_run_time<const N: usize>(
    system: &'static str,
    what: &'static str,
    at: MapAt<f64>,
    columns: [Vec<f64>; N],
) -> Task {
    in_segments(system, what, move |steps| {
        let mut columns = columns.clone();
        let mut columns = columns.each_mut().map(Vec::as_mut_slice);
        let seconds = timed(|| {
            at.advance_columns(&mut columns, &[], &[], steps as u64).expect("a column for each variable");
        });
        black_box(&columns);
        seconds
    })
}
