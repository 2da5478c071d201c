//! Tests Kahan's defining equation exactly over rationals.

use std::vec::Vec;

use num_rational::BigRational;

use crate::{Constant, LatticeMap, Scalar};

use super::families::{Kdv, Tangled, Toda, Volterra};
use super::random;

type Q = BigRational;

fn q(p: i64, d: i64) -> Q {
    Q::constant(&Constant::ratio(p, d))
}

fn state(len: usize) -> Vec<Q> {
    (0..len as i64).map(|i| q(3 + (7 * i * i + 5 * i) % 11, 2 + (3 * i) % 5)).collect()
}

/// Tests (x̃ − x)/(2ε) = 2f(½(x + x̃)) − ½f(x) − ½f(x̃) for a step from x to x̃, and its inverse.
fn satisfies_kahans_equation<M: LatticeMap<Q>>(fewest: usize, most: usize, map: impl Fn(usize) -> M) {
    for sites in fewest..=most {
        let eps = q(2, 17);
        let mut at = map(sites).at(eps.clone(), sites).expect("sites");
        let x = state(sites * M::BLOCK);
        let mut next = x.clone();
        at.step(&mut next);
        assert_ne!(next, x);
        let middle: Vec<Q> = x.iter().zip(&next).map(|(x, y)| (x + y) * q(1, 2)).collect();
        let fields = [at.field(&middle), at.field(&x), at.field(&next)];
        for k in 0..x.len() {
            let polarised = &fields[0][k] * q(2, 1) - (&fields[1][k] + &fields[2][k]) * q(1, 2);
            assert_eq!((&next[k] - &x[k]) / (&eps + &eps), polarised, "{sites} sites, entry {k}");
        }
        assert_eq!(at.residual(&x, &next), q(0, 1));
        let mut other = next.clone();
        other[0] += q(1, 1000);
        assert_ne!(at.residual(&x, &other), q(0, 1));
        at.step_back(&mut next);
        assert_eq!(next, x, "{sites} sites");
    }
}

fn kdv<const OPEN: bool>(sites: usize) -> Kdv<Q, OPEN> {
    Kdv { inverse: q(3, 2), dispersion: (0..sites).map(|i| q(1 + i as i64, 3)).collect() }
}

fn tangled<const OPEN: bool>(_sites: usize) -> Tangled<Q, OPEN> {
    Tangled(core::array::from_fn(|term| q(2 - 3 * (term as i64 % 3), 1 + term as i64)))
}

#[test]
fn steps_satisfy_kahans_equation_at_every_length() {
    satisfies_kahans_equation(1, 12, |_| Toda::<true>);
    satisfies_kahans_equation(2, 12, |_| Toda::<false>);
    satisfies_kahans_equation(2, 12, |_| Volterra::<true>);
    satisfies_kahans_equation(3, 12, |_| Volterra::<false>);
    satisfies_kahans_equation(2, 12, kdv::<true>);
    satisfies_kahans_equation(3, 12, kdv::<false>);
    satisfies_kahans_equation(1, 6, tangled::<true>);
    satisfies_kahans_equation(1, 6, tangled::<false>);
}

fn rational(x: f64) -> Q {
    Q::from_float(x).expect("finite")
}

/// Tests the bound of `try_step` at random states. `exact` is the map over rationals.
fn keeps_its_promise<M, E>(map: &M, exact: &E, sites: usize, most_entries: usize)
where
    M: LatticeMap<f64>,
    E: LatticeMap<Q>,
{
    let mut succeeded = 0;
    for (round, eps) in [1e-6, 1e-3, 0.1, 1.0, 30.0, 1e3].into_iter().enumerate() {
        let mut at = map.at(eps, sites).expect("sites");
        let x: Vec<f64> = random(round as u64)
            .take(sites * <M as LatticeMap<f64>>::BLOCK)
            .map(|bits| {
                let size = 2f64.powf((bits >> 11) as f64 / (1_u64 << 51) as f64 - 2.0);
                if bits % 3 == 0 { -size } else { size }
            })
            .collect();
        let mut next = x.clone();
        if at.try_step(&mut next).is_err() {
            assert_eq!(next, x);
            continue;
        }
        succeeded += 1;
        let [x, next] = [x, next].map(|state| state.into_iter().map(rational).collect::<Vec<_>>());
        let residual = exact.at(rational(eps), sites).expect("sites").residual(&x, &next);
        let promise = rational((most_entries as f64 + 8.0) * f64::EPSILON / 2.0);
        assert!(residual <= promise, "{sites} sites, eps = {eps}: {:e}", residual.approximate());
        assert!(residual > q(0, 1));
    }
    assert!(succeeded >= 5, "{succeeded} of 6 at {sites} sites");
}

