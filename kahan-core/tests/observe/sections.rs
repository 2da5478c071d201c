//! Compares sections of the Hénon–Heiles system with a plain loop.

use kahan_core::observe::{Crossing, Direction, FirstCrossings, Section};
use kahan_core::prelude::*;

use super::HenonHeiles;

const START: [f64; 4] = [0.0, 0.1, 0.45, 0.1];

fn crossings(eps: f64, steps: u64, direction: Direction) -> Vec<Crossing<SVector<f64, 4>, f64>> {
    let map = HenonHeiles.at(eps);
    let section = Section::new(&map, |x: &[f64]| x[0], direction, FirstCrossings::new(10_000));
    let found = map.orbit(START.into()).observe(steps, section);
    assert_eq!((found.points.all as usize, found.jumps), (found.points.kept.len(), 0));
    found.points.kept
}

#[test]
fn crossings_are_those_of_a_plain_loop() {
    let (eps, steps) = (0.05, 20_000);
    let points: Vec<_> = HenonHeiles.orbit(START.into(), eps).take(steps + 1).collect();
    let plain = |rises: bool| {
        let crosses = move |pair: &[SVector<f64, 4>]| {
            let (before, after) = (pair[0][0], pair[1][0]);
            if rises { before < 0.0 && after >= 0.0 } else { before > 0.0 && after <= 0.0 }
        };
        points.windows(2).enumerate().filter(move |(_, pair)| crosses(pair)).map(|(step, _)| step)
    };
    let [rising, falling, both] =
        [Direction::Rising, Direction::Falling, Direction::Both].map(|way| crossings(eps, steps as u64, way));
    assert!(plain(true).eq(rising.iter().map(|crossing| crossing.step as usize)));
    assert!(plain(false).eq(falling.iter().map(|crossing| crossing.step as usize)));
    assert_eq!(both.len(), rising.len() + falling.len());
    assert!(rising.len() > 100);
    for Crossing { step, part, time, point } in both {
        let before = &points[step as usize];
        let sign = before[0].signum();
        let (mut left, mut right) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = (left + right) / 2.0;
            let beyond = HenonHeiles.step(before, middle * eps)[0].signum() != sign;
            if beyond { right = middle } else { left = middle }
        }
        // Here x changes by at least 10⁻³ per step, and by about 10⁻¹⁷ through rounding.
        assert!((part - right).abs() < 1e-12, "{part} {right}");
        assert_eq!(point, HenonHeiles.step(before, part * eps));
        assert_eq!(time, 2.0 * eps * (step as f64 + part));
        assert!(point[0].abs() < 1e-16, "{point:?}");
    }
}

/// Along the orbit the flow's energy has an error O(ε²). The test compares the errors at the
/// crossings for ε and for ε/4.
#[test]
fn energy_on_the_section_has_the_order_of_the_map() {
    let energy = |x: [f64; 4]| {
        let [x, y, p, q] = x;
        (p * p + q * q + x * x + y * y) / 2.0 + x * x * y - y * y * y / 3.0
    };
    let spread = |eps: f64| {
        let found = crossings(eps, (400.0 / eps) as u64, Direction::Rising);
        found.iter().map(|crossing| (energy(crossing.point.into()) - energy(START)).abs()).fold(0.0, f64::max)
    };
    let order = (spread(0.08) / spread(0.02)).log(4.0);
    assert!((order - 2.0).abs() < 0.2, "{order}");
}

#[test]
fn a_callback_gets_every_crossing_and_a_full_store_counts_on() {
    let map = HenonHeiles.at(0.05);
    let (mut seen, all) = (Vec::new(), crossings(0.05, 5000, Direction::Both));
    let take = |crossing| seen.push(crossing);
    map.orbit(START.into()).observe(5000, Section::new(&map, |x: &[f64]| x[0], Direction::Both, take));
    assert_eq!(seen, all);
    let few = Section::new(&map, |x: &[f64]| x[0], Direction::Both, FirstCrossings::new(3));
    let few = map.orbit(START.into()).observe(5000, few).points;
    assert_eq!((few.all as usize, few.kept), (all.len(), all[..3].to_vec()));
}
