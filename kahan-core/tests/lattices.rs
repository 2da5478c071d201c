//! Compares chains with plain systems and with x̃ − x = 2εf(x, x̃), and tests their integrals.

use kahan_core::LatticeError;
use kahan_core::prelude::*;

kahan! {
    /// Volterra's chain, closed to a ring.
    pub(crate) struct Ring;
    for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }
    integral S = sum(x[i]);
}

kahan! {
    /// Volterra's chain with open ends.
    pub struct Chain;
    for i in open { x[i]dot = x[i]*(x[i+1] - x[i-1]); }
    integral S = sum(x[i]);
}

kahan! {
    /// Toda's chain in Flaschka's variables.
    pub(crate) struct Toda;
    for i in periodic {
        a[i]dot = a[i]*(b[i+1] - b[i]);
        b[i]dot = 2*(a[i]^2 - a[i-1]^2);
    }
    integral P = sum(b[i]);
}

kahan! {
    /// u_t = −6 u u_x − u_xxx by differences of width h.
    pub(crate) struct Kdv { h }
    for i in periodic {
        u[i]dot = -3*(u[i+1]^2 - u[i-1]^2)/(2*h) - (u[i+2] - 2*u[i+1] + 2*u[i-1] - u[i-2])/(2*h^3);
    }
    integral mass = sum(u[i]);
    hamiltonian H = sum((u[i+1] - u[i])^2/(2*h^2) - u[i]^3);
}

kahan! {
    /// Competing species along a shore, each with its own growth rate.
    pub(crate) struct Shore { mu, r }
    for i in open { n[i]dot = n[i]*(r[i] - n[i] - mu*(n[i-1] + n[i+1])); }
}

kahan! {
    /// Volterra's ring of four sites, written as a system with four equations.
    pub struct FourSites;
    adot = a*(b - d);
    bdot = b*(c - a);
    cdot = c*(d - b);
    ddot = d*(a - c);
}

#[test]
fn four_sites_are_the_plain_block_of_four() {
    let start = [0.5_f64, 1.25, 2.0, 0.75];
    let mut state = start.to_vec();
    LatticeMap::at(&Ring, 0.05, 4).unwrap().advance(&mut state, 10);
    let block = FourSites.orbit(SVector::from(start), 0.05).nth(10).unwrap();
    for (k, value) in state.iter().enumerate() {
        assert!((value - block[k]).abs() < 1e-13, "{state:?} {block}");
    }
}

#[test]
fn a_linear_sum_is_kept() {
    for sites in [1, 2, 3, 5, 17, 300, 3000] {
        let start: Vec<f64> = (0..sites).map(|i| 1.0 + 0.5 * (0.7 * i as f64).sin()).collect();
        let ring = LatticeMap::at(&Ring, 0.05, sites).unwrap();
        let chain = LatticeMap::at(&Chain, 0.05, sites).unwrap();
        let before = ring.integrals(&start)[0];
        let mut state = start.clone();
        ring.advance(&mut state, 100);
        assert!((ring.integrals(&state)[0] - before).abs() < 1e-13 * before, "{sites}");
        let mut state = start.clone();
        chain.advance(&mut state, 100);
        assert!((chain.integrals(&state)[0] - before).abs() < 1e-13 * before, "{sites}");
    }
}

#[test]
fn the_modified_energy_is_kept_and_the_energy_is_not() {
    let sites = 64;
    let h = 0.25;
    let map = Kdv { h };
    let mut at = map.at(0.01, sites).unwrap();
    let mut state: Vec<f64> = (0..sites)
        .map(|i| {
            let x = h * (i as f64 - 32.0);
            0.5 / (0.5 * x).cosh().powi(2)
        })
        .collect();
    let (energy, modified) = (at.hamiltonian(&state), at.modified_energy(&state));
    let mut worst = 0.0_f64;
    for _ in 0..200 {
        at.step(&mut state);
        worst = worst.max((at.hamiltonian(&state) - energy).abs());
        assert!((at.modified_energy(&state) - modified).abs() < 1e-12 * modified.abs());
    }
    assert!(worst > 1e-9);
}

