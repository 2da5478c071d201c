//! The judge against generated code over big rationals: two derivations of one map.

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::{lexer::lex, read};
use kahan_core::KahanMap;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;

use super::super::points::Points;
use super::super::regime::Regime;
use super::*;
use kahan_systems::entry::Entry;
use kahan_systems::{E1, E3, E9, VolterraLattice};

fn judge(entry: &Entry) -> Judge {
    Judge::of(&read(&lex(entry.text()).tokens).system).unwrap()
}

fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

/// Nᵢ/d, and the condition number of a homogeneous map, where ε ∂x̃/∂ε = J x − x̃, at seeded points
/// of three regimes.
fn agrees<M: KahanMap<BigRational, 3>>(judge: &Judge, map: impl Fn(Option<&f64>) -> M) {
    let fixed = vec![None::<f64>; judge.parameters];
    for (seed, regime) in
        (0..120).zip([Regime::Ordinary, Regime::MixedMagnitudes, Regime::NearPole].iter().cycle())
    {
        let inputs = Points { judge, fixed: &fixed, random: SplitMix64::new(seed) }.draw(*regime);
        let (x, eps) = (SVector::from_fn(|i, _| rational(inputs.x[i])), rational(inputs.eps));
        let map = map(inputs.parameters.first());
        let Some(exact) = judge.step(judge.powers(&inputs.exact().unwrap())) else {
            assert!(map.try_step(&x, eps).is_err());
            continue;
        };
        let next = map.step(&x, eps.clone());
        for (i, component) in next.iter().enumerate() {
            let (n, d) = (exact.numerators[i].rational(), exact.denominator.rational());
            assert_eq!(n, component * d, "component {i} at {inputs:?}");
        }
        let jacobian = map.jacobian(&x, eps);
        let size = |v: &BigRational| if *v < BigRational::from_integer(0.into()) { -v } else { v.clone() };
        let along_x = &jacobian * &x;
        let sums = (0..3).map(|i| {
            let of_states = (0..3).map(|j| size(&(&jacobian[(i, j)] * &x[j]))).sum::<BigRational>();
            of_states + size(&(&along_x[i] - &next[i]))
        });
        let (largest, norm) = (sums.max().unwrap(), next.iter().map(size).max().unwrap());
        let condition = judge.condition(&exact);
        if norm == BigRational::from_integer(0.into()) {
            assert!(condition.is_infinite());
        } else {
            // 2⁻⁵⁰ of the quotient, and the rounding of the comparison.
            let expected = largest / norm;
            let difference = size(&(&expected - rational(condition)));
            assert!(difference * rational(1e12) < expected, "condition {condition:e} at {inputs:?}");
        }
    }
}

#[test]
fn the_exact_step_is_that_of_generated_code() {
    agrees(&judge(&kahan_systems::e1::ENTRY), |_| E1);
    agrees(&judge(&kahan_systems::e3::ENTRY), |_| E3);
    agrees(&judge(&kahan_systems::e9::ENTRY), |xi| E9 { xi: rational(*xi.unwrap()) });
    agrees(&judge(&kahan_systems::volterra::ENTRY), |_| VolterraLattice);
}

#[test]
fn errors_are_told_from_both_sides_of_the_promise() {
    let judge = judge(&kahan_systems::e3::ENTRY);
    let point: Vec<Dyadic> = [0.0, 0.0, 4.0, 0.125].iter().map(|&x| Dyadic::of(x).unwrap()).collect();
    let exact = judge.step(judge.powers(&point)).unwrap();
    // On the axis x = y = 0 every point is fixed; ‖exact‖ = 4, u‖exact‖ = 2⁻⁵¹.
    let verdict = |z: f64| exact.judge::<f64>(&[Dyadic::zero(), Dyadic::zero(), Dyadic::of(z).unwrap()]);
    let right = verdict(4.0);
    assert!(right.error_u == 0.0 && right.keeps_promise && right.is_rough);
    let last = verdict(4.0 + 64.0 * 2_f64.powi(-51));
    assert!(last.error_u == 64.0 && last.keeps_promise);
    let first = verdict(4.0 + 66.0 * 2_f64.powi(-51));
    assert!(first.error_u == 66.0 && !first.keeps_promise && first.is_rough);
    assert!(!verdict(4.005).is_rough);
    let missing = exact.judge::<f64>(&[Dyadic::of(1e-14).unwrap(), Dyadic::zero(), Dyadic::of(4.0).unwrap()]);
    assert!(missing.error_u > 20.0 && missing.error_u < 23.0 && missing.keeps_promise);
}

#[test]
fn a_result_outside_the_format_is_told_exactly() {
    let judge = judge(&kahan_systems::e3::ENTRY);
    let fits = |z: Dyadic| {
        let point = [Dyadic::zero(), Dyadic::zero(), z, Dyadic::new(1, -3000)];
        judge.step(judge.powers(&point)).unwrap().fits::<f64>()
    };
    let of = |z: f64| Dyadic::of(z).unwrap();
    assert!(fits(of(f64::MAX)) && fits(of(-f64::MIN_POSITIVE)) && fits(Dyadic::zero()));
    assert!(!fits(&of(f64::MAX) + &of(1.0)) && !fits(of(f64::MIN_POSITIVE.next_down())));
}
