//! Bounds the error of a float step, with or without fused multiply-adds.
//!
//! The bounds are derived from the operations of the step's code (Higham, Accuracy and Stability of
//! Numerical Algorithms, Lemma 3.1). Callers must avoid underflow.

mod running_bound;

use kahan_algebra::derive;
use kahan_algebra::field::Field;
use kahan_algebra::kahan::{field_jacobian, scaled_matrix};
use kahan_algebra::plan::{StepPlan, plan_of};
use kahan_algebra::poly::{Polynomial, Variable};
use kahan_algebra::rational::Rational;
use kahan_algebra::rational_function::RationalFunction;

use crate::doubles::float;
use crate::exact::{Matrix, Q, Vector, adjugate_product, determinant, q};
use crate::expression::evaluate;
use crate::subject::Subject;

use running_bound::Rounded;

/// The unit roundoff 2⁻⁵³ of `f64`.
pub const UNIT_F64: f64 = f64::EPSILON / 2.0;
/// The unit roundoff 2⁻²⁴ of `f32`.
pub const UNIT_F32: f64 = f32::EPSILON as f64 / 2.0;

/// The factor that covers rounding errors of the bound itself.
const INFLATION: f64 = 1.0 + 1e-6;

fn gamma(k: usize, unit: f64) -> f64 {
    let ku = k as f64 * unit;
    ku / (1.0 - ku)
}

/// The point and ε of a float step, with the exact next point.
#[derive(Clone, Debug)]
pub struct Place {
    /// The point x.
    pub x: Vector,
    /// Half the time step, ε.
    pub eps: Q,
    /// The exact next point x̃.
    pub next: Vector,
}

/// Error bounds for steps over floats, by the closed form or by elimination.
#[derive(Debug)]
pub struct StepBound<'a> {
    field: &'a Field,
    parameters: &'a [Q],
    step: Option<StepPlan>,
    unit: f64,
}

impl<'a> StepBound<'a> {
    /// Makes the bounds for floats with this unit roundoff.
    #[must_use]
    pub fn new(subject: &'a Subject, unit: f64) -> Self {
        let field = &subject.system.field;
        Self { field, parameters: &subject.parameters, step: derive(subject.system).step().cloned(), unit }
    }

    /// Returns a bound for each component of x̃. `None` if a divisor may round to zero.
    #[must_use]
    pub fn at(&self, place: &Place) -> Option<Vec<f64>> {
        let values: Vec<Q> = place.x.iter().chain(self.parameters).chain([&place.eps]).cloned().collect();
        let increments = match &self.step {
            Some(step) => closed_form(step, place, &values, self.unit)?,
            None => elimination(self.field, place, &values, self.unit)?,
        };
        // Adding the increment to x rounds once more.
        let bound = |(error, next): (f64, &Q)| {
            INFLATION * (error * (1.0 + self.unit) + self.unit * float(next).abs())
        };
        Some(increments.into_iter().zip(&place.next).map(bound).collect())
    }
}

/// Evaluates polynomials by the operations of generated code, with bounds on the rounding errors.
fn computed(polynomials: &[&Polynomial], values: &[Q], unit: f64) -> Vec<Rounded> {
    let plan = plan_of(polynomials.iter().copied());
    let results = running_bound::results(&plan, &[], unit, |variable| exact(values, variable));
    results.into_iter().map(|value| value.expect("a polynomial has a value")).collect()
}

fn exact(values: &[Q], variable: Variable) -> Rational {
    values[usize::from(variable.0)].clone().into()
}

/// Bounds the rounding errors of `step`. Panics if the exact result differs from `place.next`.
fn closed_form(step: &StepPlan, place: &Place, values: &[Q], unit: f64) -> Option<Vec<f64>> {
    let input = |variable| exact(values, variable);
    let constants = running_bound::results(&step.constants, &[], unit, input);
    let results = running_bound::results(&step.kernel.plan, &constants, unit, input);
    let results: Vec<Rounded> = results.into_iter().collect::<Option<_>>()?;
    let increments = step.kernel.factors(&results).map(|(numerator, reciprocal)| match reciprocal {
        Some(reciprocal) => numerator.times(reciprocal).rounded(unit),
        None => numerator.clone(),
    });
    let increments: Vec<Rounded> = increments.collect();
    for ((increment, x), next) in increments.iter().zip(&place.x).zip(&place.next) {
        assert_eq!(x + increment.exact.to_big(), *next, "the plan is not that of the map");
    }
    Some(increments.into_iter().map(|increment| increment.error).collect())
}

