//! Tests Lyapunov exponents.

use kahan_core::observe::{Lyapunov, MeanLogDet, Sali, Spectrum};
use kahan_core::prelude::*;
use kahan_core::{Composition, Ensemble};

use super::LORENZ;
use crate::systems::E6;

/// At this ε, the sum of exponents errs by less than 0.02.
#[test]
fn lorenz_has_the_exponents_of_the_literature() {
    let map = LORENZ.at(0.0025);
    let observers = (Spectrum::new(&map, 3, 5), Lyapunov::new(&map));
    let start = map.orbit(vector![1.0, 1.0, 20.0]).nth(8_000).unwrap();
    let (spectrum, largest) = map.orbit(start).observe(200_000, observers);
    for (found, known) in spectrum.iter().zip([0.9056, 0.0, -14.5723]) {
        assert!(found.error < 0.05, "{found:?}");
        assert!((found.value - known).abs() < 2.0 * found.error + 0.02, "{found:?} is not {known}");
    }
    assert!((largest.value - spectrum[0].value).abs() < 0.01, "{largest:?} {spectrum:?}");
}

kahan! {
    /// A linear field with the growth rates a and b along the axes.
    struct Along { a, b }
    xdot = a*x;
    ydot = b*y;
}

/// For an eigenvalue λ, each step multiplies by (1 + ελ)/(1 − ελ), with a relative error of about
/// 10 rounding units. An exponent errs by this error divided by 2ε.
#[test]
fn linear_fields_have_the_exponents_of_their_cayley_transform() {
    let (a, b, eps) = (0.75, -1.5, 1.0 / 32.0);
    let map = Along { a, b }.at(eps);
    let spectrum = map.orbit(vector![1.0, 1.0]).observe(1000, Spectrum::new(&map, 2, 7));
    let largest = Along { a: b, b }.at(eps);
    let largest = largest.orbit(vector![1.0, 1.0]).observe(1000, Lyapunov::new(&largest));
    let exact = |lambda: f64| ((1.0 + eps * lambda) / (1.0 - eps * lambda)).ln() / (2.0 * eps);
    let bound = 10.0 * f64::EPSILON / (2.0 * eps);
    for (found, lambda) in [(spectrum[0].value, a), (spectrum[1].value, b), (largest.value, b)] {
        assert!((found - exact(lambda)).abs() < bound, "{found} is not {}", exact(lambda));
    }
}

/// Each step multiplies tangent vectors v by 2⁴⁰ or 2⁻⁴⁰. The computed result is v plus an
/// increment. With 2⁻⁴⁰, the increment is close to −v, and only 13 bits of the sum are correct.
#[test]
fn steep_growth_leaves_no_range() {
    let eps = 1.0 - 2_f64.powi(-39);
    for sign in [1.0, -1.0] {
        let map = Along { a: sign, b: sign }.at(eps);
        let observers = || (Lyapunov::new(&map), Sali::new(&map));
        let alone = map.orbit(vector![0.0, 0.0]).observe(1007, observers());
        let many = Ensemble::new(vec![vector![0.0, 0.0]; 16]).observe(&map, 1007, |_| observers());
        let exact = sign * ((1.0 + eps) / (1.0 - eps)).ln() / (2.0 * eps);
        for (found, sali) in many.into_iter().chain([alone]) {
            let bound = if sign > 0.0 { 10.0 * f64::EPSILON } else { 2_f64.powi(-13) };
            assert!((found.value - exact).abs() < bound, "{found:?} is not {exact}");
            assert!(sali > 0.1, "both directions grow alike: {sali}");
        }
    }
}

#[test]
fn an_integrable_map_has_no_exponent_beyond_its_error() {
    for eps in [0.02, 0.1] {
        let map = E6.at(eps);
        let start = vector![0.3, 0.8, 0.5];
        let observers = (Lyapunov::new(&map), Spectrum::new(&map, 3, 1));
        let (largest, spectrum) = map.orbit(start).observe(100_000, observers);
        for found in spectrum.iter().chain([&largest]) {
            assert!(found.value.abs() < found.error && found.error < 0.02, "{found:?}");
        }
    }
}

/// In n variables, n tangent vectors are orthogonalised. The product of their lengths has about n²
/// rounding errors, multiplied by the Jacobian's condition number, which is below 2 here.
#[test]
fn all_exponents_together_are_the_mean_of_the_logarithm_of_the_determinant() {
    let (start, steps) = (vector![1.0, 1.0, 20.0], 5_000);
    let bound = |eps: f64| 9.0 * 2.0 * 4.0 * f64::EPSILON / (2.0 * eps);
    for (every, eps) in [(1, 0.01), (4, 0.002)] {
        let map = LORENZ.at(eps);
        let observers = (Spectrum::new(&map, 3, every), MeanLogDet::new(&map));
        let (spectrum, mean) = map.orbit(start).observe(steps, observers);
        let sum: f64 = spectrum.iter().map(|exponent| exponent.value).sum();
        assert!((sum - mean).abs() < bound(eps), "{sum} {mean}");
        let points = map.orbit(start).take(steps as usize);
        let logarithms = points.map(|x| LORENZ.det_jacobian(&x, eps).abs().ln());
        let plain = logarithms.sum::<f64>() / (2.0 * eps * steps as f64);
        assert!((mean - plain).abs() < bound(eps), "{mean} {plain}");
        let composed = map.composed(Composition::SUZUKI_4);
        let observers = (Spectrum::new(&composed, 3, every), MeanLogDet::new(&composed));
        let (spectrum, mean) = composed.orbit(start).observe(steps, observers);
        let sum: f64 = spectrum.iter().map(|exponent| exponent.value).sum();
        assert!((sum - mean).abs() < 5.0 * bound(eps), "{sum} {mean}");
        // The flow's divergence is constant.
        assert!((mean + 41.0 / 3.0).abs() < 1e-3, "{mean}");
    }
}

#[test]
fn growth_beyond_the_range_of_floats_is_kept() {
    let map = Along { a: 30.0_f32, b: 30.0 }.at(1.0 / 32.0);
    // A step multiplies tangent vectors by 31, and 1000 steps multiply them by 10¹⁴⁹¹.
    let still = || map.orbit(vector![0.0, 0.0]);
    let exact = 31_f64.ln() * 16.0;
    let found = still().observe(1000, Lyapunov::new(&map));
    assert!((found.value - exact).abs() < 1e-5 * exact, "{found:?}");
    let mean = still().observe(1000, MeanLogDet::new(&map));
    assert!((mean - 2.0 * exact).abs() < 1e-5 * exact, "{mean}");
}
