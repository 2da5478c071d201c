//! Tests the exact steps against generated code over big rationals, and against each other.

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::{lexer::lex, read};
use kahan_core::KahanMap;
use kahan_core::nalgebra::SVector;
use kahan_core::num_rational::BigRational;

use super::fraction::Fraction;
use super::*;
use crate::float::Float;
use crate::points::{InputSampler, Inputs};
use crate::regime::Regime;
use crate::tests::compiled::judge_of;
use crate::tests::residual::determinant;
use kahan_systems::entry::Entry;
use kahan_systems::registry::SYSTEMS;
use kahan_systems::{E1, E3, E9, VolterraLattice};

fn system(text: &str) -> System {
    read(&lex(text).tokens).system().expect("a system")
}

fn reduced(entry: &Entry) -> Reduced {
    Reduced::of(&system(entry.text())).expect("a closed form within the budget")
}

fn drawn(judge: &dyn ExactMap, seed: u64, regime: Regime) -> Inputs<f64> {
    let fixed = vec![None::<f64>; judge.equation().epsilon() - judge.equation().dimension()];
    InputSampler { judge, fixed: &fixed, is_odd: false, random: SplitMix64::new(seed) }.draw(regime)
}

fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

/// Compares the step and its condition number with those of generated code. For the map Φ of a
/// homogeneous field, Φ(λx, ε/λ) = λΦ(x, ε). So ε·∂Φ/∂ε equals (∂Φ/∂x)·x − Φ.
fn agrees<M: KahanMap<BigRational, 3>>(judge: &Reduced, map: impl Fn(Option<&f64>) -> M) {
    for (seed, regime) in
        (0..120).zip([Regime::Ordinary, Regime::MixedMagnitudes, Regime::NearPole].iter().cycle())
    {
        let inputs = drawn(judge, seed, *regime);
        let (x, eps) = (SVector::from_fn(|i, _| rational(inputs.x[i])), rational(inputs.eps));
        let map = map(inputs.parameters.first());
        let point = inputs.exact().unwrap();
        let Some(exact) = judge.fraction(&point) else {
            assert!(map.try_step(&x, eps).is_err());
            continue;
        };
        let next = map.step(&x, eps.clone());
        for (i, component) in next.iter().enumerate() {
            let [n, d] = [&exact.numerators[i], &exact.denominator].map(|of| of.rational().to_big());
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
        let condition = judge.condition(&point);
        if norm == BigRational::from_integer(0.into()) {
            assert!(condition.is_infinite());
        } else {
            let expected = largest / norm;
            let difference = size(&(&expected - rational(condition)));
            assert!(difference * rational(1e12) < expected, "condition {condition:e} at {inputs:?}");
        }
    }
}

#[test]
fn the_exact_step_is_that_of_generated_code() {
    agrees(&reduced(&kahan_systems::e1::ENTRY), |_| E1);
    agrees(&reduced(&kahan_systems::e3::ENTRY), |_| E3);
    agrees(&reduced(&kahan_systems::e9::ENTRY), |xi| E9 { xi: rational(*xi.unwrap()) });
    agrees(&reduced(&kahan_systems::volterra::ENTRY), |_| VolterraLattice);
}

#[test]
fn errors_are_told_from_both_sides_of_the_promise() {
    let judge = reduced(&kahan_systems::e3::ENTRY);
    let point: Vec<Dyadic> = [0.0, 0.0, 4.0, 0.125].iter().map(|&x| Dyadic::of(x).unwrap()).collect();
    let exact = judge.step(&point).unwrap();
    let verdict =
        |z: f64| exact.judge(&f64::FORMAT, &[Dyadic::zero(), Dyadic::zero(), Dyadic::of(z).unwrap()]);
    let right = verdict(4.0);
    assert!(right.error_u == 0.0 && right.keeps_promise && right.is_rough);
    let last = verdict(4.0 + 64.0 * 2_f64.powi(-51));
    assert!(last.error_u == 64.0 && last.keeps_promise);
    let first = verdict(4.0 + 66.0 * 2_f64.powi(-51));
    assert!(first.error_u == 66.0 && !first.keeps_promise && first.is_rough);
    assert!(!verdict(4.005).is_rough);
    let missing =
        exact.judge(&f64::FORMAT, &[Dyadic::of(1e-14).unwrap(), Dyadic::zero(), Dyadic::of(4.0).unwrap()]);
    assert!(missing.error_u > 20.0 && missing.error_u < 23.0 && missing.keeps_promise);
}

#[test]
fn a_result_outside_the_format_is_told_exactly() {
    let judge = reduced(&kahan_systems::e3::ENTRY);
    let fits = |z: Dyadic| {
        let point = [Dyadic::zero(), Dyadic::zero(), z, Dyadic::new(1, -3000)];
        judge.step(&point).unwrap().fits(&f64::FORMAT)
    };
    let of = |z: f64| Dyadic::of(z).unwrap();
    assert!(fits(of(f64::MAX)) && fits(of(-f64::MIN_POSITIVE)) && fits(Dyadic::zero()));
    assert!(!fits(&of(f64::MAX) + &of(1.0)) && !fits(of(f64::MIN_POSITIVE.next_down())));
}

fn nearest(judge: &dyn ExactMap, point: &[Dyadic]) -> Option<Vec<f64>> {
    let Fraction { numerators, denominator, .. } = Fraction::of_equation(&judge.equation().at(point))?;
    let next: Vec<f64> = numerators.iter().map(|n| n.quotient(&denominator, 64).0.near_f64()).collect();
    next.iter().all(|y| y.is_finite()).then_some(next)
}

fn verdict(exact: &dyn ExactStep, next: &[f64]) -> Verdict {
    let next: Vec<Dyadic> = next.iter().map(|y| Dyadic::of(*y).unwrap()).collect();
    exact.judge(&f64::FORMAT, &next)
}

fn beyond_the_budget() -> Equation {
    let names = ["x", "y", "z", "u", "v"];
    let equation = |i: usize| {
        let terms = (0..5).flat_map(|j| (j..5).map(move |k| (j, k)));
        let terms: Vec<String> = terms
            .map(|(j, k)| format!("{}/7*{}*{}", 1 + (3 * i + 5 * j + 2 * k) % 11, names[j], names[k]))
            .collect();
        format!("{}dot = {} - {}/3;", names[i], terms.join(" + "), names[(i + 1) % 5])
    };
    let system = system(&(0..5).map(equation).collect::<String>());
    assert!(Reduced::of(&system).is_none());
    Equation::of(&system)
}

const REGIMES: [Regime; 4] =
    [Regime::Ordinary, Regime::MixedMagnitudes, Regime::NearPole, Regime::LargeSteps];

/// Checks that two exact steps yield equal verdicts on results within and beyond the error bound.
fn agree(one: &dyn ExactStep, other: &dyn ExactStep, next: &[f64]) {
    for off in [0.0, 3e-15, 2e-14, 1e-2] {
        let moved: Vec<f64> = next.iter().map(|y| y + y * off).collect();
        let (one, other) = (verdict(one, &moved), verdict(other, &moved));
        assert_eq!(
            (one.keeps_promise, one.is_rough),
            (other.keeps_promise, other.is_rough),
            "{next:?} off by {off}: {} and {} u",
            one.error_u,
            other.error_u
        );
    }
}

#[test]
fn balls_and_the_reduced_map_say_the_same() {
    let mut compared = 0;
    for entry in SYSTEMS {
        let (reduced, in_balls) = (reduced(entry), Equation::of(&system(entry.text())));
        if reduced.has_removable_poles() {
            continue;
        }
        for (seed, regime) in (0..40).zip(REGIMES.iter().cycle()) {
            let point = drawn(&reduced, seed, *regime).exact().unwrap();
            let (one, other) = (reduced.step(&point), in_balls.step(&point));
            assert_eq!(one.is_some(), other.is_some(), "{} at {point:?}", entry.command);
            let Some((first, second)) = one.zip(other) else { continue };
            if let Some(next) = nearest(&reduced, &point) {
                agree(&*first, &*second, &next);
                compared += 1;
            }
            let (one, other) = (reduced.condition(&point), in_balls.condition(&point));
            assert!(one == other || (one / other - 1.0).abs() < 1e-5, "{}: {one} and {other}", entry.command);
        }
    }
    assert!(compared > 300, "{compared}");
}

#[test]
fn a_field_beyond_the_budget_is_judged_equally_by_balls_and_by_exact_elimination() {
    let judge = beyond_the_budget();
    let mut compared = 0;
    for (seed, regime) in (0..40).zip(REGIMES.iter().cycle()) {
        let point = drawn(&judge, seed, *regime).exact().unwrap();
        let in_balls = judge.step(&point);
        let exactly = Fraction::of_equation(&judge.at(&point));
        assert_eq!(in_balls.is_some(), exactly.is_some());
        let Some((in_balls, exactly)) = in_balls.zip(exactly) else { continue };
        if let Some(next) = nearest(&judge, &point) {
            agree(&*in_balls, &exactly, &next);
            assert_eq!(in_balls.fits(&f32::FORMAT), exactly.fits(&f32::FORMAT));
            compared += 1;
        }
    }
    assert!(compared > 25, "{compared}");
}

fn of_many() -> Box<dyn ExactMap> {
    let equation = |i: usize| {
        let (j, k) = ((i + 3) % 11, (i + 7) % 11);
        format!("x{i}dot = 3/7*x{i}*x{j} - x{k}^2/2 + x{j} - 5*x{i}/3 + 1/9;")
    };
    judge_of(&system(&(0..11).map(equation).collect::<String>()))
}

#[test]
fn every_judge_sees_a_wrong_step() {
    let reduced = reduced(&kahan_systems::e9::ENTRY);
    for judge in [&reduced as &dyn ExactMap, &beyond_the_budget(), &*of_many()] {
        let mut tried = 0;
        for (seed, regime) in (0..24).zip([Regime::Ordinary, Regime::NearPole].iter().cycle()) {
            let point = drawn(judge, seed, *regime).exact().unwrap();
            let (Some(exact), Some(next)) = (judge.step(&point), nearest(judge, &point)) else { continue };
            assert!(verdict(&*exact, &next).keeps_promise, "{judge:?}: {next:?}");
            let largest = (0..next.len()).max_by(|i, j| next[*i].abs().total_cmp(&next[*j].abs())).unwrap();
            let mut wrong = next.clone();
            wrong[largest] *= 1.0 + 1e-13;
            assert!(!verdict(&*exact, &wrong).keeps_promise, "{judge:?}: {next:?}");
            tried += 1;
        }
        assert!(tried > 12, "{tried}");
    }
}

/// Tests that the polynomials from `zeros` equal det A as a function of one coordinate.
#[test]
fn det_a_along_a_coordinate_is_told() {
    for judge in [&beyond_the_budget() as &dyn ExactMap, &*of_many()] {
        let mut told = 0;
        for seed in 0..12 {
            let mut point = drawn(judge, seed, Regime::Ordinary).exact().unwrap();
            let Some(zeros) = judge.zeros(false, &point, &mut SplitMix64::new(seed)) else { continue };
            let v = Dyadic::new(11, -3);
            let value = zeros.coefficients.iter().rev().fold(Dyadic::zero(), |sum, c| &(&sum * &v) + c);
            point[zeros.variable] = v;
            let determinant = determinant(&judge.equation().at(&point), &[], 256);
            assert!((&value - &determinant).ratio(&determinant) < 1e-40, "variable {}", zeros.variable);
            told += 1;
        }
        assert!(told > 6, "{told}");
    }
}
