//! Compares columns with ensembles; each trajectory has its own ε and parameters.

use std::ops::ControlFlow;

use kahan_algebra::rational::Rational;
use kahan_core::prelude::*;
use kahan_core::{Composition, Ensemble, EnsembleScalar, ExtendScalars, Level};
use kahan_runtime::{End, Field, Follow, MachineFloat, Map, MapAt};
use kahan_systems::{E1, E3, E6, E9, LotkaVolterra};

use super::support::{Random, assert_same, catalog, number, steps};

const COUNTS: [usize; 6] = [0, 1, 7, 16, 37, 523];

fn columns<T: MachineFloat>(n: usize, count: usize) -> Vec<Vec<T>> {
    let mut random = Random(5);
    (0..n).map(|_| random.point(count)).collect()
}

fn advance<T: MachineFloat>(
    at: &MapAt<T>,
    each: &[T],
    composition: Composition,
    parameters: &[&[T]],
    columns: &mut [Vec<T>],
) {
    let mut slices: Vec<&mut [T]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
    at.composed(composition).advance_columns(&mut slices, each, parameters, 5).unwrap();
}

fn levels<T: MachineFloat>(map: &Map, eps: T) -> impl Iterator<Item = (Level, MapAt<T>)> {
    let at = map.at(eps);
    [Level::Baseline, Level::Avx2, Level::Avx512, Level::Neon].into_iter().filter_map(move |level| {
        let at = at.at_level(level);
        if at.is_none() {
            println!("not run: no code at {level:?}");
        }
        at.map(|at| (level, at))
    })
}

fn ensembles_agree<M, T, const N: usize>(name: &str, compiled: &M, map: &Map)
where
    M: ExtendScalars<T, N, Prepared: Sync> + Sync,
    T: MachineFloat + EnsembleScalar,
{
    for (count, eps) in
        COUNTS.into_iter().flat_map(|count| steps::<T>().into_iter().map(move |eps| (count, eps)))
    {
        for composition in [Composition::KAHAN, Composition::KAHAN_LI_6] {
            let start = columns::<T>(N, count);
            let points: Vec<_> = (0..count).map(|i| SVector::<T, N>::from_fn(|c, _| start[c][i])).collect();
            for (level, at) in levels(map, eps) {
                let ensemble = Ensemble::new(points.clone()).at_level(level);
                let mut ensemble = ensemble.expect("there is code of that level");
                if composition == Composition::KAHAN {
                    ensemble.advance(&compiled.at(eps), 5);
                } else {
                    ensemble.advance(&compiled.at(eps).composed(composition), 5);
                }
                let mut ours = start.clone();
                advance(&at, &[], composition, &[], &mut ours);
                for (c, column) in ours.iter().enumerate() {
                    assert_same(column, ensemble.column(c), (name, count, eps, composition, level));
                }
            }
        }
    }
}

#[test]
fn columns_are_ensembles_at_every_level() {
    let [lv, e3, e6] = ["lv", "e3", "e6"].map(|name| catalog(name).map().expect("no parameters"));
    let e9 = catalog("e9").with([("xi", 0.75)]).expect("one parameter");
    ensembles_agree::<_, f64, 2>("lv", &LotkaVolterra, &lv);
    ensembles_agree::<_, f32, 2>("lv", &LotkaVolterra, &lv);
    ensembles_agree::<_, f64, 3>("e3", &E3, &e3);
    ensembles_agree::<_, f64, 3>("e6", &E6, &e6);
    ensembles_agree::<_, f32, 3>("e6", &E6, &e6);
    ensembles_agree::<_, f64, 3>("e9", &E9 { xi: 0.75 }, &e9);
    ensembles_agree::<_, f32, 3>("e9", &E9 { xi: 0.75 }, &e9);
}

fn trajectories_are_their_own<T: MachineFloat>(text: &str) {
    let field = Field::parse(text).expect("a field");
    let (n, count) = (field.variables().len(), 21);
    let mut random = Random(17);
    let [a, b] = [0; 2].map(|_| random.point::<T>(count));
    let each: Vec<T> = (0..count).map(|i| steps::<T>()[i % steps::<T>().len()]).collect();
    let start = columns::<T>(n, count);
    let map = field.with([("a", 1), ("b", 2)]).expect("two parameters");
    for composition in [Composition::KAHAN, Composition::SUZUKI_4] {
        for (level, at) in levels(&map, number(0.5)) {
            let mut together = start.clone();
            advance(&at, &each, composition, &[&a, &b], &mut together);
            for i in 0..count {
                let exact = |value: &T| Rational::from_f64(value.approximate()).expect("finite");
                let own = field.with([("a", exact(&a[i])), ("b", exact(&b[i]))]).expect("no zero divides");
                let own = own.at(each[i]).at_level(level).expect("the same step has code");
                let mut alone: Vec<Vec<T>> = start.iter().map(|column| vec![column[i]]).collect();
                advance(&own, &[], composition, &[], &mut alone);
                let pairs = (0..n).map(|c| (together[c][i], alone[c][0]));
                let (found, expected): (Vec<T>, Vec<T>) = pairs.unzip();
                assert_same(&found, &expected, (text, i, composition, level));
            }
        }
    }
}

