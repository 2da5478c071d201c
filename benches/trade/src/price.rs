//! What settings cost, by the clock, in turns.

use std::hint::black_box;
use std::time::Instant;

use kahan_core::ExtendScalars;
use kahan_core::prelude::*;

use super::scene::{Scene, Setting};

/// Rounds, in each of which every setting has its turn; the least time counts, since nothing makes
/// a step faster than it is.
const ROUNDS: usize = 60;

/// By what factor a price measured here may differ from the one that the command names, which times
/// machine code with the same operations. A compiler packs operations and spills registers as it
/// likes, above all in single precision: factors from 0.9 to 2.1 were seen. A program whose crates
/// are not optimised together takes 3.6 times as long, one that is not optimised a hundred times.
pub(crate) const NEAR: f64 = 2.5;

/// Nanoseconds a unit of time of each setting, and the pace of the machine meanwhile.
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

/// Seconds of a loop that is always the same, multiplications and additions that wait for each
/// other: prices that are taken at different times are compared relative to it.
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
