//! Tests that an overflowing denominator or pivot is not mistaken for an increment of zero.

use nalgebra::{SMatrix, SVector};

use super::by_hand::{Coupled, E1, field_of};
use crate::{KahanMap, NoLanes, PreparedStep, QuadraticField, Quotients, Scalar, vector};

/// A handwritten map of E1, whose components share one denominator.
#[derive(Clone)]
struct ByHand;

field_of!(E1, for ByHand in 3);

#[derive(Clone)]
struct ByHandStep(f64);

impl PreparedStep<f64, 3> for ByHandStep {
    type Wide<L: Scalar> = NoLanes;

    fn quotients(&self, state: &SVector<f64, 3>) -> Option<Quotients<f64, 3>> {
        let (eps, [x, y, z]) = (self.0, [state[0], state[1], state[2]]);
        let (plus, minus) = (1.0 + eps * x, 1.0 - eps * x);
        let velocity = [-x * x * minus, -x * y * minus, 2.0 * y * y + x * z * plus];
        let denominator = (plus + eps * x) * minus;
        Some(Quotients::over(velocity.map(|entry| 2.0 * eps * entry), 1.0 / denominator))
    }
}

impl KahanMap<f64, 3> for ByHand {
    type Prepared = ByHandStep;

    fn prepare(&self, eps: &f64) -> ByHandStep {
        ByHandStep(*eps)
    }
}

#[test]
fn an_overflowing_denominator_is_seen_and_elimination_takes_over() {
    // The common denominator overflows, but x̃₁ = x/(1 + 2εx) stays in the range of `f64`.
    let (x, eps) = (vector![1e-50_f64, 5e-51, 2.5e-51], 1e220);
    assert_eq!(ByHand.step(&x, eps), x);
    let next = ByHand.try_step(&x, eps).unwrap();
    // x̃₁ and x̃₂ are tiny, because x + 2ε·(−x²)/(1 + 2εx) cancels up to rounding.
    assert!(next[0].abs() <= 2.0 * f64::EPSILON * x[0], "{next}");
    assert!(next[1].abs() <= 2.0 * f64::EPSILON * x[1], "{next}");
}

#[test]
fn a_matrix_beyond_the_range_is_refused() {
    let why = ByHand.try_step(&vector![1e200, 1e-200, 0.0], 1e200).unwrap_err();
    assert!(!why.determinant().is_finite());
}

#[test]
fn an_overflowing_pivot_is_refused() {
    // ε·`x[3]` overflows, and a division by it leaves `x[0]` unchanged.
    let (x, eps) = (vector![1.0_f64, 1.0, 1.0, 1e10], 1e300);
    let fast = Coupled.step(&x, eps);
    assert!(fast.iter().all(|entry| entry.is_finite()) && fast[0] == 1.0);
    let why = Coupled.try_step(&x, eps).unwrap_err();
    assert!(why.determinant().is_nan());
}

#[test]
fn a_component_at_rest_is_no_overflow() {
    // This is a removable pole: det A is 0, but the map is defined.
    let x = vector![-2.0_f64, 0.0, 1.0];
    assert_eq!(ByHand.det_matrix(&x, 0.5), 0.0);
    assert_eq!(ByHand.try_step(&x, 0.5), Ok(ByHand.step(&x, 0.5)));
}

/// The equation ẋ = −x² together with a clock ṫ = 1, each with its own denominator.
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

/// The step of [`Clock`] at ε, with a redundant factor εx: x̃ − x = −2εx²·εx/((1 + 2εx)·εx).
#[derive(Clone)]
struct ClockStep(f64);

impl PreparedStep<f64, 2> for ClockStep {
    type Wide<L: Scalar> = NoLanes;

    fn quotients(&self, x: &SVector<f64, 2>) -> Option<Quotients<f64, 2>> {
        let ex = self.0 * x[0];
        let numerators = [-2.0 * ex * x[0] * ex, 2.0 * self.0];
        Some(Quotients::over_each(numerators, [Some(1.0 / ((1.0 + 2.0 * ex) * ex)), None]))
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
    // The denominator (1 + 2εx)·εx overflows, and the computed increment becomes 0.
    let (x, eps) = (vector![1e-50_f64, 0.0], 1e220);
    assert_eq!(Clock.step(&x, eps), vector![1e-50, 2e220]);
    let next = Clock.try_step(&x, eps).unwrap();
    assert!(next[0].abs() <= 2.0 * f64::EPSILON * x[0] && next[1] == 2e220, "{next}");
}