#[test]
fn a_trajectory_has_the_bits_of_its_own_eps_and_parameters() {
    for text in ["xdot = a*x*y + b; ydot = b*y^2 - x;", "udot = a*u^2 + b;", &super::large::dense(9)] {
        trajectories_are_their_own::<f64>(text);
        trajectories_are_their_own::<f32>(text);
    }
}

/// Compares steps of a million points, some with coordinates that are 0, subnormal, huge or NaN.
#[test]
#[ignore = "a million points at every level"]
fn a_million_points_agree_at_every_level() {
    fn check<M, T, const N: usize>(name: &str, compiled: &M, map: &Map)
    where
        M: ExtendScalars<T, N, Prepared: Sync> + Sync,
        T: MachineFloat + EnsembleScalar,
    {
        const COUNT: usize = 1_000_003;

        let mut random = Random(99);
        let mut entry = || match random.below(64) {
            0 => T::zero(),
            1 => -T::zero(),
            2 => T::one() / T::zero(),
            3 => T::zero() / T::zero(),
            4 => number(f64::from(random.below(1000)) * 1e-39),
            5 => number(f64::from(random.below(1000)) * 1e34),
            _ => number::<T>(f64::from(random.below(1 << 22)) - 2_097_152.0) / number(786_432.0),
        };
        let start: Vec<Vec<T>> = (0..N).map(|_| (0..COUNT).map(|_| entry()).collect()).collect();
        let points: Vec<_> = (0..COUNT).map(|i| SVector::<T, N>::from_fn(|c, _| start[c][i])).collect();
        let eps = number::<T>(0.07);
        for (level, at) in levels(map, eps) {
            let mut ensemble = Ensemble::new(points.clone()).at_level(level).expect("there is code");
            ensemble.advance(&compiled.at(eps), 3);
            let mut ours = start.clone();
            let mut slices: Vec<&mut [T]> = ours.iter_mut().map(Vec::as_mut_slice).collect();
            at.advance_columns(&mut slices, &[], &[], 3).unwrap();
            for (c, column) in ours.iter().enumerate() {
                assert_same(column, ensemble.column(c), (name, level));
            }
            println!("{name} at {level:?}: {COUNT} points of {N} numbers in {} bytes", size_of::<T>());
        }
    }
    let [lv, e1, e3, e6] = ["lv", "e1", "e3", "e6"].map(|name| catalog(name).map().expect("no parameters"));
    let e9 = catalog("e9").with([("xi", 0.75)]).expect("one parameter");
    check::<_, f64, 2>("lv", &LotkaVolterra, &lv);
    check::<_, f32, 2>("lv", &LotkaVolterra, &lv);
    check::<_, f64, 3>("e1", &E1, &e1);
    check::<_, f32, 3>("e1", &E1, &e1);
    check::<_, f64, 3>("e3", &E3, &e3);
    check::<_, f32, 3>("e3", &E3, &e3);
    check::<_, f64, 3>("e6", &E6, &e6);
    check::<_, f32, 3>("e6", &E6, &e6);
    check::<_, f64, 3>("e9", &E9 { xi: 0.75 }, &e9);
    check::<_, f32, 3>("e9", &E9 { xi: 0.75 }, &e9);
}

#[test]
fn a_trajectory_whose_field_divides_by_zero_is_no_number() {
    let field = Field::parse("xdot = x*y/(a - b); ydot = -x;").expect("a field");
    let map = field.with([("a", 2.0), ("b", 1.5)]).expect("its parameters");
    for trajectories in [3, 40] {
        let a: Vec<f64> = (0..trajectories).map(|k| 1.5 + f64::from(k % 3)).collect();
        let (mut x, mut y) = (vec![1.0; a.len()], vec![0.5; a.len()]);
        map.at(0.1)
            .advance_columns(&mut [&mut x, &mut y], &[], &[&a, &[1.5]], 1)
            .expect("columns of one length");
        for (k, a) in a.iter().enumerate() {
            assert_eq!((x[k].is_nan(), y[k].is_nan()), (*a == 1.5, *a == 1.5), "{k}");
        }
    }
}

