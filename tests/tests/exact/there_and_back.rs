//! Tests that n steps forward and n steps back return to the start, exactly or within a bound.

use kahan_core::prelude::*;
use kahan_systems::{E1, E3, E6, EulerTop, LotkaVolterra};
use kahan_tests::exact::{Q, q};

fn comes_home_exactly<M: KahanMap<Q, N>, const N: usize>(map: &M, start: SVector<Q, N>, eps: Q) {
    const STEPS: usize = 6;

    let there = map.orbit(start.clone(), eps.clone()).nth(STEPS).expect("no pole on the way");
    assert_ne!(there, start);
    assert_eq!(map.orbit(there, -eps).nth(STEPS), Some(start));
}

#[test]
fn there_and_back_is_the_start_over_the_rationals() {
    let eps = q(2, 7);
    comes_home_exactly(&E1, vector![q(3, 7), q(-2, 5), q(1, 3)], eps.clone());
    comes_home_exactly(&E3, vector![q(3, 7), q(-2, 5), q(1, 3)], eps.clone());
    comes_home_exactly(&E6, vector![q(3, 7), q(-2, 5), q(1, 3)], eps.clone());
    comes_home_exactly(&LotkaVolterra, vector![q(3, 7), q(8, 5)], eps.clone());
    let top = EulerTop { a1: q(1, 1), a2: q(-2, 1), a3: q(3, 2) };
    comes_home_exactly(&top, vector![q(3, 7), q(-2, 5), q(1, 3)], eps);
}

fn norm<const N: usize>(matrix: &SMatrix<f64, N, N>) -> f64 {
    (0..N).map(|i| (0..N).map(|j| matrix[(i, j)].abs()).sum()).fold(0.0, f64::max)
}

/// Goes there and back. Returns the distance from the start and a bound: the sum of each step's
/// error times the norm of the Jacobian matrix of the steps from there back to the start.
fn distance_and_bound<M: KahanMap<f64, N>, const N: usize>(
    map: &M,
    start: [f64; N],
    eps: f64,
    steps: usize,
) -> [f64; 2] {
    let start = SVector::from(start);
    let points: Vec<SVector<f64, N>> = map.orbit(start, eps).take(steps + 1).collect();
    let home = map.orbit(points[steps], -eps).nth(steps).expect("a float orbit goes on");

    let delta = |x: &SVector<f64, N>| 8.0 * f64::EPSILON * x.amax();
    let mut power: SMatrix<f64, N, N> = SMatrix::from_fn(|i, j| f64::from(u8::from(i == j)));
    let mut bound = delta(&start);
    for x in &points[1..] {
        // By the chain rule, the Jacobian matrix of several steps back is a product.
        power *= map.jacobian(x, -eps);
        bound += 2.0 * norm(&power) * delta(x);
    }
    [(home - start).amax(), bound]
}

fn comes_home<M: KahanMap<f64, N>, const N: usize>(name: &str, map: &M, start: [f64; N]) -> [f64; 2] {
    let measured = [50, 500, 2000].map(|steps| {
        let [distance, bound] = distance_and_bound(map, start, 0.05, steps);
        assert!(distance <= bound, "{name}, {steps} steps: {distance:e} > {bound:e}");
        [distance, bound]
    });
    measured[2]
}

/// A step's error is about 20 times smaller than its bound, and 4000 errors of random sign partly
/// cancel. The distance is about a thousandth of the bound.
#[test]
fn there_and_back_is_within_the_bound_in_floats() {
    comes_home("E1", &E1, [0.5, 1.0, 0.25]);
    comes_home("E3", &E3, [0.5, 1.0, 0.25]);
    let periodic = [
        comes_home("E6", &E6, [0.5, 0.25, -0.75]),
        comes_home("LV", &LotkaVolterra, [1.5, 0.75]),
        comes_home("Euler", &EulerTop { a1: 1.0, a2: -2.0, a3: 1.5 }, [0.5, 1.0, 0.75]),
    ];
    assert!(periodic.iter().all(|[distance, bound]| *distance > 1e-4 * bound), "{periodic:?}");
}
