//! Tests guarantees for floats: no input panics, poles and overflow are detected, `f32` works.

use std::format;

use nalgebra::SVector;

use super::by_hand::{Coupled, E1, E3, E7};
use crate::scalar::tuning::fenced;
use crate::{KahanMap, eps_from_dt, vector};

const HARD: [f64; 9] = [0.0, -0.0, 1.0, -1.0, 1e-320, 1e308, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];

/// Calls every method, and checks that no call panics and that the results are consistent.
fn call_everything<M: KahanMap<f64, N> + Clone, const N: usize>(map: &M, x: SVector<f64, N>, eps: f64) {
    let _ = (map.step(&x, eps), map.step_back(&x, eps), map.matrix(&x, eps), map.rhs(&x, eps));
    let _ = (map.jacobian(&x, eps), map.det_jacobian(&x, eps), map.det_matrix(&x, eps));
    let _ = map.rational_map(&x, eps);
    assert_eq!(map.orbit(x, eps).take(4).count(), 4);
    match map.try_step(&x, eps) {
        Ok(next) => assert!(next.iter().all(|entry| entry.is_finite())),
        Err(why) => {
            let text = format!("{why}");
            let reasons = ["det A", "not a finite number", "beyond the range"];
            assert!(reasons.iter().any(|reason| text.contains(reason)), "{text}");
        }
    }
}

#[test]
fn no_input_makes_a_float_panic() {
    for a in HARD {
        for b in HARD {
            for eps in HARD {
                call_everything(&E1, vector![a, b, a], eps);
                call_everything(&E3, vector![a, b, 1.0], eps);
                call_everything(&E7 { xi: b }, vector![a, 1.0, b], eps);
                call_everything(&Coupled, vector![a, b, a, 1.0], eps);
            }
        }
    }
}

#[test]
fn a_float_at_a_pole_is_not_finite_and_try_step_says_why() {
    let x = vector![-1.0_f64, 1.0, 0.0];
    assert!(E1.step(&x, 0.5).iter().any(|entry| !entry.is_finite()));
    assert!(E1.jacobian(&x, 0.5).iter().any(|entry| !entry.is_finite()));
    let why = E1.try_step(&x, 0.5).unwrap_err();
    assert_eq!((why.determinant(), why.eps()), (0.0, 0.5));
    assert!(format!("{why}").contains("det A = 0"));

    let why = Coupled.try_step(&vector![0.0, 0.0, 0.0, 0.0], 1.0).unwrap_err();
    assert_eq!(why.determinant(), 0.0);
}

#[test]
fn a_float_has_the_value_at_a_removable_pole() {
    let next = E1.step(&vector![-2.0, 1.0, 1.0 / 3.0], 0.5);
    assert!((next - vector![2.0, -1.0, -2.0 / 3.0]).amax() <= 4.0 * f64::EPSILON);
}

#[test]
fn a_point_that_is_not_finite_is_refused() {
    for bad in [f64::NAN, f64::INFINITY] {
        let why = E3.try_step(&vector![1.0, bad, 0.0], 0.1).unwrap_err();
        assert!(!why.determinant().is_finite());
        assert!(E3.try_step(&vector![1.0, 2.0, 0.0], bad).is_err());
    }
}

#[test]
fn single_precision_follows_double_precision() {
    let (x, eps) = (vector![0.3_f32, -0.7, 1.1], 0.05_f32);
    let next = E3.step(&x, eps).map(f64::from);
    let expected = E3.step(&x.map(f64::from), f64::from(eps));
    assert!((next - expected).amax() <= 4.0 * f64::from(f32::EPSILON));
}

#[test]
fn a_zero_field_or_a_zero_step_leaves_the_point() {
    assert_eq!(E3.try_step(&vector![0.0, 0.0, 5.0], 0.1), Ok(vector![0.0, 0.0, 5.0]));
    assert_eq!(E3.try_step(&vector![1.0, 2.0, 3.0], 0.0), Ok(vector![1.0, 2.0, 3.0]));
    assert_eq!(Coupled.step(&vector![1.0, 2.0, 3.0, 4.0], 0.0), vector![1.0, 2.0, 3.0, 4.0]);
}

#[test]
fn eps_of_a_float_is_exactly_half() {
    assert_eq!(eps_from_dt(0.1), 0.05);
    assert_eq!(eps_from_dt(0.1_f32), 0.05_f32);
}

#[test]
fn a_fenced_number_keeps_its_bits() {
    let doubles = [
        0.0,
        -0.0,
        1.5,
        -f64::MAX,
        f64::from_bits(1),
        f64::NEG_INFINITY,
        f64::from_bits(0x7ff8_dead_beef_0001),
    ];
    for number in doubles {
        assert_eq!(fenced(number).to_bits(), number.to_bits());
        let single = number as f32;
        assert_eq!(fenced(single).to_bits(), single.to_bits());
    }
}
