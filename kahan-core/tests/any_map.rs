//! Compares the trait `Step` with the methods of each type that implements it.

use kahan_core::observe::{
    Direction, Drift, Escape, Extrema, FirstCrossings, Observer, Section, TangentMap, first_crossing,
};
use kahan_core::prelude::*;
use kahan_core::{Compensated, Increments, Level, Orbit, Step, Tangent, Workspace};

use super::lattices::{Kdv, Ring, Shore, Toda};
use super::systems::{Burst, E6, Turn};

const EPS: f64 = 0.03;
const STEPS: u64 = 9;

/// Takes `STEPS` steps of `map` one by one, all at once, and with a used workspace.
fn advanced(map: &dyn Step<Scalar = f64>, start: &[f64], workspace: &mut Workspace) -> Vec<f64> {
    assert_eq!((map.dimension(), *map.eps()), (start.len(), EPS));
    let mut x = start.to_vec();
    assert_eq!(map.advance(&mut x, STEPS, workspace), Ok(()));
    let mut one_by_one = start.to_vec();
    for _ in 0..STEPS {
        one_by_one = Step::next(&map, &one_by_one, workspace).unwrap();
    }
    assert_eq!(x, one_by_one);
    let (mut whole, mut none) = (start.to_vec(), start.to_vec());
    map.part(&EPS, &mut whole, workspace).unwrap();
    assert_eq!(Some(whole), Step::next(&map, &start.to_vec(), workspace));
    map.part(&0.0, &mut none, workspace).unwrap();
    assert_eq!(none, start);
    x
}

fn wave(len: usize) -> Vec<f64> {
    (0..len).map(|k| 1.0 + 0.5 * (0.7 * k as f64).sin()).collect()
}

#[test]
fn every_map_has_the_bits_of_its_own_methods() {
    let mut workspace = Workspace::new();
    let start = [0.5, 1.0, 0.25];
    let plain = E6.at(EPS);
    let composed = plain.composed(Composition::KAHAN_LI_8);
    for _ in 0..2 {
        let expected = plain.orbit(start.into()).nth(STEPS as usize).unwrap();
        assert_eq!(advanced(&plain, &start, &mut workspace), expected.as_slice());
        let expected = composed.orbit(start.into()).nth(STEPS as usize).unwrap();
        assert_eq!(advanced(&composed, &start, &mut workspace), expected.as_slice());
        // The step of a chain of 700 sites is computed in parts, that of 3 sites as a whole.
        for sites in [3, 700] {
            let growth = |k: usize| vec![1.0 + 0.01 * k as f64; sites];
            chain(&Ring, sites, &mut workspace);
            chain(&Kdv { h: 0.5 }, sites, &mut workspace);
            chain(&Kdv { h: 0.75 }, sites, &mut workspace);
            chain(&Toda, sites, &mut workspace);
            chain(&Shore { mu: 0.1, r: growth(1) }, sites, &mut workspace);
            chain(&Shore { mu: 0.2, r: growth(2) }, sites, &mut workspace);
        }
    }
}

fn chain<M: LatticeMap<f64>>(map: &M, sites: usize, workspace: &mut Workspace) {
    let at = LatticeMap::at(map, EPS, sites).unwrap();
    let start = wave(sites * <M as LatticeMap<f64>>::BLOCK);
    let found = advanced(&at, &start, workspace);
    let own = || {
        let mut x = start.clone();
        // This is the chain's own method `advance`, although the trait `Step` is in scope.
        at.advance(&mut x, STEPS);
        x
    };
    assert_eq!(found, own());
    std::thread::scope(|scope| {
        for run in [scope.spawn(own), scope.spawn(own)] {
            assert_eq!(found, run.join().unwrap());
        }
    });
}

