//! Compares the modes of orbits with the plain orbit and with each other.

use nalgebra::SVector;

#[cfg(feature = "std")]
use super::by_hand::E6;
use super::by_hand::{Coupled, E3};
use crate::{
    Compensated, Composed, Composition, Dd, FloatScalar, KahanAt, KahanMap, Orbit, nearest_short_eps, vector,
};
#[cfg(feature = "std")]
use crate::{Ensemble, Level};

const START: [f64; 3] = [0.3, -0.7, 1.1];

fn start() -> SVector<f64, 3> {
    SVector::from(START)
}

#[test]
fn a_mode_is_a_type_that_can_be_written() {
    let compensated: Orbit<Compensated<KahanAt<E3, f64, 3>>> = E3.orbit(start(), 0.05).compensated();
    let both: Orbit<Compensated<Composed<KahanAt<E3, f64, 3>>>> =
        E3.at(0.05).orbit(start()).composed(Composition::SUZUKI_4).compensated();
    assert_eq!(compensated.clone().next(), Some(start()));
    assert_eq!(both.clone().next(), Some(start()));
    assert_eq!((compensated.stopped(), both.stopped()), (None, None));
}

#[test]
fn the_order_in_which_modes_are_asked_for_does_not_matter() {
    let orbit = || Coupled.orbit(vector![0.1, 0.2, -0.1, 0.3], 0.01);
    let one = orbit().compensated().composed(Composition::KAHAN_LI_6);
    let other = orbit().composed(Composition::KAHAN_LI_6).compensated();
    assert!(one.take(30).eq(other.take(30)));
}

#[test]
fn skipping_gives_the_points_of_stepping() {
    fn agrees<I: Iterator<Item = SVector<f64, 3>> + Clone>(orbit: I) {
        let points: std::vec::Vec<_> = orbit.clone().take(12).collect();
        for (n, point) in points.iter().enumerate() {
            let mut skipping = orbit.clone();
            assert_eq!(skipping.nth(n), Some(*point));
            assert_eq!(skipping.next(), orbit.clone().nth(n + 1));
        }
        assert!(orbit.step_by(5).take(3).eq([points[0], points[5], points[10]]));
    }
    let orbit = || E3.orbit(start(), 0.05);
    agrees(orbit());
    agrees(orbit().compensated());
    agrees(orbit().composed(Composition::SUZUKI_4));
    agrees(orbit().composed(Composition::SUZUKI_4).compensated());
}

#[test]
fn a_mode_goes_on_from_where_the_orbit_is() {
    let mut orbit = E3.orbit(start(), 0.05);
    let third = orbit.nth(3).unwrap();
    let stage = E3.at(0.05).composed(Composition::TRIPLE_JUMP);
    assert_eq!(orbit.clone().composed(Composition::TRIPLE_JUMP).next(), Some(stage.step(&third)));
    assert_eq!(orbit.clone().compensated().next(), Some(E3.step(&third, 0.05)));
}

#[test]
fn a_composition_is_its_stages_in_order() {
    for composition in Composition::ALL {
        let eps = 0.05;
        let by_stages =
            composition.coefficients().fold(start(), |x, gamma| E3.step(&x, gamma.to_f64() * eps));
        let map = E3.at(eps).composed(composition);
        assert_eq!(map.step(&start()), by_stages, "{composition:?}");
        assert_eq!(map.orbit(start()).nth(1), Some(by_stages), "{composition:?}");
        assert_eq!(composition.coefficients().count(), composition.stages());
        assert!(
            composition
                .coefficients()
                .rev()
                .map(crate::Constant::to_f64)
                .eq(composition.coefficients().map(crate::Constant::to_f64))
        );
    }
    assert_eq!(E3.at(0.05).composed(Composition::KAHAN).step(&start()), E3.step(&start(), 0.05));
}

