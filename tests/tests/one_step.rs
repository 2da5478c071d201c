//! One fast step against the exact one, over the catalog: two bounds that users may count on.
//!
//! - Small steps, ε‖f′‖∞ ≤ 1e-3: each component is off by at most ½ ulp(x̃ᵢ) + 16 u·2ε·Σ|monomials of fᵢ(x)|. The half ulp is the
//!   one rounding of x + increment; the increment is a few roundings away from 2ε fᵢ, whose terms may cancel.
//! - Ordinary points, ε‖f′‖∞ ≤ 1 and |det A| ≥ 1/4: ‖x̃ − exact‖∞ ≤ 16 u ‖exact‖∞.
//!
//! Inputs are doubles with all their bits; the exact step is taken from the very numbers.

use kahan_algebra::prime_field::SplitMix64;
use kahan_algebra::symbols::Symbol;
use kahan_tests::exact::{Matrix, Q, Vector};
use kahan_tests::float_maps::{self, FloatMap};
use kahan_tests::rounding::UNIT_F64;
use kahan_tests::subject::{Subject, whole_catalog};
use num_traits::{Signed, ToPrimitive};

fn exact(value: f64) -> Q {
    Q::from_float(value).expect("a finite number")
}

fn float(value: &Q) -> f64 {
    value.to_f64().expect("a rational has a nearby f64")
}

/// Uniform in ±[0, 1), all bits random.
fn signed_unit(draws: &mut SplitMix64) -> f64 {
    let size = draws.below(1 << 53) as f64 / (1_u64 << 53) as f64;
    if draws.below(2) == 0 { size } else { -size }
}

/// ‖f′(x)‖∞
fn slope(subject: &Subject, x: &Vector) -> f64 {
    let rows: Matrix = subject.generated.field_jacobian(x);
    rows.iter().map(|row| row.iter().map(|entry| float(&entry.abs())).sum()).fold(0.0, f64::max)
}

/// Σ|monomials of fᵢ(x)|, each component.
fn monomials(subject: &Subject, x: &Vector) -> Vec<f64> {
    let symbols = &subject.system.field.symbols;
    let value = |variable| match symbols.symbol(variable) {
        Symbol::State(i) => float(&x[i].abs()),
        Symbol::Parameter(k) => float(&subject.parameters[k].abs()),
        other => panic!("{other:?} in a field"),
    };
    let components = subject.system.field.components.iter();
    let sums = components.map(|component| {
        assert!(component.denominator.is_one(), "no field of the catalog divides");
        let terms = component.numerator.terms().map(|(monomial, coefficient)| {
            let powers =
                monomial.powers().iter().map(|(variable, power)| value(*variable).powi(*power as i32));
            coefficient.to_f64().abs() * powers.product::<f64>()
        });
        terms.sum()
    });
    sums.collect()
}

/// The distance of a double from the next one away from zero.
fn ulp(value: f64) -> f64 {
    let size = value.abs();
    f64::from_bits(size.to_bits() + 1) - size
}

/// A step both ways: the float's, the exact one.
fn both(subject: &Subject, map: &dyn FloatMap<f64>, x: &[f64], eps: f64) -> Option<(Vec<f64>, Vector)> {
    let state: Vector = x.iter().map(|entry| exact(*entry)).collect();
    let next = subject.generated.step(&state, &exact(eps))?;
    Some((map.step(x, eps), next))
}

fn catalog() -> impl Iterator<Item = (Subject, Box<dyn FloatMap<f64>>)> {
    whole_catalog().into_iter().zip(float_maps::catalog())
}

#[test]
fn a_small_step_rounds_once_a_component() {
    for (index, (subject, map)) in catalog().enumerate() {
        let mut draws = SplitMix64::new(7100 + index as u64);
        for trial in 0..60 {
            // Every third point has components of very different sizes.
            let spread = if trial % 3 == 0 { 30 } else { 1 };
            let x: Vec<f64> = (0..subject.dimension())
                .map(|_| 4.0 * signed_unit(&mut draws) * 2.0_f64.powi(-(draws.below(spread) as i32)))
                .collect();
            let state: Vector = x.iter().map(|entry| exact(*entry)).collect();
            let eps = signed_unit(&mut draws) * 1e-3 / slope(&subject, &state).max(1e-3);
            let (computed, next) = both(&subject, map.as_ref(), &x, eps).expect("no pole is near");
            for (i, sum) in monomials(&subject, &state).iter().enumerate() {
                let error = float(&(exact(computed[i]) - &next[i]).abs());
                let bound = 0.5 * ulp(float(&next[i])) + 16.0 * UNIT_F64 * 2.0 * eps.abs() * sum;
                let name = subject.name;
                assert!(error <= bound, "{name}, component {i} at {x:?}, {eps:e}: {error:e} > {bound:e}");
            }
        }
    }
}

#[test]
fn a_step_from_an_ordinary_point_is_within_sixteen_units() {
    let mut worst = (0.0, String::new());
    for (index, (subject, map)) in catalog().enumerate() {
        let mut draws = SplitMix64::new(7200 + index as u64);
        let mut judged = 0;
        while judged < 150 {
            let x: Vec<f64> = (0..subject.dimension()).map(|_| 2.0 * signed_unit(&mut draws)).collect();
            let state: Vector = x.iter().map(|entry| exact(*entry)).collect();
            let eps = signed_unit(&mut draws) / slope(&subject, &state).max(1e-3);
            let determinant = subject.generated.det_matrix(&state, &exact(eps));
            if float(&determinant.abs()) < 0.25 {
                continue;
            }
            let Some((computed, next)) = both(&subject, map.as_ref(), &x, eps) else { continue };
            judged += 1;
            let size = next.iter().map(|entry| float(&entry.abs())).fold(0.0, f64::max);
            let errors = computed.iter().zip(&next).map(|(value, exact_value)| exact(*value) - exact_value);
            let error = errors.map(|error| float(&error.abs())).fold(0.0, f64::max);
            let units = error / (UNIT_F64 * size);
            if units > worst.0 {
                worst = (units, format!("{} at {x:?}, {eps:e}", subject.name));
            }
        }
    }
    let (units, place) = worst;
    assert!(units <= 16.0, "{units} u: {place}");
    assert!(units > 1.0, "a bound that nothing comes near says little: {units} u");
}
