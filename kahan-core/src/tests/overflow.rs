//! A denominator or a pivot that overflows must not pass for a step of length zero.

use super::systems::{Coupled, E1, E3, E7};
use crate::{KahanMap, vector};

#[test]
fn an_overflowing_denominator_is_seen_and_elimination_takes_over() {
    // (1 + 2εx)(1 − εx) has the size of 1e340, while nothing in x̃₁ = x/(1 + 2εx) leaves the range of f64.
    let (x, eps) = (vector![1e-50_f64, 5e-51, 2.5e-51], 1e220);
    assert_eq!(E1.step(&x, eps), x);
    let next = E1.try_step(&x, eps).unwrap();
    // x̃₁ and x̃₂ are tiny: x + 2ε·(−x²)/(1 + 2εx) cancels to within the rounding of x.
    assert!(next[0].abs() <= 2.0 * f64::EPSILON * x[0], "{next}");
    assert!(next[1].abs() <= 2.0 * f64::EPSILON * x[1], "{next}");
}

#[test]
fn a_matrix_beyond_the_range_is_refused() {
    let why = E7 { xi: 1.0 }.try_step(&vector![1e200, 1e-200, 0.0], 1e200).unwrap_err();
    assert!(!why.determinant().is_finite());
}

#[test]
fn an_overflowing_pivot_is_refused() {
    // εw is beyond f64, and elimination divides by it: a finite result with x̃₁ = x₁, where x̃₁ − x₁ = 2.7e-10.
    let (x, eps) = (vector![1.0_f64, 1.0, 1.0, 1e10], 1e300);
    let fast = Coupled.step(&x, eps);
    assert!(fast.iter().all(|entry| entry.is_finite()) && fast[0] == 1.0);
    let why = Coupled.try_step(&x, eps).unwrap_err();
    assert!(why.determinant().is_nan());
}

#[test]
fn a_component_at_rest_is_no_overflow() {
    // A removable pole with x = 0, where elimination would fail.
    let x = vector![0.0_f64, 1.0, -2.0];
    assert_eq!(E3.det_matrix(&x, 0.5), 0.0);
    assert_eq!(E3.try_step(&x, 0.5), Ok(E3.step(&x, 0.5)));
}
