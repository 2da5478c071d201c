//! Uses one map on many threads.

use std::thread::scope;

use kahan_runtime::{Field, Map, MapAt};

use super::support::catalog;

fn orbit(at: &MapAt<f64>, k: u32) -> [f64; 3] {
    let mut x = [1.0, 0.5, 0.01 * f64::from(k)];
    at.advance(&mut x, 500).unwrap();
    x
}

#[test]
fn eight_threads_step_one_map() {
    fn is_shared<T: Send + Sync>() {}
    is_shared::<(Field, Map, MapAt<f64>, MapAt<f32>)>();

    let at = catalog("e6").map().unwrap().at(0.05);
    let alone: Vec<[f64; 3]> = (0..8).map(|k| orbit(&at, k)).collect();
    let at = catalog("e6").map().unwrap().at(0.05);
    let together: Vec<[f64; 3]> = scope(|scope| {
        let threads: Vec<_> =
            (0..8).map(|k| (k, &at)).map(|(k, at)| scope.spawn(move || orbit(at, k))).collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    assert_eq!(together, alone);
}
