//! Measures the prices of settings, which are timed alternately.

use std::hint::black_box;
use std::time::Instant;

use kahan_core::ExtendScalars;
use kahan_core::prelude::*;

use super::scene::{Scene, Setting};

const ROUNDS: usize = 60;

/// The largest permitted ratio of a price measured here to the price that the command gives.
/// Measured ratios were between 0.9 and 2.1.
pub(crate) const NEAR: f64 = 2.5;

/// Returns the price of each setting in nanoseconds per unit of time, and the least [`pace`].
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

/// Returns the seconds of a fixed loop, by which prices at different times are normalised.
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