/// Bounds the error of 2ε·v, where v = A⁻¹f is computed by elimination with partial pivoting.
///
/// - Let n be the size of A, u the unit roundoff, and γ_k = ku/(1 − ku).
/// - Elimination with rounded reciprocals solves exactly a system whose matrix differs from A by at
///   most γ_{3n+2}|L||U|. Here L and U are the computed factors (Higham, Theorem 9.4).
/// - With partial pivoting, each row of |L||U| sums to at most n²·2ⁿ·max|A|.
/// - Let E be the sum of that difference and the rounding error of A, and d the rounding error of
///   f. In the maximum norm, the error of v is at most ‖A⁻¹‖(‖E‖‖v‖ + ‖d‖)/(1 − ‖A⁻¹‖‖E‖).
fn elimination(field: &Field, place: &Place, values: &[Q], unit: f64) -> Option<Vec<f64>> {
    let n = place.x.len();
    let over_divisors = |numerators: &[&Polynomial], width: usize| -> Option<Vec<Rounded>> {
        let divisors: Vec<&Polynomial> = field.denominators().collect();
        let divisors = computed(&divisors, values, unit);
        let above = computed(numerators, values, unit).into_iter().enumerate();
        above.map(|(i, value)| Some(value.over(&divisors[i / width])?.rounded(unit))).collect()
    };
    let numerators: Vec<&Polynomial> = field.numerators().collect();
    let velocity_error =
        over_divisors(&numerators, 1)?.iter().map(|component| component.error).fold(0.0, f64::max);

    let slope_numerators = field_jacobian(field);
    let slopes = over_divisors(&slope_numerators.iter().flatten().collect::<Vec<_>>(), n)?;
    let eps = float(&place.eps).abs();
    let entry_error = |(index, slope): (usize, &Rounded)| {
        let diagonal = if index / n == index % n { 1.0 } else { 0.0 };
        let gamma = gamma(2, unit);
        eps * slope.error * (1.0 + gamma) + gamma * (diagonal + eps * slope.size())
    };
    let entry_errors: Vec<f64> = slopes.iter().enumerate().map(entry_error).collect();
    let largest = slopes.iter().map(|slope| 1.0 + eps * (slope.size() + slope.error)).fold(0.0, f64::max);
    let growth = (n * n) as f64 * 2_f64.powi(n as i32) * largest * (1.0 + gamma(2, unit));
    let row_error = entry_errors.chunks(n).map(|row| row.iter().sum()).fold(0.0, f64::max);
    let matrix_error = row_error + gamma(3 * n + 2, unit) * growth;

    let inverse = inverse_norm(&exact_matrix(field, values));
    if inverse * matrix_error >= 0.5 {
        return None;
    }
    let velocity =
        (0..n).map(|i| float(&(&place.next[i] - &place.x[i])).abs()).fold(0.0, f64::max) / (2.0 * eps);
    let error = inverse * (matrix_error * velocity + velocity_error) / (1.0 - inverse * matrix_error);
    // The product with 2ε is rounded once more.
    Some(vec![2.0 * eps * (error + unit * (velocity + error)); n])
}

fn exact_matrix(field: &Field, values: &[Q]) -> Matrix {
    let row = |(row, component): (&Vec<Polynomial>, &RationalFunction)| {
        let divisor = evaluate(component.denominator(), values);
        row.iter().map(|entry| evaluate(entry, values) / &divisor).collect()
    };
    scaled_matrix(field).iter().zip(&field.components).map(row).collect()
}

/// Returns ‖M⁻¹‖ in the maximum norm, which is the largest row sum of absolute values.
fn inverse_norm(matrix: &[Vec<Q>]) -> f64 {
    let n = matrix.len();
    let determinant = float(&determinant(matrix)).abs();
    let mut sums = vec![0.0; n];
    for j in 0..n {
        let unit_vector: Vector = (0..n).map(|i| q(i64::from(i == j), 1)).collect();
        for (sum, entry) in sums.iter_mut().zip(adjugate_product(matrix, &unit_vector)) {
            *sum += float(&entry).abs() / determinant;
        }
    }
    sums.into_iter().fold(0.0, f64::max)
}