#[test]
fn promised_steps_keep_their_promise() {
    for sites in [3, 4, 17, 100, 200, 400] {
        keeps_its_promise(&Volterra::<false>, &Volterra::<false>, sites, 3);
        keeps_its_promise(&Volterra::<true>, &Volterra::<true>, sites, 3);
        keeps_its_promise(&Toda::<true>, &Toda::<true>, sites, 3);
    }
    for sites in [3, 8, 70] {
        let coefficients = core::array::from_fn(|term| 0.5 - 0.125 * term as f64);
        let exact = coefficients.map(rational);
        keeps_its_promise(&Tangled::<_, false>(coefficients), &Tangled::<_, false>(exact), sites, 16);
    }
}

/// At the last sites the numbers `x` are so small that their products underflow.
#[test]
fn promises_hold_for_the_smallest_numbers() {
    let x: Vec<f64> = (0..40).map(|i| 0.5_f64.powi(26 * i)).collect();
    let mut next = x.clone();
    Volterra::<true>.at(0.0625, 40).expect("sites").try_step(&mut next).expect("no pole");
    let [x, next] = [x, next].map(|state| state.into_iter().map(rational).collect::<Vec<_>>());
    let residual = Volterra::<true>.at(rational(0.0625), 40).expect("sites").residual(&x, &next);
    assert!(residual <= rational(11.0 * f64::EPSILON / 2.0), "{:e}", residual.approximate());
}

/// The squares of the numbers overflow, and elimination over floats gives no result.
#[test]
fn promises_hold_for_the_largest_numbers() {
    let size = 1010_f64.exp2();
    let eps = (-1012_f64).exp2();
    for sites in [4, 40, 300] {
        let x: Vec<f64> = (0..sites).map(|i| size * (1.0 + 0.375 * (i * i % 5) as f64)).collect();
        let mut next = x.clone();
        Volterra::<true>.at(eps, sites).expect("sites").try_step(&mut next).expect("no pole");
        let [x, next] = [x, next].map(|state| state.into_iter().map(rational).collect::<Vec<_>>());
        let residual = Volterra::<true>.at(rational(eps), sites).expect("sites").residual(&x, &next);
        assert!(residual <= rational(11.0 * f64::EPSILON / 2.0), "{:e}", residual.approximate());
    }
}

/// If the bound of one row is NaN, the step fails even if the next row has a good bound.
#[test]
fn one_site_that_is_no_number_refuses_the_step() {
    for site in 0..5 {
        let dispersion: Vec<f64> = (0..5).map(|i| if i == site { f64::NAN } else { 0.5 }).collect();
        let map = Kdv::<_, false> { inverse: 1.5, dispersion };
        let mut x = [0.5, 0.25, 0.125, 0.75, 0.625];
        assert!(map.at(0.0625, 5).expect("sites").try_step(&mut x).is_err(), "site {site}");
        assert_eq!(x, [0.5, 0.25, 0.125, 0.75, 0.625]);
    }
}

#[test]
fn a_ring_of_one_or_two_volterra_sites_stands_still() {
    for sites in 1..=2 {
        let mut x = state(sites);
        Volterra::<false>.at(q(1, 3), sites).expect("sites").step(&mut x);
        assert_eq!(x, state(sites));
    }
}

#[test]
fn a_pole_is_an_error_and_leaves_the_state() {
    // One open Toda site has det A = 1 + εb + 4ε²a², which is 0 at a = 0, b = −3, ε = 1/3.
    let mut x = [q(0, 1), q(-3, 1)];
    let mut at = Toda::<true>.at(q(1, 3), 1).expect("a site");
    assert!(at.try_step(&mut x).is_err());
    assert_eq!(x, [q(0, 1), q(-3, 1)]);
}
