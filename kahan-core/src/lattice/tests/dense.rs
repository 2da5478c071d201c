//! Checks steps of chains from random states against dense elimination with partial pivoting.

use std::ops::Range;
use std::vec::Vec;

use nalgebra::{DMatrix, DVector};

use crate::LatticeMap;
use crate::ensemble::Level;
use crate::lattice::LatticeAt;

use super::families::{Kdv, Tangled, Toda, Volterra};
use super::parts::in_short_parts;
use super::random;

/// Returns A(x,ε) = I − εf′(x). Column j of f′(x) is (f(x + heⱼ) − f(x − heⱼ))/(2h) with the unit
/// vector eⱼ, because f is quadratic.
fn matrix<M: LatticeMap<f64>>(at: &LatticeAt<M, f64>, x: &[f64], eps: f64) -> DMatrix<f64> {
    let mut a = DMatrix::identity(x.len(), x.len());
    for j in 0..x.len() {
        let field = |by: f64| {
            let mut moved = x.to_vec();
            moved[j] += by;
            DVector::from_vec(at.field(&moved))
        };
        // The offsets `by` and `-by` have about the size of x, so that few digits cancel.
        let by = x.iter().fold(1.0, |largest: f64, x| largest.max(x.abs())).log2().floor().exp2();
        let mut column = a.column_mut(j);
        column -= (field(by) - field(-by)) * (eps / (by + by));
    }
    a
}

#[derive(Debug, Default)]
struct Tally {
    compared: u32,
    nearly_singular: u32,
    whole: u64,
}

/// Compares a random step, in short parts and in one elimination, with the dense solution.
fn agrees<M: LatticeMap<f64>>(map: &M, sites: usize, eps: f64, seed: u64, tally: &mut Tally) {
    let len = sites * M::BLOCK;
    // Some states are 0 or ±1/ε, which makes entries of A vanish.
    let x: Vec<f64> = random(seed)
        .take(len)
        .map(|bits| {
            let size = 2f64.powf((bits >> 11) as f64 / (1_u64 << 51) as f64 - 2.0);
            match bits % 32 {
                0 | 1 => 0.0,
                2 if eps > 0.01 => 1.0 / eps,
                3 if eps > 0.01 => -1.0 / eps,
                even if even % 2 == 0 => -size,
                _ => size,
            }
        })
        .collect();
    let mut whole = LatticeAt::with_partition(map.clone(), eps, sites, None).expect("sites");
    let a = matrix(&whole, &x, eps);
    let field = DVector::from_vec(whole.field(&x));
    let norm = |matrix: &DMatrix<f64>| matrix.row_iter().map(|row| row.abs().sum()).fold(0.0, f64::max);
    let size = norm(&a);
    let lu = a.lu();
    let condition = size * lu.try_inverse().as_ref().map_or(f64::INFINITY, norm);
    let Some(gained) = lu.solve(&field).filter(|_| condition < 1e11) else {
        tally.nearly_singular += 1;
        return;
    };
    let gained: Vec<f64> = gained.iter().map(|w| 2.0 * eps * w).collect();
    let largest = gained.iter().chain(&x).fold(0.0, |largest: f64, w| largest.max(w.abs()));
    let mut in_parts = in_short_parts(map.clone(), eps, sites, Level::best());
    for at in [&mut whole, &mut in_parts] {
        let mut next = x.clone();
        at.step(&mut next);
        for ((next, x), gained) in next.iter().zip(&x).zip(&gained) {
            // The factor 4096 covers the backward errors of the eliminations.
            let bound = 4096.0 * f64::EPSILON * condition * largest;
            let error = (next - (x + gained)).abs();
            assert!(error <= bound, "{sites} sites, eps = {eps}, seed {seed}: {error:e} beyond {bound:e}");
        }
    }
    tally.compared += 1;
    tally.whole += in_parts.whole_eliminations();
}

fn at_random<M: LatticeMap<f64>>(rounds: u32, sites: Range<usize>, map: impl Fn(usize, u64) -> M) {
    let mut tally = Tally::default();
    let rounds = if cfg!(miri) { 2 } else { rounds };
    for (seed, bits) in random(sites.end as u64).take(rounds as usize).enumerate() {
        let sites = sites.start + (bits >> 8) as usize % sites.len();
        let eps = 10f64.powf(9.0 * (bits >> 40) as f64 / (1_u64 << 24) as f64 - 6.0);
        agrees(&map(sites, bits), sites, eps, seed as u64, &mut tally);
    }
    let cut = sites.end > 25 * M::REACH && tally.whole < u64::from(tally.compared);
    let short = sites.end <= 25 * M::REACH && tally.whole == u64::from(tally.compared);
    assert!(cfg!(miri) || (tally.compared >= rounds / 2 && (cut || short)), "{tally:?}");
}

#[test]
fn chains_step_as_dense_matrices_do() {
    at_random(10, 1..200, |_, _| Volterra::<false>);
    at_random(10, 1..200, |_, _| Volterra::<true>);
    at_random(10, 1..100, |_, _| Toda::<false>);
    at_random(10, 1..100, |_, _| Toda::<true>);
    fn kdv<const OPEN: bool>(sites: usize, bits: u64) -> Kdv<f64, OPEN> {
        let dispersion = random(bits).take(sites).map(|bits| (bits % 9) as f64 - 2.0).collect();
        Kdv { inverse: 0.5, dispersion }
    }
    at_random(10, 1..200, kdv::<false>);
    at_random(10, 1..200, kdv::<true>);
}

#[test]
fn random_couplings_step_as_dense_matrices_do() {
    fn tangled<const OPEN: bool>(_sites: usize, bits: u64) -> Tangled<f64, OPEN> {
        Tangled(core::array::from_fn(|term| {
            let bits = bits >> (4 * term);
            if bits & 1 == 0 { 0.0 } else { (bits % 16) as f64 / 8.0 - 0.9 }
        }))
    }
    at_random(2, 125..140, tangled::<false>);
    at_random(2, 125..140, tangled::<true>);
    at_random(10, 1..25, tangled::<false>);
}
