//! Compares observers of maps read at run time with those of the macro's maps.

use kahan_core::observe::{
    Direction, FirstCrossings, Fli, Lyapunov, MeanLogDet, Observer, Sali, Section, Spectrum, TangentMap,
};
use kahan_core::prelude::*;
use kahan_core::{Compensated, Orbit, Step, Workspace};
use kahan_core::{Composition, KahanMap};
use kahan_runtime::{Field, MapAt};

kahan! {
    pub struct Lorenz { s, r, b }
    xdot = s*(y - x);
    ydot = x*(r - z) - y;
    zdot = x*y - b*z;
}

const TEXT: &str = "xdot = s*(y - x); ydot = x*(r - z) - y; zdot = x*y - b*z/c;";

fn lorenz() -> (Lorenz<f64>, MapAt<f64>) {
    let field = Field::parse(TEXT).unwrap();
    let map = field.with([("s", 10.0), ("r", 28.0), ("b", 2.5), ("c", 1.0)]).unwrap();
    (Lorenz { s: 10.0, r: 28.0, b: 2.5 }, map.at(0.005))
}

fn observed<O: Observer<f64>>(map: &MapAt<f64>, start: &[f64], steps: u64, mut observer: O) -> O::Report {
    let mut x = start.to_vec();
    observer.observe(0, &x);
    for step in 1..=steps {
        map.advance(&mut x, 1).unwrap();
        observer.observe(step, &x);
    }
    observer.report()
}

/// A chaotic orbit amplifies roundings, so the number of steps is small.
#[test]
fn reports_are_those_of_the_macro() {
    let (lorenz, map) = lorenz();
    for composition in [Composition::KAHAN, Composition::SUZUKI_4] {
        let map = map.composed(composition);
        let own = lorenz.at(0.005).composed(composition);
        let start = [1.0, 2.0, 20.0];
        let observers = (Lyapunov::new(&map), Spectrum::new(&map, 3, 5), MeanLogDet::new(&map));
        let indicators = (Fli::new(&map), Sali::new(&map));
        let ((largest, spectrum, mean), (fli, sali)) = observed(&map, &start, 200, (observers, indicators));
        let observers = (Lyapunov::new(&own), Spectrum::new(&own, 3, 5), MeanLogDet::new(&own));
        let mut orbit = lorenz.orbit(vector![1.0, 2.0, 20.0], 0.005).composed(composition);
        let ((own_largest, own_spectrum, own_mean), (own_fli, own_sali)) =
            orbit.observe(200, (observers, (Fli::new(&own), Sali::new(&own))));
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-9 * b.abs(), "{a} and {b}");
        close(largest.value, own_largest.value);
        spectrum.iter().zip(&own_spectrum).for_each(|(a, b)| close(a.value, b.value));
        close(mean, own_mean);
        close(spectrum.iter().map(|exponent| exponent.value).sum(), mean);
        close(fli, own_fli);
        close(sali, own_sali);
    }
}

#[test]
fn sections_are_refined_by_parts_of_a_step() {
    let (lorenz, map) = lorenz();
    let plane = |x: &[f64]| x[2] - 27.0;
    let found = observed(
        &map,
        &[1.0, 2.0, 20.0],
        1000,
        Section::new(&map, plane, Direction::Rising, FirstCrossings::new(9)),
    )
    .points;
    let own = lorenz.at(0.005);
    let own = lorenz
        .orbit(vector![1.0, 2.0, 20.0], 0.005)
        .observe(1000, Section::new(&own, plane, Direction::Rising, FirstCrossings::new(9)))
        .points;
    assert!(found.all == own.all && found.all > 3);
    let (first, own) = (&found.kept[0], &own.kept[0]);
    assert_eq!(first.step, own.step);
    for (a, b) in first.point.iter().zip(&own.point) {
        assert!((a - b).abs() < 1e-9, "{a} and {b}");
    }
}

#[test]
fn a_step_allocates_nothing() {
    let (_, map) = lorenz();
    let mut exponent = Lyapunov::new(&map);
    let mut x = [1.0, 2.0, 20.0];
    let mut go = |steps: std::ops::Range<u64>| {
        for step in steps {
            exponent.observe(step, &x);
            map.advance(&mut x, 1).unwrap();
        }
    };
    go(0..10);
    assert_eq!(allocation_counter::measure(|| go(10..50)).count_total, 0);
}

#[test]
fn modes_are_maps_of_their_own() {
    let (_, map) = lorenz();
    let (start, steps) = ([1.0, 2.0, 20.0], 50);
    let mut workspace = Workspace::new();
    for map in [map.clone(), map.composed(Composition::SUZUKI_4)] {
        let (mut x, mut carry) = (start, [0.0; 3]);
        map.advance_with_carry(&mut x, &mut carry, steps).unwrap();
        let beside = [start, [0.0; 3]].concat();
        let carried = Orbit::new(Compensated(&map), beside.clone()).nth(steps as usize).unwrap();
        assert_eq!(carried, [x, carry].concat());
        let mut at_once = beside;
        Compensated(map.clone()).advance(&mut at_once, steps, &mut workspace).unwrap();
        assert_eq!(at_once, carried);

        let (mut x, mut v) = (start, vec![0.5, -1.0, 2.0]);
        let beside = [&x[..], &v].concat();
        for _ in 0..steps {
            map.push_forward(&x, &mut v);
            map.advance(&mut x, 1).unwrap();
        }
        let with_vector = Orbit::new(map.tangent(), beside).nth(steps as usize).unwrap();
        assert_eq!(with_vector, [&x[..], &v].concat());

        let (mut x, mut rounded) = (start, start.map(|entry| entry as f32));
        ThroughF64::of_step(&map).advance(&mut rounded, steps, &mut workspace).unwrap();
        for _ in 0..steps {
            map.advance(&mut x, 1).unwrap();
            x = x.map(|entry| f64::from(entry as f32));
        }
        assert_eq!(rounded.map(f64::from), x);
    }
}