#[test]
fn modes_are_maps() {
    let (start, mut workspace) = (vector![0.5, 1.0, 0.25], Workspace::new());
    let plain = E6.at(EPS);
    let composed = plain.composed(Composition::KAHAN_LI_8);
    let mut carried = [0.5, 1.0, 0.25, 0.0, 0.0, 0.0];
    let points: Vec<_> = plain.orbit(start).compensated().take(10).collect();
    Compensated(plain).advance(&mut carried, STEPS, &mut workspace).unwrap();
    assert_eq!(&carried[..3], points[STEPS as usize].as_slice());
    assert!(carried[3..].iter().any(|lacks| *lacks != 0.0));
    let map = plain.compensated();
    assert_eq!(map.state(start.as_slice()), SMatrix::<f64, 3, 2>::from_columns(&[start, SVector::zeros()]));
    assert_eq!(Orbit::new(map, map.state(start.as_slice())).nth(9).unwrap(), points[9]);
    let chosen: Box<dyn Step<Scalar = f64>> = Box::new(map);
    let state = chosen.state(start.as_slice());
    assert_eq!(state, [0.5, 1.0, 0.25, 0.0, 0.0, 0.0]);
    assert_eq!(Orbit::new(chosen, state).nth(9).unwrap()[..3], *points[9].as_slice());
    // An orbit can continue bit for bit only from a state that includes the rounding errors.
    let last = Orbit::new(Compensated(plain), SMatrix::from_column_slice(&carried)).nth(1).unwrap();
    assert_eq!(last, plain.orbit(start).compensated().nth(STEPS as usize + 1).unwrap());
    let (mut part, mut alone) = (carried, [carried[0], carried[1], carried[2]]);
    Compensated(&plain).part(&0.01, &mut part, &mut workspace).unwrap();
    plain.part(&0.01, &mut alone, &mut workspace).unwrap();
    assert_eq!((&part[..3], &part[3..]), (&alone[..], &carried[3..]));

    let both = Compensated(composed);
    let any: &dyn Step<Scalar = f64> = &both;
    let mut orbit = Orbit::new(any, vec![0.5, 1.0, 0.25, 0.0, 0.0, 0.0]);
    let expected = composed.orbit(start).compensated().nth(STEPS as usize).unwrap();
    assert_eq!(orbit.nth(STEPS as usize).unwrap()[..3], *expected.as_slice());

    let vectors = [vector![1.0, -2.0, 0.5], vector![0.0, 1.0, 3.0]];
    let beside: Vec<f64> = [start, vectors[0], vectors[1]].iter().flatten().copied().collect();
    with_vectors(&plain, &beside);
    with_vectors(&composed, &beside);
    let (mut part, mut alone) = (beside.clone(), [0.5, 1.0, 0.25]);
    Tangent::new(&plain, 2).part(&0.01, &mut part, &mut workspace).unwrap();
    plain.part(&0.01, &mut alone, &mut workspace).unwrap();
    assert_eq!((&part[..3], &part[3..]), (&alone[..], &beside[3..]));

    let eps = 1.0 / 32.0;
    let through = ThroughF64::of_step(E6.at(eps));
    let single = start.map(|entry| entry as f32);
    let expected = ThroughF64(E6).orbit(single, eps as f32).nth(STEPS as usize).unwrap();
    let mut x = single.as_slice().to_vec();
    through.advance(&mut x, STEPS, &mut workspace).unwrap();
    assert_eq!((x.as_slice(), *through.eps()), (expected.as_slice(), eps as f32));
    let mut x = single.as_slice().to_vec();
    through.part(&(eps as f32 / 2.0), &mut x, &mut workspace).unwrap();
    assert_eq!(x, ThroughF64(E6).step(&single, eps as f32 / 2.0).as_slice());
}

/// Compares propagated tangent vectors with an orbit whose states contain the vectors.
fn with_vectors(map: &impl TangentMap<Scalar = f64, State = SVector<f64, 3>>, start: &[f64]) {
    let carried = Orbit::new(Tangent::new(map, 2), start.to_vec()).nth(STEPS as usize).unwrap();
    let columns = |numbers: &[f64]| SMatrix::<f64, 3, 3>::from_column_slice(numbers);
    let [mut x, mut v, mut w] = [0, 1, 2].map(|k| columns(start).column(k).into_owned());
    for _ in 0..STEPS {
        let next = map.next(&x, &mut Workspace::new()).unwrap();
        map.push_forward_to(x.as_slice(), next.as_slice(), &mut v);
        map.push_forward_to(x.as_slice(), next.as_slice(), &mut w);
        x = next;
    }
    assert_eq!(columns(&carried), SMatrix::<f64, 3, 3>::from_columns(&[x, v, w]));
}

#[test]
fn every_map_has_orbits() {
    let chain = LatticeMap::at(&Ring, EPS, 5).unwrap();
    let mut orbit = Orbit::new(&chain, wave(5));
    let most = orbit.observe(STEPS, Extrema::of(|x: &[f64]| x[2])).unwrap();
    let points: Vec<_> = Orbit::new(&chain, wave(5)).take(STEPS as usize + 2).collect();
    let seen = points[..=STEPS as usize].iter().map(|x| x[2]);
    assert_eq!(most.greatest, seen.fold(f64::NEG_INFINITY, f64::max));
    assert_eq!(orbit.next(), points.last().cloned());
    let half = Orbit::new(&chain, wave(5)).at_times(&[EPS]).next().unwrap();
    assert_eq!(
        half,
        Step::next(&LatticeMap::at(&Ring, EPS / 2.0, 5).unwrap(), &wave(5), &mut Workspace::new()).unwrap()
    );

    let plain = E6.at(EPS);
    let any: &dyn Step<Scalar = f64> = &plain;
    let start = [0.5, 1.0, 0.25];
    let mut orbits = (Orbit::new(any, start.to_vec()), plain.orbit(start.into()));
    let found = orbits.0.first_crossing(500, |x| x[2] - 0.2).unwrap();
    let expected = orbits.1.first_crossing(500, |x| x[2] - 0.2).unwrap();
    assert_eq!((found.time, found.point.as_slice()), (expected.time, expected.point.as_slice()));
    let carried = plain.orbit(start.into()).compensated().first_crossing(500, |x| x[2] - 0.2).unwrap();
    assert_eq!(carried.step, expected.step);
    assert!((carried.time - expected.time).abs() < 1e-13);
}

