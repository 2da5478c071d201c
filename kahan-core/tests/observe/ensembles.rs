//! Compares reports of ensembles with reports of single orbits, bit for bit.

use kahan_core::observe::{Extrema, Fli, Lyapunov, Megno, Observer, Sali};
use kahan_core::prelude::*;
use kahan_core::{Composition, Level};

use super::HenonHeiles;

const EPS: f64 = 0.05;
const STEPS: u64 = 333;

fn points(count: usize) -> Vec<SVector<f64, 4>> {
    (0..count).map(|i| vector![0.0, 0.9 - 1.8 * i as f64 / count as f64, 0.3, 0.1]).collect()
}

fn all<'a>(
    map: &'a KahanAt<HenonHeiles, f64, 4>,
) -> impl Observer<f64, Report: PartialEq + std::fmt::Debug + Send> + use<'a> {
    let variables = [0, 1, 2, 3].map(|i| Extrema::of(move |x: &[f64]| x[i]));
    let indicators = (Fli::new(map), Megno::new(map), Sali::new(map));
    (variables, Lyapunov::new(map), indicators)
}

/// Returns the debug text, in which the NaNs of escaping orbits are equal.
fn text(report: impl std::fmt::Debug) -> String {
    format!("{report:?}")
}

#[test]
fn reports_are_those_of_single_orbits_on_the_level_of_plain_code() {
    let map = HenonHeiles.at(EPS);
    let mut ensemble = Ensemble::new(points(37)).at_level(Level::Baseline).unwrap();
    let reports = ensemble.observe(&map, STEPS, |_| all(&map));
    assert_eq!(reports.len(), 37);
    for (start, report) in points(37).into_iter().zip(reports) {
        let alone = map.orbit(start).observe(STEPS, all(&map));
        assert_eq!(text(report), text(alone), "{start}");
    }
}

#[test]
fn the_points_are_those_of_advancing_and_tangents_those_of_one_trajectory_alone() {
    let map = HenonHeiles.at(EPS);
    for level in [Level::Baseline, Level::Avx2, Level::Avx512, Level::Neon]
        .into_iter()
        .filter(|level| level.is_available())
    {
        let ensemble = || Ensemble::new(points(50)).at_level(level).unwrap();
        let (mut observed, mut advanced) = (ensemble(), ensemble());
        let indicators = || (Sali::new(&map), Fli::new(&map));
        let together = observed.observe(&map, STEPS, |_| indicators());
        advanced.advance(&map, STEPS);
        assert_eq!(text(&observed), text(&advanced));
        let mut again = ensemble();
        let alone = || (Sali::new(map), Fli::new(map));
        assert_eq!(text(together), text(again.observe(&map, STEPS, |_| alone())));
    }
}

#[test]
fn neither_place_nor_number_of_trajectories_matters() {
    let map = HenonHeiles.at(EPS).composed(Composition::SUZUKI_4);
    let observe = |points: Vec<SVector<f64, 4>>, steps: u64| {
        Ensemble::new(points)
            .observe(&map, steps, |i| (Fli::new(&map), Extrema::of(move |_: &[f64]| i as f64)))
    };
    let many = observe(points(3000), 50);
    for (i, (fli, index)) in many.iter().enumerate() {
        assert_eq!(index.unwrap().least, i as f64);
        if i % 97 == 0 {
            let alone = observe(vec![points(3000)[i]], 50);
            assert_eq!(text(fli), text(alone[0].0), "{i}");
        }
    }
}

#[test]
fn single_precision_and_double_double_are_observed_too() {
    let single = HenonHeiles.at(0.05_f32);
    let starts = points(20).into_iter().map(|x| x.map(|entry| entry as f32)).collect();
    let reports = Ensemble::new(starts).observe(&single, STEPS, |_| Fli::new(&single));
    let wide = HenonHeiles.at(Dd::from(EPS));
    let starts = points(20).into_iter().map(|x| x.map(Dd::from)).collect();
    let wide = Ensemble::new(starts).observe(&wide, STEPS, |_| Fli::new(&wide));
    for (narrow, wide) in reports[5..15].iter().zip(&wide[5..15]) {
        assert!((narrow - wide).abs() < 1e-2, "{narrow} {wide}");
    }
}
