//! The calls of `kahan_runtime` that a sweep of E6 makes, in a loop of one's own: what a sweep's
//! time is measured against. It prints the seconds that it took.

use std::time::Instant;

use kahan_core::observe::{Drift, Observer};
use kahan_runtime::threads::for_each;
use kahan_runtime::{Field, MapAt};

const STEPS: u64 = 1000;
const CHUNK: usize = 256;

fn drift(at: &MapAt<f64>, start: [f64; 3]) -> [f64; 4] {
    let own: fn(&[f64]) -> [f64; 1] = |value| [value[0]];
    let mut drifts = [Drift::of(own), Drift::of(own)];
    let (mut x, mut values) = (start, [0.0; 2]);
    for step in 0..=STEPS {
        at.integrals(&x, &mut values).expect("three variables");
        for (drift, value) in drifts.iter_mut().zip(&values) {
            drift.observe(step, std::slice::from_ref(value));
        }
        at.advance(&mut x, 1).expect("three variables");
    }
    let [[h], [k]] = drifts.map(Observer::report);
    [h.max, h.last, k.max, k.last]
}

fn main() {
    let points: usize = std::env::args().nth(1).and_then(|points| points.parse().ok()).unwrap_or(100_000);
    let entry = kahan_systems::registry::find("e6").expect("the catalog");
    let field = Field::parse(entry.text()).expect("the catalog");
    let at = field.map().expect("no parameters").at(0.02);
    let begun = Instant::now();
    let sum = std::sync::Mutex::new(0.0f64);
    for_each(points.div_ceil(CHUNK), None, &|chunk| {
        let mut own = 0.0;
        for index in chunk * CHUNK..points.min((chunk + 1) * CHUNK) {
            let x = -1.0 + 2.0 * index as f64 / points as f64;
            own += drift(&at, [x, 0.3, 0.7])[0];
        }
        *sum.lock().expect("no thread panics") += own;
    });
    println!("{:.3}", begun.elapsed().as_secs_f64());
    assert!(sum.into_inner().expect("no thread panics") >= 0.0);
}
