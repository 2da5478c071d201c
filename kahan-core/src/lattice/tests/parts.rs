//! In parts and in one elimination: the same step.

use std::vec::Vec;

use crate::LatticeMap;

use super::families::{Kdv, Toda, Volterra};

fn state(len: usize) -> Vec<f64> {
    (0..len).map(|i| 1.0 + 0.5 * (0.37 * i as f64).sin()).collect()
}

fn compare<M: LatticeMap<f64>>(map: &M, sites: usize, eps: f64) {
    let x = state(sites * M::BLOCK);
    let mut at = map.at(eps, sites).expect("sites");
    let mut next = x.clone();
    at.step(&mut next);
    let residual = at.residual(&x, &next);
    assert!(residual < 1e-15, "{sites} sites: {residual:e}");
    assert_eq!(at.whole_eliminations(), u64::from(sites < 100 * M::REACH));
}

#[test]
fn parts_step_as_the_whole() {
    for sites in [10, 100, 1000, 2048, 3001, 10007] {
        compare(&Volterra, sites, 0.05);
        compare(&Toda, sites, 0.05);
        compare(
            &Kdv { inverse: 1.5, dispersion: (0..sites).map(|i| 1.0 + 0.1 * (i % 7) as f64).collect() },
            sites,
            0.05,
        );
    }
}
