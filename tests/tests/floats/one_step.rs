//! Tests two bounds on the error of one step in floats, over the catalog.
//!
//! # Bounds
//!
//! Let u be the unit roundoff, x̃ the computed next point, y the exact next point, and f the field.
//!
//! - Small steps, ε‖f′‖∞ ≤ 1e-3: |x̃ᵢ − yᵢ| ≤ ½ ulp(x̃ᵢ) + 32 uεS. Here S sums the absolute values
//!   of the monomials of fᵢ, with max(|xⱼ|, |x̃ⱼ|) in place of each variable.
//! - Ordinary points, ε‖f′‖∞ ≤ 1 and |det A| ≥ 1/4: ‖x̃ − y‖∞ ≤ 16 u max(‖x‖∞, ‖y‖∞).
//!
//! Large samples are compared with double-double instead of exact steps.

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::symbols::Symbol;
use kahan_core::Dd;
use kahan_tests::back_end::BackEnd;
use kahan_tests::doubles::{exact, float, signed_unit, ulp};
use kahan_tests::exact::{Matrix, Vector};
use kahan_tests::maps::{Steps, steps};
use kahan_tests::rounding::UNIT_F64;
use kahan_tests::subject::{Subject, further, paper};
use num_traits::Signed;

/// Returns ‖f′(x)‖∞, the maximum norm of the field's Jacobian matrix.
fn slope(subject: &Subject, x: &Vector) -> f64 {
    let rows: Matrix = subject.generated.field_jacobian(x);
    rows.iter().map(|row| row.iter().map(|entry| float(&entry.abs())).sum()).fold(0.0, f64::max)
}

fn monomials(subject: &Subject, x: &Vector, y: &Vector) -> Vec<f64> {
    let symbols = &subject.system.field.symbols;
    let value = |variable| match symbols.symbol(variable) {
        Symbol::State(i) => float(&x[i].abs()).max(float(&y[i].abs())),
        Symbol::Parameter(k) => float(&subject.parameters[k].abs()),
        other => panic!("{other:?} in a field"),
    };
    let components = subject.system.field.components.iter();
    let sums = components.map(|component| {
        assert!(component.denominator().is_one(), "no field of the catalog divides");
        let terms = component.numerator().terms().map(|(monomial, coefficient)| {
            let powers =
                monomial.powers().iter().map(|(variable, power)| value(*variable).powi(*power as i32));
            coefficient.to_f64().abs() * powers.product::<f64>()
        });
        terms.sum()
    });
    sums.collect()
}

/// A system with its map over doubles. Steps are compared with steps of `judge` in double-double,
/// or with exact steps if `judge` is `None`.
struct Case {
    subject: Subject,
    map: Box<dyn Steps<f64>>,
    judge: Option<Box<dyn Steps<Dd>>>,
}

impl Case {
    fn both(&self, x: &[f64], eps: f64) -> Option<(Vec<f64>, Vector)> {
        let next = match &self.judge {
            None => {
                let state: Vector = x.iter().map(|entry| exact(*entry)).collect();
                self.subject.interpreted.step(&state, &exact(eps))?
            }
            Some(wide) => {
                let state: Vec<Dd> = x.iter().map(|entry| Dd::from(*entry)).collect();
                let next = wide.step(&state, Dd::from(eps));
                next.iter().map(|entry| exact(entry.high()) + exact(entry.low())).collect()
            }
        };
        Some((self.map.step(x, eps), next))
    }
}

fn every_system() -> impl Iterator<Item = Case> {
    let systems = paper().into_iter().chain(further()).zip(steps());
    systems.map(|(subject, map)| Case { subject, map, judge: None })
}

fn judged_in_double_double() -> impl Iterator<Item = Case> {
    every_system().zip(steps()).map(|(case, judge)| Case { judge: Some(judge), ..case })
}

#[derive(Debug, Default)]
struct Worst {
    part: f64,
    place: String,
}

impl Worst {
    fn see(&mut self, part: f64, place: impl FnOnce() -> String) {
        if part > self.part || part.is_nan() {
            *self = Worst { part, place: place() };
        }
    }
}

