//! How far a float step may be from the exact one: a bound derived from the plan that the code was
//! written from, with and without fused multiply-adds.
//!
//! In: a system, a point whose numbers the float has exactly, the unit roundoff u. Out: a bound on
//! |x̂̃ − x̃| for each component. Notation: γ_k = k·u/(1 − k·u); a product of k factors (1 + δ),
//! |δ| ≤ u, or their reciprocals, is 1 + θ with |θ| ≤ γ_k (Higham, Accuracy and Stability of
//! Numerical Algorithms, Lemma 3.1). Underflow is not covered: callers choose points away from it.
//! The bound itself is computed in f64 from positive terms, which errs by far less than the last
//! factor.

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

/// 2⁻⁵³ and 2⁻²⁴.
pub const UNIT_F64: f64 = f64::EPSILON / 2.0;
/// See [`UNIT_F64`].
pub const UNIT_F32: f64 = f32::EPSILON as f64 / 2.0;

/// For what the bound's own evaluation in f64 may lose.
const INFLATION: f64 = 1.0 + 1e-6;

/// γ_k
fn gamma(k: usize, unit: f64) -> f64 {
    let ku = k as f64 * unit;
    ku / (1.0 - ku)
}

/// Where a float step is taken, with the exact step from there.
#[derive(Clone, Debug)]
pub struct Place {
    /// x
    pub x: Vector,
    /// ε
    pub eps: Q,
    /// x̃
    pub next: Vector,
}

/// Bounds on the errors of one system's float steps, by the closed form or by elimination,
/// whichever the macro took.
#[derive(Debug)]
pub struct StepBound<'a> {
    field: &'a Field,
    parameters: &'a [Q],
    step: Option<StepPlan>,
    unit: f64,
}

impl<'a> StepBound<'a> {
    /// For floats with this unit roundoff.
    #[must_use]
    pub fn new(subject: &'a Subject, unit: f64) -> Self {
        let field = &subject.system.field;
        Self { field, parameters: &subject.parameters, step: derive(subject.system).step().cloned(), unit }
    }

    /// A bound for each component of x̃; `None` where it cannot promise a digit, because a divisor
    /// may round to zero.
    #[must_use]
    pub fn at(&self, place: &Place) -> Option<Vec<f64>> {
        let values: Vec<Q> = place.x.iter().chain(self.parameters).chain([&place.eps]).cloned().collect();
        let increments = match &self.step {
            Some(step) => closed_form(step, place, &values, self.unit)?,
            None => elimination(self.field, place, &values, self.unit)?,
        };
        // x̃ = fl(x + increment): (1 + δ)(x + increment + error).
        let bound = |(error, next): (f64, &Q)| {
            INFLATION * (error * (1.0 + self.unit) + self.unit * float(next).abs())
        };
        Some(increments.into_iter().zip(&place.next).map(bound).collect())
    }
}

/// The polynomials as the emitted plan computes them.
fn computed(polynomials: &[&Polynomial], values: &[Q], unit: f64) -> Vec<Rounded> {
    let plan = plan_of(polynomials.iter().copied());
    let results = running_bound::results(&plan, &[], unit, |variable| exact(values, variable));
    results.into_iter().map(|value| value.expect("a polynomial has a value")).collect()
}

fn exact(values: &[Q], variable: Variable) -> Rational {
    values[usize::from(variable.0)].clone().into()
}

/// The errors of the products numerator · reciprocal, the prepared constants' own included.
///
/// # Panics
/// If the plan is not that of the map: its exact results are compared with x̃.
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

/// The error of 2ε·v, v = A⁻¹f by elimination with partial pivoting.
///
/// Elimination solves (Â + ΔA)v̂ = f̂ with |ΔA| ≤ γ_{3n}|L̂||Û| (Higham, Theorem 9.4); here
/// multipliers and back substitution use a rounded reciprocal, one rounding more in each, so
/// γ_{3n+2}. Partial pivoting has |L̂| ≤ 1 (a multiplier may round to at most 1 + 2u, covered by
/// the factor 2 in what follows) and |Û| ≤ 2ⁿ⁻¹ max|Â|, so each row of |L̂||Û| sums to at most
/// n²·2ⁿ·max|Â|. In Â and f̂ each slope and each component is a quotient of planned polynomials,
/// rounded once; A takes two roundings more, of the product with ε and of 1 − εf′. With E the sum
/// of the two matrix errors, ‖v̂ − v‖ ≤ ‖A⁻¹‖(‖E‖‖v‖ + ‖f̂ − f‖)/(1 − ‖A⁻¹‖‖E‖), maximum norms.
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
    // One more rounding: the product with 2ε.
    Some(vec![2.0 * eps * (error + unit * (velocity + error)); n])
}

/// A(x,ε): the rows of Â over the parameters' divisors.
fn exact_matrix(field: &Field, values: &[Q]) -> Matrix {
    let row = |(row, component): (&Vec<Polynomial>, &RationalFunction)| {
        let divisor = evaluate(component.denominator(), values);
        row.iter().map(|entry| evaluate(entry, values) / &divisor).collect()
    };
    scaled_matrix(field).iter().zip(&field.components).map(row).collect()
}

/// ‖M⁻¹‖ in the maximum norm: the largest sum of a row's absolute values.
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
