//! Tests sign changes at zeros and at jumps: poles of maps, and poles and gaps of functions.

use kahan_core::observe::{
    Crossing, Direction, FirstCrossings, Observer, Section, SectionReport, StoredCrossings, first_crossing,
};
use kahan_core::prelude::*;
use kahan_core::{Dd, FloatScalar, LatticeMap, Orbit, PointOf, Step};

use super::HenonHeiles;
use crate::lattices::Ring;
use crate::systems::{Burst, Turn};

kahan! {
    /// The variable x is the tangent of an angle that grows by arctan 2ε in each step.
    pub(crate) struct Tangent;
    xdot = x^2 + 1;
    ydot = 1;
}

kahan! {
    /// A point that moves along a line.
    pub(crate) struct Straight;
    xdot = 1;
}

const START: [f64; 4] = [0.0, 0.1, 0.45, 0.1];

type Found<S> = SectionReport<StoredCrossings<Crossing<PointOf<S>, <S as Step>::Scalar>>>;

fn section<S: Step<Scalar = T>, T: FloatScalar>(
    map: &S,
    start: S::State,
    steps: u64,
    direction: Direction,
    level: impl Fn(&[T]) -> T,
) -> Found<S> {
    let section = Section::new(map, level, direction, FirstCrossings::new(10_000));
    let found = Orbit::new(map, start).observe(steps, section);
    assert_eq!(found.points.all as usize, found.points.kept.len());
    found
}

/// Counts how often a function rises and falls through 0 between successive points of an orbit.
fn sign_changes<S: Step<Scalar = T>, T: FloatScalar>(
    map: &S,
    start: S::State,
    steps: usize,
    level: impl Fn(&[T]) -> T,
) -> [u64; 2] {
    use kahan_core::StateVector;

    let heights: Vec<f64> =
        Orbit::new(map, start).take(steps + 1).map(|x| level(x.as_slice()).approximate()).collect();
    let count = |changes: fn(f64, f64) -> bool| {
        heights.windows(2).filter(|pair| changes(pair[0], pair[1])).count() as u64
    };
    [count(|before, after| before < 0.0 && after >= 0.0), count(|before, after| before > 0.0 && after <= 0.0)]
}

/// Checks that sign changes in one direction are crossings, and those in the other are jumps.
fn falls_through_infinity<S: Step<Scalar = T>, T: FloatScalar>(map: &S, start: S::State, is_mirrored: bool) {
    let [rising, falling] = sign_changes(map, start.clone(), 200, |x| x[0]);
    assert!(rising > 5 && falling > 5);
    let [(through, zeros), (beyond, poles)] = if is_mirrored {
        [(Direction::Falling, falling), (Direction::Rising, rising)]
    } else {
        [(Direction::Rising, rising), (Direction::Falling, falling)]
    };
    let found = section(map, start.clone(), 200, through, |x| x[0]);
    assert_eq!((found.points.all, found.jumps), (zeros, 0));
    let found = section(map, start.clone(), 200, beyond, |x| x[0]);
    assert_eq!((found.points.all, found.jumps), (0, poles));
    let found = section(map, start.clone(), 200, Direction::Both, |x| x[0]);
    assert_eq!((found.points.all, found.jumps), (zeros, poles));
    // The function 1/x is 0 only where x is infinite, which is not a crossing.
    let found = section(map, start, 200, Direction::Both, |x| T::one() / x[0]);
    assert_eq!((found.points.all, found.jumps), (0, zeros + poles));
}

#[test]
fn an_orbit_that_goes_through_infinity_does_not_cross() {
    for eps in [0.05, 0.2, -0.05, 0.31] {
        falls_through_infinity(&Tangent.at(eps), vector![0.1, 0.0], eps < 0.0);
        falls_through_infinity(&Tangent.at(eps as f32), vector![0.1, 0.0], eps < 0.0);
        falls_through_infinity(&Tangent.at(Dd::from(eps)), vector![Dd::from(0.1), Dd::from(0.0)], eps < 0.0);
        let compositions = [
            Composition::TRIPLE_JUMP,
            Composition::SUZUKI_4,
            Composition::KAHAN_LI_6,
            Composition::KAHAN_LI_8,
        ];
        for composition in compositions {
            falls_through_infinity(&Tangent.at(eps).composed(composition), vector![0.1, 0.0], eps < 0.0);
        }
        let any: &dyn Step<Scalar = f64> = &Tangent.at(eps);
        falls_through_infinity(&any, vec![0.1, 0.0], eps < 0.0);
    }
}

