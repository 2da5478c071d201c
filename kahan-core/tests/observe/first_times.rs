//! Tests escape, return, residence, extrema, several observers at once, and orbits that end.

use kahan_core::observe::{Escape, Extrema, Period, Residence};
use kahan_core::prelude::*;

use crate::systems::{E6, Turn};

#[test]
fn step_0_is_the_first_point_and_the_orbit_goes_on_where_it_was_left() {
    let mut orbit = E6.orbit(vector![0.3, 0.8, 0.5], 0.05);
    let steps = |x: Option<SVector<f64, 3>>| x.unwrap().data.0[0];
    let mut points = E6.orbit(vector![0.3, 0.8, 0.5], 0.05);
    let first = orbit.observe(0, Extrema::of(|x: &[f64]| x[0])).unwrap();
    assert_eq!([first.least, first.greatest], [0.3, 0.3]);
    assert_eq!(orbit.next().map(|x| x.data.0[0]), Some(steps(points.nth(1))));
    let seen = orbit.observe(7, Extrema::of(|x: &[f64]| x[0])).unwrap();
    let plain: Vec<f64> = points.by_ref().take(8).map(|x| x[0]).collect();
    assert_eq!(seen.least, plain.iter().copied().fold(f64::INFINITY, f64::min));
    assert_eq!(seen.greatest, plain.iter().copied().fold(f64::NEG_INFINITY, f64::max));
    assert_eq!(orbit.next(), points.next());
}

#[test]
fn compensated_and_scaled_orbits_show_the_points_that_they_yield() {
    let last = |x: &[f64]| x[1];
    let start = vector![0.3, 0.8, 0.5];
    let compensated = || E6.orbit(start, 0.05).compensated();
    let seen = compensated().observe(100, [Extrema::of(last)]);
    let greatest = compensated().take(101).map(|x| x[1]).fold(f64::NEG_INFINITY, f64::max);
    assert_eq!(seen[0].unwrap().greatest, greatest);
    let scaled = || E6.orbit(start, 0.05).scaled().unwrap();
    let seen = scaled().observe(100, vec![Extrema::of(last)]);
    let greatest = scaled().take(101).map(|x| x[1]).fold(f64::NEG_INFINITY, f64::max);
    assert_eq!(seen[0].unwrap().greatest, greatest);
}

#[test]
fn returns_are_counted_after_leaving() {
    let slow = Turn.at(0.01);
    let back = slow.orbit(vector![1.0, 0.0]).observe(1000, Period::within(0.1, [0.0; 2])).unwrap();
    // The orbit is within 0.1 of the start after 309.17 of 2π/(2 arctan ε) = 314.17 steps.
    assert_eq!(back.step, 310);
    assert_eq!(slow.orbit(vector![1.0, 0.0]).observe(300, Period::within(0.1, [0.0; 2])), None);
}

#[test]
fn a_histogram_counts_every_point_once() {
    let parts = Residence::of(|x: &[f64]| x[0], -0.5..0.5, vec![0; 10]);
    let stays = Turn.orbit(vector![1.0, 0.0], 0.01).observe(9999, parts);
    assert_eq!(stays.within.iter().sum::<u64>() + stays.outside, 10_000);
    // A third of the circle has |x| < ½. Each of 32 revolutions may err by one point.
    assert!(stays.outside.abs_diff(6667) < 64, "{stays:?}");
    assert!(stays.within.iter().all(|&count| count.abs_diff(333) < 40), "{stays:?}");
}

#[test]
fn what_is_asked_for_stops_at_its_first_time() {
    let condition = |x: &[f64]| x[0] < 0.0;
    let (out, never, at_once) = Turn.orbit(vector![1.0, 0.0], 0.01).observe(
        1000,
        (Escape::when(condition), Escape::when(|x: &[f64]| x[0] > 2.0), Escape::when(|_: &[f64]| true)),
    );
    assert_eq!((out, never, at_once), (Some(79), None, Some(0)));
}
