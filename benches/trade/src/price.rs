//! Measures the prices of settings, which are timed alternately.

use std::hint::black_box;
use std::time::Instant;

use kahan_core::ExtendScalars;
use kahan_core::prelude::*;

use super::scene::{Scene, Setting};

/// The number of rounds, in which all settings alternate. The least time counts, because
/// disturbances only slow a step down.
const ROUNDS: usize = 60;

/// The largest permitted quotient of a price measured here and the command's price. The command
/// times machine code with equal operations. Compilers pack and spill registers differently, above
/// all in single precision: quotients from 0.9 to 2.1 were measured. Crates that are not optimised
/// together take 3.6 times as long, and unoptimised programs a hundred times.
pub(crate) const NEAR: f64 = 2.5;

/// Returns the price of each setting in nanoseconds per unit of time, and the speed of the machine.
pub(crate) fn side_by_side<M: ExtendScalars<BigRational, N>, const N: usize>(
    scene: &Scene<M, N>,
    settings: &[Setting],
) -> (Vec<f64>, f64) {
    let (mut prices, mut least) = (vec![f64::INFINITY; settings.len()], f64::INFINITY);
    for _ in 0..ROUNDS {
        least = least.min(pace());
        for (price, setting) in prices.iter_mut().zip(settings) {
            *price = price.min(scene.price(setting));
        }
    }
    (prices, least)
}

/// Returns the seconds that a fixed loop of dependent operations takes. Prices measured at
/// different times are normalised by this time.
pub(crate) fn pace() -> f64 {
    let turn = || {
        let clock = Instant::now();
        let mut x = black_box(0.3_f64);
        for _ in 0..10_000 {
            x = 0.5 * x * (1.0 - x) + 0.25;
        }
        black_box(x);
        clock.elapsed().as_secs_f64()
    };
    (0..8).map(|_| turn()).fold(f64::INFINITY, f64::min)
}
