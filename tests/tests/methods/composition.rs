//! Tests compositions: structures that they preserve or lose, over ℚ, and their measured orders.

use kahan_core::prelude::*;
use kahan_core::{Composition, Dd};
use kahan_systems::{E1, E2, E3, E4, E5, E6, EulerTop, LotkaVolterra};
use kahan_tests::exact::{Q, q};
use kahan_tests::taylor::{distance, flow};

type Point = SVector<Q, 3>;

/// Returns the weights of a symmetric composition with rational coefficients.
fn gammas() -> [Q; 5] {
    [q(2, 3), q(-3, 4), q(7, 6), q(-3, 4), q(2, 3)]
}

fn composed<M: KahanMap<Q, 3>>(map: &M, x: &Point, eps: &Q) -> Point {
    gammas().iter().fold(x.clone(), |x, gamma| map.step(&x, gamma * eps))
}

fn composed_det<M: KahanMap<Q, 3>>(map: &M, x: &Point, eps: &Q) -> Q {
    let stages = gammas().into_iter().fold((x.clone(), q(1, 1)), |(x, det), gamma| {
        let factor = map.det_jacobian(&x, &gamma * eps);
        (map.step(&x, gamma * eps), det * factor)
    });
    stages.1
}

fn start() -> (Point, Q) {
    (vector![q(2, 5), q(-3, 7), q(5, 4)], q(1, 9))
}

#[test]
fn the_stages_sum_to_one_and_move_the_point() {
    assert_eq!(gammas().into_iter().sum::<Q>(), q(1, 1));
    let (x, eps) = start();
    assert_ne!(composed(&E6, &x, &eps), E6.step(&x, eps.clone()));
}

#[test]
fn the_inverse_of_a_composition_is_the_one_with_minus_eps() {
    let (x, eps) = start();
    let top = EulerTop { a1: q(1, 1), a2: q(-2, 1), a3: q(3, 2) };
    assert_eq!(composed(&E2, &composed(&E2, &x, &eps), &-eps.clone()), x);
    assert_eq!(composed(&E5, &composed(&E5, &x, &eps), &-eps.clone()), x);
    assert_eq!(composed(&E6, &composed(&E6, &x, &eps), &-eps.clone()), x);
    assert_eq!(composed(&top, &composed(&top, &x, &eps), &-eps), x);
}

#[test]
fn integrals_without_eps_survive_and_those_with_eps_do_not() {
    let (x, eps) = start();
    let [e1, e3] = [composed(&E1, &x, &eps), composed(&E3, &x, &eps)];
    assert_eq!([&e1[1] / &e1[0], &e3[1] / &e3[0]], [&x[1] / &x[0], &x[1] / &x[0]]);
    assert_ne!(E1.integrals(&e1, eps.clone())[1], E1.integrals(&x, eps.clone())[1]);
    assert_ne!(E3.integrals(&e3, eps.clone())[1], E3.integrals(&x, eps)[1]);
}

/// The integrals H = P/D and K = Q/D have a common denominator D. A composition preserves H/K and
/// the density 1/(PQ), but neither H nor K.
fn keeps_the_ratio_and_the_measure<M>(name: &str, map: &M, density: impl Fn(&M, &Point, Q) -> Q)
where
    M: KahanMap<Q, 3> + Integrals<Q, 3, 2>,
{
    let (x, eps) = start();
    let next = composed(map, &x, &eps);
    let [before, after] = [&x, &next].map(|x| map.integrals(x, eps.clone()));
    assert_eq!(&after[0] / &after[1], &before[0] / &before[1], "{name}: H/K");
    assert!(after[0] != before[0] && after[1] != before[1], "{name}: neither H nor K survives");
    let [before, after] = [&x, &next].map(|x| density(map, x, eps.clone()));
    assert_eq!(after * composed_det(map, &x, &eps), before, "{name}: the measure");
}

#[test]
fn the_ratio_of_two_integrals_with_one_denominator_survives() {
    keeps_the_ratio_and_the_measure("E2", &E2, E2::density);
    keeps_the_ratio_and_the_measure("E4", &E4, E4::density);
    keeps_the_ratio_and_the_measure("E5", &E5, E5::density);
    keeps_the_ratio_and_the_measure("E6", &E6, E6::density);
}

/// Tests that the composition preserves the Euler top's ratio (α₃y² − α₂z²)/(α₁z² − α₃x²).
#[test]
fn the_euler_top_keeps_the_ratio_of_its_quadratic_forms() {
    let (x, eps) = start();
    let top = EulerTop { a1: q(1, 1), a2: q(-2, 1), a3: q(3, 2) };
    let forms = |x: &Point| {
        let [x, y, z] = [0, 1, 2].map(|i| &x[i] * &x[i]);
        [&top.a3 * &y - &top.a2 * &z, &top.a1 * &z - &top.a3 * &x]
    };
    let next = composed(&top, &x, &eps);
    let ([before_1, before_2], [after_1, after_2]) = (forms(&x), forms(&next));
    assert_eq!(&after_1 / &after_2, &before_1 / &before_2);
    assert_eq!(composed_det(&top, &x, &eps) * before_1 * before_2, after_1 * after_2);
    let [before, after] = [&x, &next].map(|x| top.integrals(x, eps.clone()));
    assert!(before[0] != after[0] && before[1] != after[1]);
}

fn errors<M, const N: usize>(map: &M, start: [f64; N], time: f64, composition: Composition) -> [f64; 4]
where
    M: KahanMap<Dd, N>,
{
    let start = SVector::from(start.map(Dd::from));
    let end = flow(map, start, Dd::from(time), 8);
    [8, 16, 32, 64].map(|steps| {
        let eps = Dd::from(time) / Dd::from(f64::from(2 * steps));
        let orbit = map.orbit(start, eps).composed(composition).nth(steps as usize);
        distance(&orbit.expect("a float orbit goes on"), &end)
    })
}

/// Asserts that halving ε divides the error by 2^order. Rounding errors are too small to matter.
fn has_its_order<M, const N: usize>(name: &str, map: &M, start: [f64; N])
where
    M: KahanMap<Dd, N>,
{
    for composition in Composition::ALL {
        let time = match (composition.order(), composition.stages()) {
            (2, _) => 2_f64.powi(-13),
            (4, 3) => 2_f64.powi(-7),
            (4, _) => 2_f64.powi(-5),
            (6, _) => 2_f64.powi(-3),
            (8, 15) => 2_f64.powi(-2),
            _ => 2_f64.powi(-1),
        };
        let errors = errors(map, start, time, composition);
        assert!(
            errors.iter().all(|error| (1e-26..1e-13).contains(error)),
            "{name}, {composition:?}: {errors:?}"
        );
        for pair in errors.windows(2) {
            let slope = (pair[0] / pair[1]).log2();
            let order = f64::from(composition.order());
            assert!((slope - order).abs() <= 0.15, "{name}, {composition:?}: slope {slope}, {errors:?}");
        }
    }
}

#[test]
fn the_measured_order_is_the_stated_one_on_e2_and_e6() {
    has_its_order("E2", &E2, [0.5, 0.75, -0.5]);
    has_its_order("E6", &E6, [0.5, 0.75, -0.25]);
}

#[test]
fn the_measured_order_is_the_stated_one_on_the_euler_top_and_lotka_volterra() {
    let [a1, a2, a3] = [1.0, -2.0, 1.5].map(Dd::from);
    has_its_order("Euler", &EulerTop { a1, a2, a3 }, [0.5, 1.0, 0.75]);
    has_its_order("LV", &LotkaVolterra, [1.5, 0.75]);
}