#[test]
fn parameters_of_sites_are_data() {
    let sites = 40;
    let r: Vec<f64> = (0..sites).map(|i| 1.0 + 0.01 * i as f64).collect();
    let shore = Shore { mu: 0.3, r };
    let mut at = shore.at(0.1, sites).unwrap();
    let start = vec![0.5; sites];
    let mut state = start.clone();
    at.step(&mut state);
    assert!(at.residual(&start, &state) < 1e-15);
    at.step_back(&mut state);
    assert!(state.iter().zip(&start).all(|(a, b)| (a - b).abs() < 1e-14));
    assert!(shore.at(0.1, 39).is_err());
}

#[test]
fn a_field_without_a_name_takes_its_parameters_from_the_scope() {
    let mu = 0.5;
    let field = kahan! { for i in open { x[i]dot = x[i]*(mu - x[i-1] - x[i+1]); } };
    let mut state = vec![1.0; 10];
    field.at(0.05, 10).unwrap().step(&mut state);
    assert!(state[0] > state[1]);
}

#[test]
fn toda_keeps_its_momentum() {
    let sites = 30;
    let at = LatticeMap::at(&Toda, 0.02, sites).unwrap();
    let mut state: Vec<f64> = (0..2 * sites)
        .map(|k| if k % 2 == 0 { if k == 2 * sites - 2 { 0.0 } else { 0.5 } } else { (0.3 * k as f64).cos() })
        .collect();
    let before = at.integrals(&state)[0];
    at.advance(&mut state, 500);
    assert!((at.integrals(&state)[0] - before).abs() < 1e-12);
}

#[test]
fn a_divisor_of_zero_is_an_error() {
    assert_eq!(Kdv { h: 0.0_f64 }.at(0.1, 9).unwrap_err(), LatticeError::Undefined);
    assert_eq!(Kdv { h: f32::NAN }.at(0.1, 9).unwrap_err(), LatticeError::Undefined);
    assert!(Kdv { h: 1e-20 }.at(0.1, 9).is_ok());
    let [zero, one] = [0, 1].map(|p| BigRational::from_integer(p.into()));
    assert_eq!(Kdv { h: zero.clone() }.at(one.clone(), 9).unwrap_err(), LatticeError::Undefined);
    assert!(Kdv { h: one }.at(zero, 9).is_ok());
}

/// The constant 1/h³ exceeds the range of `f32`, but the step does not.
#[test]
fn constants_beyond_the_range_are_no_hindrance_to_a_promise() {
    let (h, eps, sites) = (1e-20_f32, 1e-30_f32, 9);
    let rational = |number: &f32| BigRational::from_float(*number).expect("finite");
    let before: Vec<f32> = (0..sites).map(|i| (i as f32).sin()).collect();
    let mut at = Kdv { h }.at(eps, sites).unwrap();
    let (mut plain, mut next) = (before.clone(), before.clone());
    at.step(&mut plain);
    assert!(!plain.iter().all(|number| number.is_finite()));
    at.try_step(&mut next).unwrap();
    let exact = Kdv { h: rational(&h) }.at(rational(&eps), sites).unwrap();
    let [before, next] = [before, next].map(|state| state.iter().map(rational).collect::<Vec<_>>());
    // `try_step` proves the bound (k + 8)·u for rows of k = 5 entries and the unit u = 2⁻²⁴.
    assert!(exact.residual(&before, &next) <= BigRational::new((5 + 8).into(), (1_i64 << 24).into()));
}

