//! Tests orbits over floats: their first point, laziness and ownership.

use nalgebra::SVector;

use super::by_hand::{E1, E3};
use crate::{KahanAt, KahanMap, Orbit, vector};

/// Returns an orbit that outlives the map and the point from which it was made.
fn owned() -> Orbit<KahanAt<E3, f64, 3>> {
    let (map, start) = (E3, vector![0.1, 0.2, 0.3]);
    map.orbit(start, 0.05)
}

#[test]
fn an_orbit_begins_with_its_start_and_repeats_the_step() {
    let points: std::vec::Vec<SVector<f64, 3>> = owned().take(4).collect();
    assert_eq!(points[0], vector![0.1, 0.2, 0.3]);
    for pair in points.windows(2) {
        assert_eq!(pair[1], E3.step(&pair[0], 0.05));
    }
}

#[test]
fn a_prepared_map_makes_the_same_orbit() {
    let prepared = E3.at(0.05);
    assert_eq!((prepared.map(), *prepared.eps()), (&E3, 0.05));
    assert!(prepared.orbit(vector![0.1, 0.2, 0.3]).take(20).eq(owned().take(20)));
}

#[test]
fn a_float_orbit_goes_on_past_a_pole() {
    let mut orbit = E1.orbit(vector![-1.0_f64, 1.0, 0.0], 0.5);
    assert!(orbit.by_ref().take(3).last().is_some_and(|x| !x[0].is_finite()));
    assert_eq!(orbit.stopped(), None);
}

#[test]
fn a_clone_continues_from_the_same_point() {
    let mut orbit = owned();
    let _ = orbit.nth(5);
    assert_eq!(orbit.clone().next(), orbit.next());
}
