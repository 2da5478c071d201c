//! Applies one function to three maps of springs: Kahan's map, a composition of order eight, and a
//! chain.

use kahan_core::observe::first_crossing;
use kahan_core::prelude::*;
use kahan_core::{Composition, KahanAt, Step};

kahan! {
    /// A mass on a spring.
    struct Spring;
    qdot = p;
    pdot = -q;
}

kahan! {
    /// Masses on springs, each coupled to its two neighbours by further springs.
    struct Springs;
    for i in periodic { q[i]dot = p[i]; p[i]dot = q[i-1] - 2*q[i] + q[i+1] - q[i]; }
}

struct Clock {
    spring: KahanAt<Spring, f64, 2>,
    hand: SVector<f64, 2>,
}

/// Returns the time of the first zero of `x[0]` on the orbit from `start`, if there is one.
fn zero<M: Step<Scalar = f64>>(map: M, start: M::State) -> Option<f64> {
    first_crossing(map, start, 100_000, |x| x[0]).map(|crossing| crossing.time)
}

/// Prints and returns four computed times of the first zero of a position; the exact time is π/2.
pub(crate) fn run() -> [f64; 4] {
    let eps = 0.01; // half the time step
    let clock = Clock { spring: Spring.at(eps), hand: vector![1.0, 0.0] };
    let by_type = zero(&clock.spring, clock.hand).expect("it swings");

    let chain = LatticeMap::at(&Springs, eps, 8).expect("a chain of eight");
    let order_eight = clock.spring.composed(Composition::KAHAN_LI_8);
    let maps: [(&str, Box<dyn Step<Scalar = f64>>); 3] =
        [("plain", Box::new(clock.spring)), ("order 8", Box::new(order_eight)), ("chain", Box::new(chain))];
    let [plain, of_order_eight, of_chain] = maps.map(|(name, map)| {
        // All masses start alike; therefore the springs between them stay relaxed.
        let start = [1.0, 0.0].repeat(map.dimension() / 2);
        let time = zero(&*map, start).expect("it swings");
        println!("{name:8} {time:.15}");
        time
    });
    [by_type, plain, of_order_eight, of_chain]
}

fn main() {
    run();
}
