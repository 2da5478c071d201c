//! Tests that a trajectory's bits depend on neither neighbours, index nor threads.

use kahan_core::prelude::*;
use kahan_core::{Ensemble, Reciprocal};

use crate::ensemble::in_lanes::E3;
use crate::ensemble::{assert_same, levels, points};
use crate::systems::LotkaVolterra;

const STEPS: u64 = if cfg!(miri) { 1 } else { 10 };

#[test]
fn what_is_not_finite_stays_alone() {
    let map = E3.at(0.125);
    let ordinary = points::<3>(if cfg!(miri) { 20 } else { 600 });
    let mut disturbed = ordinary.clone();
    for (k, i) in (0..disturbed.len()).step_by(5).enumerate() {
        disturbed[i][k / 3 % 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY][k % 3];
    }
    for level in levels() {
        // Miri does not support the instruction that estimates a reciprocal.
        let estimated = if cfg!(miri) { Reciprocal::Divided } else { Reciprocal::Estimated };
        for reciprocal in [Reciprocal::Divided, estimated] {
            let [alone, beside] = [&ordinary, &disturbed].map(|points| {
                let ensemble = Ensemble::new(points.clone()).at_level(level).expect("it is available");
                let mut ensemble = ensemble.with_reciprocal(reciprocal);
                ensemble.advance(&map, STEPS);
                ensemble.points().collect::<Vec<_>>()
            });
            for (i, (alone, beside)) in alone.into_iter().zip(beside).enumerate() {
                let finite = beside.iter().all(|entry| entry.is_finite());
                assert_eq!(finite, i % 5 != 0, "point {i} at {level:?}");
                assert!(!finite || alone == beside, "point {i} at {level:?}");
            }
        }
    }
}

#[test]
fn the_place_of_a_trajectory_does_not_matter() {
    let map = LotkaVolterra.at(0.125);
    let start = points::<2>(if cfg!(miri) { 25 } else { 1037 });
    for level in levels() {
        let mut ensemble = Ensemble::new(start.clone()).at_level(level).expect("it is available");
        ensemble.advance(&map, STEPS);
        for skipped in [1, 19] {
            let mut later =
                Ensemble::new(start[skipped..].to_vec()).at_level(level).expect("it is available");
            later.advance(&map, STEPS);
            assert_same(&later, &ensemble.points().skip(skipped).collect::<Vec<_>>());
        }
    }
}

#[test]
fn the_number_of_threads_does_not_matter() {
    let map = E3.at(0.125);
    let (count, steps) = if cfg!(miri) { (64, 2) } else { (12_000, 20) };
    for level in levels() {
        let start = Ensemble::new(points::<3>(count)).at_level(level).expect("it is available");
        let [one, two, five] = [1, 2, 5].map(|threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            let mut ensemble = start.clone();
            pool.install(|| ensemble.advance(&map, steps));
            ensemble
        });
        let expected: Vec<_> = one.points().collect();
        assert_same(&two, &expected);
        assert_same(&five, &expected);
        let mut in_turn = start.clone();
        for _ in 0..steps {
            in_turn.advance(&map, 1);
        }
        assert_same(&in_turn, &expected);
    }
}