#[test]
fn a_trajectory_of_columns_ends_where_it_ends_alone_with_the_same_bits() {
    const STEPS: u64 = 3000;
    let fields = ["xdot = a*x; ydot = x - y;", "xdot = a*x^2; ydot = x*y;", "xdot = y; ydot = a*x^2 - x;"];
    for (text, tiny) in fields.into_iter().flat_map(|text| [(text, 0.05), (text, 1e-310)]) {
        let field = Field::parse(text).expect("a field");
        let map = field.with([("a", 1)]).expect("its parameter").at(0.1);
        for (trajectories, composition) in
            [(1, Composition::KAHAN), (37, Composition::SUZUKI_4), (1031, Composition::KAHAN)]
        {
            let map = map.composed(composition);
            let eps: Vec<f64> = (0..trajectories).map(|k| 0.1 + 0.01 * f64::from(k % 37)).collect();
            let eps: Vec<f64> = eps.iter().map(|eps| if *eps == 0.13 { tiny } else { *eps }).collect();
            let rates: Vec<f64> = (0..trajectories).map(|k| 1.0 + 0.25 * f64::from(k % 5)).collect();
            let mut start = columns::<f64>(2, eps.len());
            start[1][0] = if trajectories > 1 { f64::NAN } else { start[1][0] };
            let mut ours = start.clone();
            let mut slices: Vec<&mut [f64]> = ours.iter_mut().map(Vec::as_mut_slice).collect();
            let ends =
                map.follow_columns(&mut slices, &eps, &[&rates], STEPS).expect("columns of one length");
            let maps = map.each(&eps, &[&rates]).expect("a map for each");
            for (k, end) in ends.iter().enumerate() {
                let mut alone: Vec<f64> = start.iter().map(|column| column[k]).collect();
                let go_on = |_| ControlFlow::Continue(());
                let followed = maps[k].follow(&mut alone, STEPS, go_on).expect("a state that fits");
                assert_eq!(*end, followed.end, "{text} {k}");
                let ours: Vec<f64> = ours.iter().map(|column| column[k]).collect();
                if *end == End::Complete {
                    assert_same(&ours, &alone, k);
                } else {
                    assert!(ours.iter().all(|x| x.is_nan()), "{text} {k}: {ours:?}");
                }
            }
        }
    }
}

#[test]
fn each_trajectory_has_a_map_of_its_own() {
    let field = Field::parse("xdot = x*y/(a - b); ydot = -x;").expect("a field");
    let map = field.with([("a", 2.0), ("b", 1.5)]).expect("its parameters").at(0.1);
    let values = |maps: Result<Vec<MapAt<f64>>, _>| -> Vec<(Vec<f64>, f64)> {
        let maps: Vec<MapAt<f64>> = maps.expect("values that fit");
        let parameters = |map: &MapAt<f64>| map.map().parameters().iter().map(Rational::to_f64).collect();
        maps.iter().map(|map| (parameters(map), map.eps())).collect()
    };
    assert_eq!(values(map.each(&[], &[])), [(vec![2.0, 1.5], 0.1)]);
    assert_eq!(values(map.each(&[0.5], &[&[3.0], &[0.1]])), [(vec![3.0, 0.1], 0.5)]);
    let both = [(vec![3.0, 0.25], 0.1), (vec![4.0, 0.25], 0.2)];
    assert_eq!(values(map.each(&[0.1, 0.2], &[&[3.0, 4.0], &[0.25]])), both);
    assert!(values(map.each(&[], &[&[], &[0.25]])).is_empty());
    let refused = map.each(&[0.1; 3], &[&[1.0, 2.0], &[0.5]]).expect_err("they do not fit");
    assert_eq!(refused.to_string(), "eps has 3 entries; give none, one, or 2, one a trajectory");

    for composition in [Composition::KAHAN, Composition::KAHAN_LI_6] {
        let values: [&[f64]; 2] = [&[1.5, 3.0, f64::NAN], &[1.5]];
        let points = map.composed(composition).each(&[], &values).expect("they fit").into_iter().map(|own| {
            let mut x = [1.0, 0.5];
            own.advance(&mut x, 1).expect("two variables");
            x
        });
        let points: Vec<[f64; 2]> = points.collect();
        let other = field.with([("a", 3.0), ("b", 1.5)]).expect("its parameters").at(0.1);
        let mut x = [1.0, 0.5];
        other.composed(composition).advance(&mut x, 1).expect("two variables");
        assert_eq!(points[1], x);
        assert!(points[0].iter().chain(&points[2]).all(|x| x.is_nan()), "{points:?}");
    }
}
