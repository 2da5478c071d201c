//! Tests that steps in parts agree with one elimination.

use std::vec::Vec;

use crate::ensemble::Level;
use crate::lattice::LatticeAt;
use crate::lattice::parts::Partition;
use crate::{LatticeMap, LatticeScalar};

use super::families::{Kdv, Tangled, Toda, Volterra};

fn state(len: usize) -> Vec<f64> {
    (0..len).map(|i| 1.0 + 0.5 * (0.37 * i as f64).sin()).collect()
}

fn kdv<const OPEN: bool>(sites: usize) -> Kdv<f64, OPEN> {
    Kdv { inverse: 1.5, dispersion: (0..sites).map(|i| 1.0 + 0.1 * (i % 7) as f64).collect() }
}

fn tangled<const OPEN: bool>(_sites: usize) -> Tangled<f64, OPEN> {
    Tangled(core::array::from_fn(|term| 0.5 - 0.125 * term as f64))
}

/// Takes steps in short parts; therefore few sites already form several groups.
pub(super) fn in_short_parts<M: LatticeMap<f64>>(
    map: M,
    eps: f64,
    sites: usize,
    level: Level,
) -> LatticeAt<M, f64> {
    let reach = M::REACH;
    let partition = Partition::with_length(sites, reach, 8, 8 * reach, 1);
    LatticeAt::with_partition(map, eps, sites, partition).expect("sites").at_level(level).expect("asked for")
}

fn levels() -> impl Iterator<Item = Level> {
    [Level::Baseline, Level::Avx2, Level::Avx512, Level::Neon]
        .into_iter()
        .filter(|level| level.is_available())
}

/// Compares steps in parts with one elimination, in the maximum norm.
fn agree<M: LatticeMap<f64>>(map: impl Fn(usize) -> M, sites: impl Iterator<Item = usize>, eps: f64) {
    for sites in sites {
        let x = state(sites * M::BLOCK);
        let mut expected = x.clone();
        let mut whole = LatticeAt::with_partition(map(sites), eps, sites, None).expect("sites");
        whole.step(&mut expected);
        assert_eq!(whole.whole_eliminations(), 1);
        let mut fused = None;
        for level in levels() {
            let mut next = x.clone();
            let mut at = in_short_parts(map(sites), eps, sites, level);
            at.step(&mut next);
            let is_short = sites < 25 * M::REACH;
            assert_eq!(at.whole_eliminations(), u64::from(is_short), "{sites} sites");
            for (a, b) in next.iter().zip(&expected) {
                assert!((a - b).abs() <= 16.0 * f64::EPSILON, "{sites} sites on {level:?}: {a} and {b}");
            }
            if level != Level::Baseline {
                assert_eq!(*fused.get_or_insert(next.clone()), next, "{sites} sites on {level:?}");
            }
            at.step_back(&mut next);
            for (a, b) in next.iter().zip(&x) {
                assert!((a - b).abs() <= 32.0 * f64::EPSILON, "{sites} sites back on {level:?}: {a} and {b}");
            }
        }
    }
}

#[test]
fn parts_step_as_the_whole_wherever_the_cuts_are() {
    agree(|_| Volterra::<false>, (1..300).step_by(if cfg!(miri) { 97 } else { 1 }), 0.05);
    agree(|_| Volterra::<true>, (1..300).step_by(3), 0.05);
    agree(|_| Toda::<false>, (1..300).step_by(5), 0.05);
    agree(|_| Toda::<true>, (1..300).step_by(7), 0.05);
    agree(kdv::<false>, (1..600).step_by(11), 0.02);
    agree(kdv::<true>, (1..600).step_by(13), 0.02);
    agree(tangled::<false>, [1, 7, 124, 125, 126, 700, 801].into_iter(), 0.002);
    agree(tangled::<true>, [1, 7, 124, 125, 126, 700, 801].into_iter(), 0.002);
}

#[test]
fn long_chains_are_cut_into_parts() {
    for sites in [1000, 2048, 3001, 10007] {
        let mut x = state(sites);
        let start = x.clone();
        let mut at = Volterra::<false>.at(0.05, sites).expect("sites");
        at.step(&mut x);
        assert_eq!(at.whole_eliminations(), 0);
        assert!(at.residual(&start, &x) < 8.0 * f64::EPSILON);
    }
}

/// For each i, the entries of A in column i and rows i, i + 1 are 0, although A is not singular.
#[test]
fn a_singular_part_sends_the_step_to_the_whole() {
    let (sites, eps) = (200, 0.125);
    let mut sent = 0;
    for i in 0..sites {
        let mut x = state(sites);
        x[(i + sites - 1) % sites] = -1.0 / eps;
        x[(i + 1) % sites] = 0.0;
        let start = x.clone();
        let mut at = in_short_parts(Volterra::<false>, eps, sites, Level::best());
        at.step(&mut x);
        sent += at.whole_eliminations();
        // The bound is 2·2¹⁰: entries of A are at most 2, and factors at most 2¹⁰.
        assert!(at.residual(&start, &x) < 2048.0 * f64::EPSILON, "site {i}");
        let mut tried = start.clone();
        assert_eq!(at.try_step(&mut tried), Ok(()));
    }
    assert_eq!(sent, 24);
}

#[test]
fn what_is_no_number_stays_so() {
    for sites in [5, 500] {
        let mut x = state(sites);
        x[sites / 2] = f64::NAN;
        let mut at = Volterra::<false>.at(0.05, sites).expect("sites");
        let before = x.clone();
        assert!(at.try_step(&mut x).is_err());
        assert!(x.iter().zip(&before).all(|(a, b)| a.to_bits() == b.to_bits()));
        for _ in 0..3 {
            at.step(&mut x);
            assert!(x[sites / 2].is_nan());
        }
        assert!(at.residual(&before, &before).is_nan());
    }
}

#[test]
#[should_panic(expected = "a state of 7 numbers: 8 sites of 1 arrays take 8")]
fn a_state_of_another_length_panics() {
    Volterra::<false>.at(0.05, 8).expect("sites").step(&mut [1.0; 7]);
}

#[test]
fn other_floats_step_alike() {
    fn check<T: LatticeScalar + Copy>(from: impl Fn(f64) -> T, to: impl Fn(T) -> f64, unit: f64) {
        for sites in [9, 1500] {
            let mut x: Vec<T> = state(sites).into_iter().map(&from).collect();
            let start = x.clone();
            let mut at = Volterra::<false>.at(from(0.0625), sites).expect("sites");
            at.step(&mut x);
            assert!(to(at.residual(&start, &x)) <= 16.0 * unit);
            let mut tried = start.clone();
            assert_eq!(at.try_step(&mut tried), Ok(()));
            assert!(to(at.residual(&start, &tried)) <= 16.0 * unit);
        }
    }
    check(|x| x as f32, f64::from, f64::from(f32::EPSILON));
    check(crate::Dd::from, f64::from, f64::EPSILON * f64::EPSILON);
}

#[cfg(feature = "parallel")]
#[test]
fn threads_change_no_bit() {
    let sites = 100_000;
    let step = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| {
            let mut x = state(sites);
            kdv::<false>(sites).at(0.02, sites).expect("sites").advance(&mut x, 3);
            x
        })
    };
    assert_eq!(step(1), step(3));
}
