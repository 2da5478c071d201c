//! A denominator or a pivot that overflows must not pass for a step of length zero.

use nalgebra::{SMatrix, SVector};

use super::systems::{Coupled, E1, E3, E7};
use crate::{KahanMap, PreparedStep, QuadraticField, Quotients, vector};

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

/// ẋ = −x² beside a clock, ṫ = 1, with a denominator for each.
#[derive(Clone)]
struct Clock;

impl QuadraticField<f64, 2> for Clock {
    fn field(&self, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        self.polarized(x, x)
    }

    fn field_jacobian(&self, x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        SMatrix::from([[-2.0 * x[0], 0.0], [0.0, 0.0]])
    }

    fn bilinear(&self, x: &SVector<f64, 2>, y: &SVector<f64, 2>) -> SVector<f64, 2> {
        vector![-x[0] * y[0], 0.0]
    }

    fn polarized(&self, x: &SVector<f64, 2>, y: &SVector<f64, 2>) -> SVector<f64, 2> {
        self.bilinear(x, y) + vector![0.0, 1.0]
    }
}

/// The step of [`Clock`] at ε, with the factor εx too many in x̃ − x = −2εx²·εx/((1 + 2εx)·εx).
#[derive(Clone)]
struct ClockStep(f64);

impl PreparedStep<f64, 2> for ClockStep {
    fn quotients(&self, x: &SVector<f64, 2>) -> Option<Quotients<f64, 2>> {
        let ex = self.0 * x[0];
        let numerators = [-2.0 * ex * x[0] * ex, 2.0 * self.0];
        Some(Quotients { numerators, reciprocals: [Some(1.0 / ((1.0 + 2.0 * ex) * ex)), None] })
    }
}

impl KahanMap<f64, 2> for Clock {
    type Prepared = ClockStep;

    fn prepare(&self, eps: &f64) -> ClockStep {
        ClockStep(*eps)
    }
}

#[test]
fn one_overflowing_denominator_is_seen_beside_components_that_move() {
    // (1 + 2εx)·εx has the size of 1e340, so x seems to rest; the clock moves, and elimination is possible.
    let (x, eps) = (vector![1e-50_f64, 0.0], 1e220);
    assert_eq!(Clock.step(&x, eps), vector![1e-50, 2e220]);
    let next = Clock.try_step(&x, eps).unwrap();
    assert!(next[0].abs() <= 2.0 * f64::EPSILON * x[0] && next[1] == 2e220, "{next}");
}