#[test]
#[should_panic(expected = "a state of 2 numbers for a map of 5")]
fn an_orbit_of_another_length_panics() {
    let _ = Orbit::new(&LatticeMap::at(&Ring, EPS, 5).unwrap(), vec![1.0; 2]);
}

#[test]
fn a_run_stops_at_a_pole_of_an_exact_scalar() {
    // The map has a pole at x = 1/ε.
    let [eps, start] = [(1, 8), (2, 1)].map(|(p, q): (i64, i64)| BigRational::new(p.into(), q.into()));
    let map = Burst.at(eps.clone());
    let mut x = [start.clone()];
    let stopped = map.run(&mut x, 9).unwrap_err();
    let points: Vec<_> = map.orbit([start].into()).collect();
    assert_eq!(stopped.steps as usize + 1, points.len());
    assert_eq!(x[0], points.last().unwrap()[0]);
    assert_eq!((stopped.why.determinant(), stopped.why.eps()), (0.0, 0.125));
    let mut at_the_pole = x.clone();
    assert!(map.run_part(&eps, &mut at_the_pole).is_err());
    assert_eq!(at_the_pole, x);
}

#[test]
#[should_panic(expected = "a state of 2 numbers for a map of 3")]
fn a_state_of_another_length_panics() {
    let _ = E6.at(EPS).run(&mut [0.5, 1.0], 1);
}

/// A step turns the point by 2 arctan ε. The start (1, 0) reaches x = 0 after a quarter turn.
#[test]
fn a_first_crossing_is_told_of_any_map() {
    let map = Turn.at(EPS);
    let crossing = first_crossing(&map, vector![1.0, 0.0], 1000, |x| x[0]).unwrap();
    let turn = 2.0 * EPS.atan();
    let steps = (std::f64::consts::FRAC_PI_2 / turn).floor();
    let part = ((std::f64::consts::FRAC_PI_2 - steps * turn) / 2.0).tan() / EPS;
    assert_eq!(crossing.step, steps as u64);
    assert!((crossing.part - part).abs() < 1e-12 && crossing.point[0].abs() < 1e-15);
    assert_eq!(crossing.time, 2.0 * EPS * (steps + crossing.part));
    let any: &dyn Step<Scalar = f64> = &map;
    let same = first_crossing(any, vec![1.0, 0.0], 1000, |x| x[0]).unwrap();
    assert_eq!(
        (same.step, same.time, &*same.point),
        (crossing.step, crossing.time, crossing.point.as_slice())
    );
    assert!(first_crossing(any, vec![1.0, 0.0], steps as u64, |x| x[0]).is_none());
}

struct Until(u64, Vec<u64>);

impl Observer<f64> for Until {
    type Report = Vec<u64>;

    fn observe(&mut self, step: u64, _x: &[f64]) {
        self.1.push(step);
    }

    fn is_done(&self) -> bool {
        self.1.len() as u64 == self.0
    }

    fn report(self) -> Vec<u64> {
        self.1
    }
}

#[test]
fn a_run_ends_with_the_first_observer_that_is_done() {
    let start = vector![0.5, 1.0, 0.25];
    let points: Vec<_> = E6.orbit(start, EPS).take(100).collect();
    for most in [1, 4] {
        let mut orbit = E6.orbit(start, EPS);
        let (seen, all) = orbit.observe(50, (Until(most, Vec::new()), Until(9, Vec::new())));
        assert_eq!((&seen, &all), (&(0..most).collect(), &(0..most).collect()));
        assert_eq!(orbit.next().unwrap(), points[most as usize]);
    }
    let reports = E6.orbit(start, EPS).observe(50, [Until(5, Vec::new()), Until(3, Vec::new())]);
    assert_eq!(reports.map(|seen| seen.len()), [3, 3]);
    let reports = E6.orbit(start, EPS).observe(50, vec![Until(2, Vec::new())]);
    assert_eq!(reports, [[0, 1]]);
}

