//! When sums and products of several values are ready: estimates that compare plans, beside their
//! [cost](kahan_program::cost).

use std::cmp::Reverse;

use kahan_program::cost::{ADD, MULTIPLY};
use kahan_syntax::table::sorted_by_key;

/// What a prepared constant that was rounded more than once costs, in operations.
pub(super) const DERIVED: usize = 3;

/// When the sum of values is ready, the earliest two added first.
pub(super) fn gathered(ready: &[u32]) -> u32 {
    combined(ready.to_vec(), ADD)
}

/// When the product of values is ready, the earliest two multiplied first.
pub(super) fn multiplied(ready: Vec<u32>) -> u32 {
    combined(ready, MULTIPLY)
}

/// When one value is left of these, two becoming one after so many cycles.
fn combined(all: Vec<u32>, latency: u32) -> u32 {
    let mut ready = sorted_by_key(all, |at| Reverse(*at));
    // The earliest two stand last.
    while let [.., later, _] = ready[..] {
        ready.truncate(ready.len() - 2);
        let at = later + latency;
        ready.insert(ready.partition_point(|other| *other >= at), at);
    }
    ready.first().copied().unwrap_or(0)
}
