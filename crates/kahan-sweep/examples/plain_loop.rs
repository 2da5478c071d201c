//! Times a sweep of E6 by direct calls of `kahan_runtime`, for comparison with `kahan-sweep`.

use std::sync::Mutex;
use std::time::Instant;

use kahan_runtime::threads::for_each;
use kahan_runtime::{Field, IntegralDrift, MapAt, WhileFinite};

const STEPS: u64 = 1000;
const CHUNK: usize = 256;

/// Computes for each start `x` the largest drift of an integral, and returns the sum.
fn drifts(at: &MapAt<f64>, mut x: Vec<f64>) -> f64 {
    let (mut y, mut z) = (vec![0.3; x.len()], vec![0.7; x.len()]);
    let observers = |_| WhileFinite::new(IntegralDrift::of(at));
    let found = MapAt::observe_columns(&[at], &mut [&mut x, &mut y, &mut z], STEPS, observers);
    found.expect("three variables").iter().map(|followed| followed.report[0].max).sum()
}

fn main() {
    let points: usize = std::env::args().nth(1).and_then(|points| points.parse().ok()).unwrap_or(100_000);
    let entry = kahan_systems::registry::find("e6").expect("the catalog");
    let field = Field::parse(entry.text()).expect("the catalog");
    let at = field.map().expect("no parameters").at(0.02);
    let begun = Instant::now();
    let sum = Mutex::new(0.0f64);
    for_each(points.div_ceil(CHUNK), None, &|chunk| {
        let indices = chunk * CHUNK..points.min((chunk + 1) * CHUNK);
        let own = drifts(&at, indices.map(|index| -1.0 + 2.0 * index as f64 / points as f64).collect());
        *sum.lock().expect("no thread panics") += own;
    });
    println!("{:.3}", begun.elapsed().as_secs_f64());
    assert!(sum.into_inner().expect("no thread panics") >= 0.0);
}