#[test]
fn poles_steps_and_holes_of_a_function_are_jumps() {
    let inverse = |x: f64| 1.0 / x;
    let functions: [fn(f64) -> f64; 7] = [
        inverse,
        |x| 1.0 / (x * x * x),
        |x| x / x.abs(),
        |x| if x < 0.0 { -1e-3 } else { 1.9 },
        |x| (1.0 / x).exp() - 1.0,
        |x| (1.0 / x).atan(),
        |x| if x.abs() < 1e-3 { f64::NAN } else { x },
    ];
    for eps in [0.05, -0.05] {
        let map = HenonHeiles.at(eps);
        for (k, function) in functions.into_iter().enumerate() {
            let level = |x: &[f64]| function(x[0] - 0.05);
            let [rising, falling] = sign_changes(&map, START.into(), 4000, level);
            assert!(rising > 20 && falling > 20, "{k}");
            for (direction, expected) in [
                (Direction::Rising, rising),
                (Direction::Falling, falling),
                (Direction::Both, rising + falling),
            ] {
                let found = section(&map, START.into(), 4000, direction, level);
                assert_eq!((found.points.all, found.jumps), (0, expected), "{k} {direction:?}");
            }
            assert_eq!(first_crossing(&map, START.into(), 4000, level), None);
        }
    }
}

/// A crossing is found where the function is undefined but has the limit 0.
#[test]
fn a_function_without_a_value_at_its_zero_crosses_there() {
    let found =
        section(&Straight.at(0.25), vector![-1.0], 4, Direction::Both, |x: &[f64]| x[0] * x[0] / x[0]);
    assert_eq!((found.points.all, found.jumps), (0, 0));
    let found =
        section(&Straight.at(0.25), vector![-0.75], 4, Direction::Both, |x: &[f64]| x[0] * x[0] / x[0]);
    assert_eq!((found.points.all, found.jumps), (1, 0));
    assert!(found.points.kept[0].point[0].abs() < 1e-15);
}

#[test]
fn a_zero_is_found_from_an_infinite_value() {
    let level = |x: &[f64]| (1000.0 * x[0]).exp() - 1.0;
    let found = section(&Straight.at(0.5), vector![-0.25], 3, Direction::Rising, level);
    assert_eq!((found.points.all, found.jumps), (1, 0));
    assert!(found.points.kept[0].point[0].abs() < 1e-15);
}

#[test]
fn values_that_are_no_numbers_are_no_sign_change() {
    let level = |x: &[f64]| if x[0].abs() < 0.1 { f64::NAN } else { x[0] };
    let found = section(&Straight.at(0.025), vector![-1.0], 100, Direction::Both, level);
    assert_eq!((found.points.all, found.jumps), (0, 0));
}

#[test]
fn a_start_on_the_section_is_neither_a_crossing_nor_a_jump() {
    for direction in [Direction::Rising, Direction::Falling, Direction::Both] {
        for eps in [0.01, -0.01] {
            let found = section(&Turn.at(eps), vector![0.0, 1.0], 100, direction, |x: &[f64]| x[0]);
            assert_eq!((found.points.all, found.jumps), (0, 0));
        }
    }
    let found = section(&Straight.at(0.5), vector![0.0], 9, Direction::Both, |x: &[f64]| 1.0 / x[0]);
    assert_eq!((found.points.all, found.jumps), (0, 0));
    // A step ends at the pole of the function.
    let found = section(&Straight.at(0.5), vector![-2.0], 9, Direction::Both, |x: &[f64]| 1.0 / x[0]);
    assert_eq!((found.points.all, found.jumps), (0, 1));
}

/// The circle touches the line x = 1 from inside. In each revolution, a line x = c < 1 is crossed
/// twice if a point of the orbit has x > c.
#[test]
fn touching_is_no_crossing_and_cutting_a_little_is_two() {
    for eps in [0.02, -0.02, 1e-4] {
        let (map, start) = (Turn.at(eps), vector![0.6, 0.8]);
        let touching = section(&map, start, 40_000, Direction::Both, |x: &[f64]| (x[0] - 0.5).powi(2));
        assert_eq!((touching.points.all, touching.jumps), (0, 0));
        for depth in [1e-4, 1e-6, 1e-8, 1e-10] {
            let level = |x: &[f64]| x[0] - (1.0 - depth);
            let [rising, falling] = sign_changes(&map, start, 40_000, level);
            let found = section(&map, start, 40_000, Direction::Both, level);
            assert_eq!((found.points.all, found.jumps), (rising + falling, 0), "{eps} {depth}");
            assert!(found.points.kept.iter().all(|crossing| level(crossing.point.as_slice()).abs() < 1e-15));
        }
    }
}