/// Makes small steps of one system. Returns the largest error relative to its bound.
fn small_steps(case: &Case, seed: u64, points: usize) -> Worst {
    let subject = &case.subject;
    let (mut worst, mut draws) = (Worst::default(), SplitMix64::new(seed));
    for trial in 0..points {
        // In every third point the components have very different sizes.
        let spread = if trial % 3 == 0 { 30 } else { 1 };
        let x: Vec<f64> = (0..subject.dimension())
            .map(|_| 4.0 * signed_unit(&mut draws) * 2.0_f64.powi(-(draws.below(spread) as i32)))
            .collect();
        let state: Vector = x.iter().map(|entry| exact(*entry)).collect();
        let eps = signed_unit(&mut draws) * 1e-3 / slope(subject, &state).max(1e-3);
        let (computed, next) = case.both(&x, eps).expect("no pole is near");
        for (i, sum) in monomials(subject, &state, &next).iter().enumerate() {
            let error = float(&(exact(computed[i]) - &next[i]).abs());
            let bound = 0.5 * ulp(float(&next[i])) + 16.0 * UNIT_F64 * 2.0 * eps.abs() * sum;
            worst.see(error / bound, || format!("{}, component {i} at {x:?}, {eps:e}", subject.name));
        }
    }
    worst
}

/// Makes steps from ordinary points. Returns the largest error in units of roundoff.
fn ordinary_steps(case: &Case, seed: u64, points: usize) -> Worst {
    let subject = &case.subject;
    let (mut worst, mut draws) = (Worst::default(), SplitMix64::new(seed));
    let mut judged = 0;
    while judged < points {
        let x: Vec<f64> = (0..subject.dimension()).map(|_| 2.0 * signed_unit(&mut draws)).collect();
        let state: Vector = x.iter().map(|entry| exact(*entry)).collect();
        let eps = signed_unit(&mut draws) / slope(subject, &state).max(1e-3);
        let determinant = float(&subject.generated.det_matrix(&state, &exact(eps)));
        if determinant.abs() < 0.25 {
            continue;
        }
        let Some((computed, next)) = case.both(&x, eps) else { continue };
        judged += 1;
        let size = next.iter().map(|entry| float(&entry.abs())).fold(0.0, f64::max);
        let errors = computed.iter().zip(&next).map(|(value, exact_value)| exact(*value) - exact_value);
        let error = errors.map(|error| float(&error.abs())).fold(0.0, f64::max);
        let start = x.iter().fold(0.0_f64, |size, entry| size.max(entry.abs()));
        worst.see(error / (UNIT_F64 * size.max(start)), || {
            format!(
                "{} at {x:?}, {eps:e}; |x| = {start:.3}, |x~| = {size:.3}, det A = {determinant:.3}",
                subject.name
            )
        });
    }
    worst
}

#[test]
fn a_small_step_rounds_once_a_component() {
    for (index, case) in every_system().enumerate() {
        let Worst { part, place } = small_steps(&case, 7100 + index as u64, 60);
        assert!(part <= 1.0, "{part} of the bound: {place}");
    }
}

#[test]
fn a_step_from_an_ordinary_point_is_within_sixteen_units() {
    let mut largest = 0.0_f64;
    for (index, case) in every_system().enumerate() {
        let Worst { part: units, place } = ordinary_steps(&case, 7200 + index as u64, 150);
        assert!(units <= 16.0, "{units} u: {place}");
        largest = largest.max(units);
    }
    assert!(largest > 1.0, "a bound that nothing comes near says little: {largest} u");
}

const MANY: usize = 20_000;

#[test]
#[ignore = "a minute in a release build"]
fn small_steps_of_a_large_sample_round_once_a_component() {
    let mut largest = 0.0_f64;
    for (index, case) in judged_in_double_double().enumerate() {
        let Worst { part, place } = small_steps(&case, 8100 + index as u64, MANY);
        println!("{part:.3} of the bound: {place}");
        largest = largest.max(part);
    }
    assert!(largest <= 1.0, "{largest} of the bound");
}

#[test]
#[ignore = "a minute in a release build"]
fn steps_from_a_large_sample_of_ordinary_points_are_within_sixteen_units() {
    let mut largest = 0.0_f64;
    for (index, case) in judged_in_double_double().enumerate() {
        let Worst { part: units, place } = ordinary_steps(&case, 8200 + index as u64, MANY);
        println!("{units:.2} u: {place}");
        largest = largest.max(units);
    }
    assert!(largest <= 16.0, "{largest} u");
}
