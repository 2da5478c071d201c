//! Tests steps for every size of ε, in particular where generated code switches to another formula.
//! For small ε the error is about half an ulp. For large ε it is at most 64 u times the largest
//! component, as `try_step` guarantees, where u is the unit roundoff.

use kahan_algebra::prime_field::SplitMix64;
use kahan_tests::back_end::BackEnd;
use kahan_tests::doubles::exact;
use kahan_tests::exact::{Q, Vector};
use kahan_tests::maps::{Steps, steps};
use kahan_tests::rounding::UNIT_F64;
use kahan_tests::subject::{Subject, further, paper};
use num_traits::{Signed, ToPrimitive, Zero};

type Map<T> = Box<dyn Steps<T>>;

fn systems() -> Vec<(Subject, Map<f64>, Map<f32>)> {
    let subjects = paper().into_iter().chain(further());
    subjects
        .zip(steps().into_iter().zip(steps()))
        .map(|(subject, (double, single))| (subject, double, single))
        .collect()
}

fn point(draws: &mut SplitMix64, n: usize) -> Vec<f32> {
    let coordinate = |draws: &mut SplitMix64| {
        let size = 0.25 + 0.75 * draws.below(1 << 10) as f32 / 1024.0;
        if draws.below(2) == 0 { size } else { -size }
    };
    (0..n).map(|_| coordinate(draws)).collect()
}

fn largest(values: &[Q]) -> f64 {
    let size = values.iter().map(Signed::abs).max().unwrap_or_else(Q::zero);
    size.to_f64().expect("a rational has a nearby f64")
}

#[test]
fn at_zero_every_map_is_the_identity() {
    let mut draws = SplitMix64::new(71);
    for (subject, double, single) in systems() {
        let x = point(&mut draws, subject.dimension());
        let wide: Vec<f64> = x.iter().copied().map(f64::from).collect();
        for zero in [0.0, -0.0] {
            assert_eq!(double.step(&wide, zero), wide, "{}", subject.name);
            assert_eq!(double.try_step(&wide, zero).expect("no pole"), wide, "{}", subject.name);
            assert_eq!(single.step(&x, zero as f32), x, "{}", subject.name);
            assert_eq!(single.try_step(&x, zero as f32).expect("no pole"), x, "{}", subject.name);
        }
    }
}

/// For ε of size 2⁻⁶⁴ and below, the increment is far below the last digit, so the step returns x.
#[test]
fn a_tiny_half_step_moves_nothing() {
    let mut draws = SplitMix64::new(72);
    let border = 2.0_f64.powi(-64);
    let small = [
        f64::from_bits(1),
        f64::MIN_POSITIVE,
        1e-200,
        border / 2.0,
        border.next_down(),
        border,
        border.next_up(),
    ];
    for (subject, double, _) in systems() {
        let x: Vec<f64> = point(&mut draws, subject.dimension()).into_iter().map(f64::from).collect();
        for eps in small.into_iter().flat_map(|eps| [eps, -eps]) {
            assert_eq!(double.step(&x, eps), x, "{} at {eps:e}", subject.name);
            assert_eq!(double.try_step(&x, eps).expect("no pole"), x, "{} at {eps:e}", subject.name);
        }
    }
}

/// Near ε = 2⁻¹⁶, where `f32` steps switch between two formulas, both err by at most one ulp.
#[test]
fn steps_on_either_side_of_the_border_agree() {
    let mut draws = SplitMix64::new(73);
    let border = 2.0_f32.powi(-16);
    for (subject, _, single) in systems() {
        let x = point(&mut draws, subject.dimension());
        let state: Vector = x.iter().map(|entry| exact(*entry)).collect();
        for eps in [border.next_down(), border, -border, (-border).next_up(), 1.5 * border, 0.75 * border] {
            let next = subject.interpreted.step(&state, &exact(eps)).expect("no pole is near");
            for (component, true_component) in single.step(&x, eps).iter().zip(&next) {
                let error = largest(&[exact(*component) - true_component]);
                let ulp = f64::from(component.abs().next_up() - component.abs());
                assert!(error <= ulp, "{} at {eps:e}: {component}", subject.name);
            }
        }
    }
}

/// Near ε = 2⁶⁴, where steps switch to another formula, and for much larger ε, `try_step` fails, or
/// its error is at most 64 units of roundoff times the largest component.
#[test]
fn huge_half_steps_keep_the_promise() {
    let mut draws = SplitMix64::new(74);
    let border = 2.0_f64.powi(64);
    let mut kept = 0;
    for (subject, double, _) in systems() {
        let x: Vec<f64> = point(&mut draws, subject.dimension()).into_iter().map(f64::from).collect();
        let state: Vector = x.iter().map(|entry| exact(*entry)).collect();
        for eps in [1e6, border.next_down(), border, border.next_up(), -border, 1e40, -1e100] {
            let Ok(computed) = double.try_step(&x, eps) else { continue };
            kept += 1;
            let next = subject.interpreted.step(&state, &exact(eps)).expect("no pole where there is a step");
            let errors: Vec<Q> =
                computed.iter().zip(&next).map(|(value, exact_value)| exact(*value) - exact_value).collect();
            assert!(largest(&errors) <= 64.0 * UNIT_F64 * largest(&next), "{} at {eps:e}", subject.name);
        }
    }
    assert!(kept > 60, "{kept}");
}

#[test]
fn what_is_no_half_step_has_no_step() {
    let mut draws = SplitMix64::new(75);
    for (subject, double, _) in systems() {
        let x: Vec<f64> = point(&mut draws, subject.dimension()).into_iter().map(f64::from).collect();
        for eps in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(double.try_step(&x, eps).is_err(), "{} at {eps}", subject.name);
        }
        let nowhere = double.step(&x, f64::NAN);
        assert!(nowhere.iter().zip(&x).all(|(next, x)| next.is_nan() || next == x), "{}", subject.name);
    }
}