/// Groups of 16 trajectories take 16 steps at a time. Their observers end at different times.
#[test]
fn in_an_ensemble_each_trajectory_is_seen_until_it_is_done() {
    let map = E6.at(EPS);
    let starts: Vec<SVector<f64, 3>> = (0..21).map(|k| vector![0.5, 1.0, 0.05 * f64::from(k)]).collect();
    let observers = |index: usize| {
        (
            Until(2 + 3 * index as u64, Vec::new()),
            Extrema::of(|x: &[f64]| x[0]),
            Drift::of(|x: &[f64]| [x[1]]),
        )
    };
    let mut ensemble = Ensemble::new(starts.clone()).at_level(Level::Baseline).unwrap();
    let reports = ensemble.observe(&map, 40, observers);
    for (index, (start, report)) in starts.iter().zip(reports).enumerate() {
        assert_eq!(report, map.orbit(*start).observe(40, observers(index)));
        assert_eq!(report.0.len(), (2 + 3 * index).min(41));
        assert_eq!(ensemble.point(index).unwrap(), map.orbit(*start).nth(40).unwrap());
    }
}

#[test]
fn escapes_and_crossings_can_end_a_run() {
    let map = E6.at(EPS);
    let start = vector![0.5, 1.0, 0.25];
    let condition = |x: &[f64]| x[0] < 0.0;
    let first = map.orbit(start).observe(1000, Escape::when(condition)).unwrap();
    let mut orbit = map.orbit(start);
    let (ended, extremes) =
        orbit.observe(1000, (Escape::when(condition).ending(), Extrema::of(|x: &[f64]| x[0])));
    assert_eq!(ended, Some(first));
    assert_eq!(extremes, map.orbit(start).observe(first, Extrema::of(|x: &[f64]| x[0])));
    let crossings = |sink| Section::new(&map, |x: &[f64]| x[0], Direction::Both, sink);
    let found = map.orbit(start).observe(1000, crossings(FirstCrossings::new(2))).points;
    let mut orbit = map.orbit(start);
    let section = Section::new(&map, |x: &[f64]| x[0], Direction::Both, FirstCrossings::new(2).ending());
    let ended = orbit.observe(1000, section).points;
    assert!(found.all > 2 && ended.all == 2 && ended.kept == found.kept);
    assert_eq!(orbit.next(), map.orbit(start).nth(ended.kept[1].step as usize + 2));
}

#[test]
fn orbits_are_told_by_time() {
    let eps = 0.125_f64;
    let start = vector![0.6, 0.8];
    let points: Vec<_> = Turn.orbit(start, eps).take(9).collect();
    let half = |k: usize| Turn.step(&points[k], eps / 2.0);
    let times = [0.0, 0.125, 0.25, 1.0, 1.0, 1.125, 1.875];
    let expected = [points[0], half(0), points[1], points[4], points[4], half(4), half(7)];
    assert!(Turn.orbit(start, eps).at_times(&times).eq(expected));
    // Times count from the orbit's current point, and backwards if ε is negative.
    let mut orbit = Turn.orbit(start, eps);
    orbit.nth(2);
    assert!(orbit.at_times(&[0.25, 0.375]).eq([points[4], half(4)]));
    let back: Vec<_> = Turn.orbit(start, -eps).at_times(&[-0.25, -0.375]).collect();
    assert_eq!(back[1], Turn.step(&Turn.step(&start, -eps), -eps / 2.0));
    let back: Vec<_> = Turn.orbit(start, eps).at_times(&[0.5, 0.25]).collect();
    assert_eq!(back[1], Turn.step(&points[2], -eps));

    let timed = |end: f64| Turn.orbit(start, eps).until(end).collect::<Vec<_>>();
    assert_eq!(timed(0.5), [(0.0, points[0]), (0.25, points[1]), (0.5, points[2])]);
    assert_eq!(timed(0.375), [(0.0, points[0]), (0.25, points[1]), (0.375, half(1))]);
    assert_eq!(timed(0.0), [(0.0, points[0])]);
    let composed = Turn.orbit(start, eps).composed(Composition::KAHAN_LI_8).compensated();
    let last = composed.until(1.9).last().unwrap().1;
    let turn = |part: f64| -> f64 {
        let stages = Composition::KAHAN_LI_8.coefficients().map(f64::constant);
        stages.map(|stage| 2.0 * (stage * part * eps).atan()).sum()
    };
    let angle = 0.6_f64.atan2(0.8) + 7.0 * turn(1.0) + turn(1.9 / (2.0 * eps) - 7.0);
    // The composed steps have about a hundred stages. Each makes an error of one or two units 2⁻⁵³.
    assert!((last[0] - angle.sin()).abs() < 2e-14, "{last}");

    let mut orbit = Turn.orbit(start, eps);
    let crossing = orbit.first_crossing(100, |x| x[1]).unwrap();
    let same = first_crossing(&Turn.at(eps), start, 100, |x| x[1]).unwrap();
    assert_eq!((crossing.time, crossing.point), (same.time, same.point));
    assert_eq!(orbit.next().unwrap(), points[crossing.step as usize + 2]);
}
