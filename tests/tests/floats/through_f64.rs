//! Tests that `f32` steps computed through `f64` are nearly always the nearest `f32`.

use kahan_algebra::prime_field::SplitMix64;
use kahan_core::ThroughF64;
use kahan_core::prelude::*;
use kahan_systems::{E1, E3, E6, EulerTop, LotkaVolterra};
use kahan_tests::exact::{Q, q};
use num_traits::Signed;

fn rational(x: f32) -> Q {
    Q::from_float(x).expect("an ordinary point has a finite step")
}

fn ulp(x: f32) -> Q {
    rational(x.abs().next_up()) - rational(x.abs())
}

/// The number of components, and the number of those that are not the nearest `f32`.
#[derive(Default)]
struct Count {
    all: u32,
    wrong: u32,
}

/// Compares steps at seeded points in [−2, 2]ᴺ with |det A| ≥ ¼ and ε in [2⁻¹⁰, 2⁻⁴].
///
/// The error of an `f64` step is far below half an ulp of `f32` unless a component is tiny.
fn compare<M, E, const N: usize>(map: &M, exact: &E, seed: u64, count: &mut Count)
where
    M: KahanMap<f32, N>,
    E: KahanMap<Q, N>,
{
    let mut draws = SplitMix64::new(seed);
    for _ in 0..300 {
        let mut draw = |scale: f32| (draws.below(1 << 24) as f32 / (1 << 23) as f32 - 1.0) * scale;
        let x: SVector<f32, N> = SVector::from_fn(|_, _| draw(2.0));
        let eps = 2_f32.powi(-10) + draw(1.0).abs() * (2_f32.powi(-4) - 2_f32.powi(-10));
        let (wide_x, wide_eps) = (x.map(rational), rational(eps));
        if exact.det_matrix(&wide_x, wide_eps.clone()).abs() < q(1, 4) {
            continue;
        }
        let next = map.step(&x, eps);
        assert_eq!(map.try_step(&x, eps), Ok(next));
        for (float, exact) in next.iter().zip(exact.step(&wide_x, wide_eps).iter()) {
            if exact.abs() < q(1, 1 << 12) {
                continue;
            }
            let error = (rational(*float) - exact).abs() / ulp(*float);
            assert!(error <= q(1, 2) + q(1, 1 << 10), "x = {x:?}, eps = {eps:?}: {float:?} for {exact}");
            count.all += 1;
            count.wrong += u32::from(error > q(1, 2));
        }
    }
}

#[test]
fn a_step_is_nearly_always_the_nearest_f32() {
    let mut count = Count::default();
    compare(&ThroughF64(E1), &E1, 1, &mut count);
    compare(&ThroughF64(E3), &E3, 2, &mut count);
    compare(&ThroughF64(E6), &E6, 3, &mut count);
    compare(&ThroughF64(LotkaVolterra), &LotkaVolterra, 4, &mut count);
    let top = |a: f32, b: f32, c: f32| EulerTop { a1: a, a2: b, a3: c };
    let exact = EulerTop { a1: rational(0.1), a2: rational(-0.7), a3: rational(1.3) };
    compare(&ThroughF64(top(0.1, -0.7, 1.3)), &exact, 5, &mut count);
    // The nearest `f32` is ambiguous near a tie, so one wrong component is tolerated.
    assert!(count.all > 3000 && count.wrong <= 1, "{} of {}", count.wrong, count.all);
}

#[test]
fn a_step_in_f32_alone_is_often_not_the_nearest() {
    let map = E6;
    let (mut wrong, mut draws) = (0, SplitMix64::new(7));
    for _ in 0..200 {
        let x: SVector<f32, 3> =
            SVector::from_fn(|_, _| draws.below(1 << 24) as f32 / (1 << 23) as f32 - 1.0);
        let eps = 0.03_f32;
        let nearest = ThroughF64(E6).step(&x, eps);
        wrong += usize::from(map.step(&x, eps) != nearest);
    }
    assert!(wrong > 20, "{wrong} of 200");
}

#[test]
fn every_mode_of_an_orbit_goes_through_f64() {
    let (start, eps) = (vector![0.5_f32, 0.25, -0.75], 2_f32.powi(-10));
    let steps = 20_000;
    let there = E6.orbit(start.map(f64::from), f64::from(eps)).nth(steps).expect("a float orbit goes on");
    let error =
        |x: Option<SVector<f32, 3>>| (x.expect("a float orbit goes on").map(f64::from) - there).amax();
    let plain = error(ThroughF64(E6).orbit(start, eps).nth(steps));
    let compensated = error(ThroughF64(E6).orbit(start, eps).compensated().nth(steps));
    let in_single = error(E6.orbit(start, eps).compensated().nth(steps));
    // E6 hardly amplifies rounding errors, so an orbit's error shows how its steps were rounded.
    assert!(
        compensated < 1e-6 && compensated <= in_single && compensated < 0.1 * plain,
        "plain {plain:e}, compensated {compensated:e}, in f32 {in_single:e}"
    );
    let map = ThroughF64(E6).at(eps);
    assert_eq!(map.orbit(start).nth(5), ThroughF64(E6).orbit(start, eps).nth(5));
}

/// For ε = ½ the map of E1 has x̃ = x/(1 + x) and ỹ = y/(1 + x). For large y and x near −1, ỹ
/// exceeds the range of `f32`.
#[test]
fn what_f32_cannot_hold_is_flagged() {
    let pole = ThroughF64(E1).try_step(&vector![-1.0_f32, 1.0, 0.0], 0.5);
    assert!(pole.is_err());
    let beside = vector![(-1.0_f32).next_up(), 1e35, 0.0];
    assert!(E1.try_step(&beside.map(f64::from), 0.5).is_ok());
    assert!(ThroughF64(E1).try_step(&beside, 0.5).is_err());
}