/// The terms of the residual are 10³⁵⁰ times as large as the residual, so that its bound is
/// useless. `try_step` computes many digits of x̃ instead.
#[test]
fn a_step_whose_digits_are_known_needs_no_residual() {
    kahan! {
        struct Crowd { q, r }
        for i in periodic { x[i]dot = x[i]/(r[i]*r[i]) - q[i]/(r[i]*r[i])*x[i]*x[i]; }
    }
    let (q, r) = (-3.908_316_416_036_196_4e254, 8.843_222_868_544_905e-194);
    let crowd = Crowd { q: vec![q, 0.25], r: vec![r, 2.0] };
    let mut state = vec![8.803_863_726_421_91e96, 1.0];
    crowd.at(-2.5e-99, 2).expect("a map").try_step(&mut state).expect("a step");
    // At this ε, the first site's x̃ is 0.5/q up to rounding. Its equation is ẋ = (x − qx²)/r².
    assert_eq!(state, [0.5 / q, 1.0]);
}

fn apart(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |largest, (a, b)| largest.max((a - b).abs()))
}

/// With half the time step, the error at time 1 is a quarter.
#[test]
fn chains_are_of_order_two_and_go_back() {
    fn check<M: LatticeMap<f64>>(map: &M, sites: usize, steps: u64) {
        let start: Vec<f64> = (0..sites * M::BLOCK).map(|k| 1.0 + 0.25 * (0.6 * k as f64).sin()).collect();
        let at = |steps: u64| {
            let mut state = start.clone();
            map.at(0.5 / steps as f64, sites).unwrap().advance(&mut state, steps);
            state
        };
        let exact = at(64 * steps);
        let errors = [1, 2, 4].map(|finer| apart(&at(finer * steps), &exact));
        for pair in errors.windows(2) {
            assert!((pair[0] / pair[1] - 4.0).abs() < 0.2, "{errors:?}");
        }
        let mut chain = map.at(0.5 / steps as f64, sites).unwrap();
        let mut state = start.clone();
        chain.advance(&mut state, 100);
        (0..100).for_each(|_| chain.step_back(&mut state));
        assert!(apart(&state, &start) < 200.0 * 64.0 * f64::EPSILON, "{:e}", apart(&state, &start));
    }
    for sites in [7, 300] {
        check(&Ring, sites, 20);
        check(&Chain, sites, 20);
        check(&Toda, sites, 40);
        check(&Kdv { h: 1.0 }, sites, 20);
        check(&Shore { mu: 0.3, r: vec![1.0; sites] }, sites, 20);
    }
}

/// A line is fitted to a thousand values of the mass, and one to those of the energy. Each line
/// rises less than a sum of rounding errors of equal sign.
#[test]
fn kept_sums_have_no_slope() {
    let (sites, h, rounds) = (300, 0.25, 1000);
    let mut wave = Kdv { h }.at(2e-3, sites).unwrap();
    let hump = |x: f64| 1.0 / x.cosh().powi(2);
    let mut state: Vec<f64> =
        (0..sites).map(|i| h * i as f64).map(|x| 2.0 * hump(x - 20.0) + 0.5 * hump(x / 2.0 - 22.0)).collect();
    let slopes = (0..sites).map(|i| ((state[(i + 1) % sites] - state[i]) / h).powi(2) / 2.0);
    let terms =
        [state.iter().sum::<f64>(), slopes.sum::<f64>() + state.iter().map(|u| u.powi(3)).sum::<f64>()];
    let (mut masses, mut energies) = (Vec::new(), Vec::new());
    for _ in 0..rounds {
        wave.advance(&mut state, 5);
        masses.push(wave.integrals(&state)[0]);
        energies.push(wave.modified_energy(&state));
    }
    for (values, terms) in [masses, energies].iter().zip(terms) {
        let middle = (values.len() - 1) as f64 / 2.0;
        let place = |k: usize| k as f64 - middle;
        let above: f64 = values.iter().enumerate().map(|(k, value)| place(k) * value).sum();
        let below: f64 = (0..values.len()).map(|k| place(k).powi(2)).sum();
        let moved = (above / below * 2.0 * middle).abs();
        assert!(moved < f64::from(5 * rounds) * f64::EPSILON / 2.0 * terms, "{moved:e} of {}", values[0]);
    }
}