/// At ε ≈ 2⁻⁴⁰, a plain orbit keeps only 13 bits of each increment.
#[test]
fn small_increments_are_not_lost() {
    let (start, eps, steps) = (vector![1.0_f64, 0.5, 1.5], 1e-12, 100_000);
    // One step over the total time errs by about (2·steps·ε)³ = 8e-21, far below an ulp.
    let there = E3.step(&start, eps * f64::from(steps));
    let error = |x: Option<SVector<f64, 3>>| (x.unwrap() - there).amax();
    let plain = error(E3.orbit(start, eps).nth(steps as usize));
    let compensated = error(E3.orbit(start, eps).compensated().nth(steps as usize));
    // The last point and the long step each err by about `EPSILON`/2.
    assert!(compensated <= f64::EPSILON * 1.5, "{compensated:e}");
    assert!(plain > 20.0 * compensated, "{plain:e}");
}

#[test]
fn a_short_eps_is_the_nearest_and_its_cube_is_exact() {
    for eps in [0.05_f64, 0.1, 1.0 / 3.0, -0.7, 1e-3, 1e-300] {
        let short = nearest_short_eps(eps);
        let units = short / (eps.abs().log2().floor() - 16.0).exp2();
        assert_eq!(units.fract(), 0.0, "{eps}: {short}");
        assert!((short - eps).abs() <= eps.abs() * 2_f64.powi(-17), "{eps}: {short}");
        assert_eq!(nearest_short_eps(short), short);
    }
    let (short, long) = (nearest_short_eps(0.05_f32), nearest_short_eps(0.05_f64));
    assert_eq!(f64::from(short).powi(3), f64::from(short.powi(3)));
    assert_eq!((short * 4096.0).fract(), 0.0);
    assert_eq!(
        (long.mul_add(long, -(long * long)), long.mul_add(long * long, -(long * long * long))),
        (0.0, 0.0)
    );
    assert!(0.05_f64.mul_add(0.05, -(0.05 * 0.05)) != 0.0);
    assert!(nearest_short_eps(f64::NAN).is_nan());
    assert_eq!(nearest_short_eps(f64::INFINITY), f64::INFINITY);
    assert!(nearest_short_eps(f64::MAX).is_finite() && nearest_short_eps(f32::MAX).is_finite());
}

#[test]
fn a_short_double_double_is_the_nearest() {
    let unit = 2_f64.powi(-34);
    let middle = 1.0 + unit / 2.0;
    let short = |high, low| nearest_short_eps(Dd::new(high, low)).high();
    assert_eq!(
        (short(middle, 0.0), short(middle, 1e-20), short(middle, -1e-20)),
        (1.0 + unit, 1.0 + unit, 1.0)
    );
    assert_eq!(
        (short(-middle, 0.0), short(-middle, 1e-20), short(-middle, -1e-20)),
        (-1.0 - unit, -1.0, -1.0 - unit)
    );
    let third = nearest_short_eps(Dd::from(1.0) / Dd::from(3.0));
    assert_eq!((third.low(), (third.high() * 2_f64.powi(36)).fract(), Dd::SHORT_BITS), (0.0, 0.0, 35));
    assert!((third.high() - 1.0 / 3.0).abs() <= unit / 8.0);
    assert!(nearest_short_eps(Dd::from(f64::MAX)).high().is_finite());
}

/// The baseline rounds like a single orbit. Higher instruction sets fuse multiply-adds.
#[cfg(feature = "std")]
#[test]
fn an_ensemble_takes_the_steps_of_a_composed_orbit() {
    let points: std::vec::Vec<SVector<f64, 3>> =
        (0..37).map(|k| vector![0.3, -0.7, 0.03 * f64::from(k)]).collect();
    let map = E6.at(0.05).composed(Composition::KAHAN_LI_8);
    let alone = |x: &SVector<f64, 3>| map.orbit(*x).nth(20).unwrap();

    let mut ensemble = Ensemble::new(points.clone()).at_level(Level::Baseline).unwrap();
    ensemble.advance(&map, 20);
    assert!(ensemble.points().eq(points.iter().map(alone)));

    let mut ensemble = Ensemble::new(points.clone());
    ensemble.advance(&map, 20);
    for (x, y) in ensemble.points().zip(points.iter().map(alone)) {
        assert!((x - y).amax() <= 20.0 * 17.0 * 4.0 * f64::EPSILON);
    }
}
