//! A process that computes Lyapunov exponents and stability maps on request. `numba/exponents.py`
//! alternates between this process and loops compiled by Numba.

use std::hint::black_box;
use std::io::{self, BufRead, Write};
use std::time::Instant;

use kahan_bench_fields::Lorenz;
use kahan_bench_observers::{E6, HenonHeiles, MAP_EPS, cells};
use kahan_core::ExtendScalars;
use kahan_core::observe::{Lyapunov, Sali};
use kahan_core::prelude::*;

fn main() -> io::Result<()> {
    let mut output = io::stdout().lock();
    for line in io::stdin().lock().lines() {
        let line = line?;
        let begun = Instant::now();
        let values = answer(&line)
            .ok_or_else(|| io::Error::other(format!("not a request: {line:?}; write FIELD STEPS")))?;
        write!(output, "{:e}", begun.elapsed().as_secs_f64())?;
        for value in values {
            write!(output, " {value:e}")?;
        }
        writeln!(output)?;
        output.flush()?;
    }
    Ok(())
}

fn answer(line: &str) -> Option<Vec<f64>> {
    let (field, steps) = line.split_once(' ')?;
    let steps: u64 = steps.parse().ok()?;
    match field {
        "e6" => Some(exponent(E6, vector![0.3, 0.8, 0.5], 1.0 / 64.0, steps)),
        "lorenz" => {
            let lorenz = Lorenz { sigma: 10.0, rho: 28.0, beta: 8.0 / 3.0 };
            Some(exponent(lorenz, vector![1.0, 2.0, 20.0], 0.005, steps))
        }
        "map" => {
            let map = HenonHeiles.at(MAP_EPS);
            Some(cells(512).observe(&map, steps, |_| Sali::new(&map)))
        }
        _ => None,
    }
}

fn exponent<M: ExtendScalars<f64, 3>>(map: M, start: SVector<f64, 3>, eps: f64, steps: u64) -> Vec<f64> {
    vec![map.orbit(black_box(start), eps).observe(steps, Lyapunov::new(map.at(eps))).value]
}