/// Even if a step moves the point by only 2·10⁻⁹, a zero must count as a crossing, not as a jump.
#[test]
fn crossings_of_slow_orbits_are_found() {
    for eps in [1e-3_f64, 1e-6, 1e-9] {
        let start = vector![(-3.5 * eps).sin(), (3.5 * eps).cos()];
        let found = section(&Turn.at(eps), start, 10, Direction::Both, |x: &[f64]| x[0] + x[1] - 1.0);
        assert_eq!((found.points.all, found.jumps), (1, 0), "{eps}");
    }
    let start = vector![-3.5e-2_f32, 100.0];
    let found = section(&Turn.at(1e-4), start, 10, Direction::Both, |x: &[f32]| x[0] + x[1] - 100.0);
    assert_eq!((found.points.all, found.jumps), (1, 0));
}

#[test]
fn units_do_not_matter() {
    let map = Tangent.at(0.05);
    let level = |x: &[f64]| x[0];
    let expected = section(&map, vector![0.1, 0.0], 300, Direction::Both, level);
    for exponent in [-900, -60, 60, 900] {
        let unit = f64::from(2).powi(exponent);
        let found = section(&map, vector![0.1, 0.0], 300, Direction::Both, |x: &[f64]| unit * x[0]);
        assert_eq!(found, expected);
    }
}

#[test]
fn chains_cross_and_jump() {
    for sites in [3, 700] {
        let map = Ring.at(0.03, sites).unwrap();
        let start: Vec<f64> = (0..sites).map(|k| 1.0 + 0.5 * (0.7 * k as f64).sin()).collect();
        let level = |x: &[f64]| x[1] - 1.1;
        let [rising, falling] = sign_changes(&map, start.clone(), 300, level);
        assert!(rising + falling > 1);
        let found = section(&map, start.clone(), 300, Direction::Both, level);
        assert_eq!((found.points.all, found.jumps), (rising + falling, 0));
        assert!(found.points.kept.iter().all(|crossing| level(&crossing.point).abs() < 1e-15));
        let found = section(&map, start, 300, Direction::Both, |x| 1.0 / level(x));
        assert_eq!((found.points.all, found.jumps), (0, rising + falling));
    }
}

#[test]
fn checked_steps_cross_and_jump_as_others_do() {
    let map = Tangent.at(0.05);
    let observed = |direction| {
        let mut section = Section::new(&map, |x: &[f64]| x[0], direction, FirstCrossings::new(100));
        let mut x = vector![0.1, 0.0];
        for step in 0..300 {
            section.observe(step, x.as_slice());
            x = Tangent.try_step(&x, 0.05).unwrap();
        }
        Observer::<f64>::report(section)
    };
    let rising = observed(Direction::Rising);
    let falling = observed(Direction::Falling);
    assert_eq!((rising.points.all, rising.jumps), (9, 0));
    assert_eq!((falling.points.all, falling.jumps), (0, 10));
    assert!(rising.points.kept.iter().all(|crossing| crossing.point[0].abs() < 1e-15));
}

#[test]
fn projective_orbits_jump_at_infinity() {
    let map = Tangent.at(0.05);
    let section = |direction| Section::new(&map, |x: &[f64]| x[0], direction, FirstCrossings::new(100));
    for (direction, expected) in [(Direction::Rising, (9, 0)), (Direction::Falling, (0, 10))] {
        let found = Tangent.orbit(vector![0.1, 0.0], 0.05).projective().observe(299, section(direction));
        assert_eq!((found.points.all, found.jumps), expected);
    }
    // The steps before and after infinity are not consecutive; therefore the sign change is a jump.
    let map = Burst.at(0.25);
    let both = Section::new(&map, |x: &[f64]| x[0], Direction::Both, FirstCrossings::new(9));
    let found = Burst.orbit(vector![1.0], 0.25).projective().observe(4, both);
    assert_eq!((found.points.all, found.jumps), (0, 1));
}
