//! Points and reports of orbits in groups equal those of single orbits, bit for bit.

use std::fmt::Debug;
use std::ops::ControlFlow;

use kahan_core::observe::{Escape, Extrema, Fli, Lyapunov, Megno, Observer, Sali};
use kahan_core::{Composition, Level};
use kahan_runtime::{Field, Follow, MachineFloat, MapAt, WhileFinite};

use super::support::{FIELDS, STEPS, columns, maps};

const COUNTS: [usize; 5] = [0, 1, 15, 16, 37];
fn observers<'a, T: MachineFloat + PartialOrd>(
    map: &'a MapAt<T>,
) -> impl Observer<T, Report: Debug> + use<'a, T> {
    (
        (Fli::new(map), Sali::new(map)),
        (Megno::new(map), Lyapunov::new(map)),
        Extrema::of(|x: &[T]| x[0]),
        Escape::when(|x: &[T]| x[0].approximate().abs() > 3.0),
    )
}

/// Follows one orbit; returns its last point and its reports as text that shows every bit.
fn alone<T: MachineFloat + PartialOrd>(map: &MapAt<T>, start: &[T]) -> String {
    let mut x = start.to_vec();
    let mut observers = observers(map);
    observers.observe(0, &x);
    for step in 1..=STEPS {
        map.advance(&mut x, 1).expect("a number a variable");
        observers.observe(step, &x);
    }
    format!("{x:?} {:?}", observers.report())
}

/// Returns last points and reports of many orbits, observed in groups.
fn side_by_side<T: MachineFloat + PartialOrd>(maps: &[&MapAt<T>], columns: &mut [Vec<T>]) -> Vec<String> {
    let mut slices: Vec<&mut [T]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
    let of = |orbit: usize| observers(maps[orbit.min(maps.len() - 1)]);
    let reports = MapAt::observe_columns(maps, &mut slices, STEPS, of).expect("columns that fit");
    let point = |orbit: usize| columns.iter().map(|column| column[orbit]).collect::<Vec<_>>();
    reports.iter().enumerate().map(|(orbit, report)| format!("{:?} {report:?}", point(orbit))).collect()
}

fn agree<T: MachineFloat + PartialOrd>(maps: &[&MapAt<T>], orbits: usize, what: &dyn Debug) {
    let variables = maps[0].map().field().variables().len();
    let start = columns::<T>(variables, orbits);
    let mut ours = start.clone();
    for (orbit, ours) in side_by_side(maps, &mut ours).into_iter().enumerate() {
        let point: Vec<T> = start.iter().map(|column| column[orbit]).collect();
        assert_eq!(ours, alone(maps[orbit.min(maps.len() - 1)], &point), "{what:?}: orbit {orbit}");
    }
}

#[test]
fn orbits_of_one_map_are_those_that_each_is_alone() {
    for (field, map) in maps() {
        for composition in [Composition::KAHAN, Composition::SUZUKI_4] {
            // Steps of many variables are slow, so fewer orbits are compared.
            for orbits in if field.variables().len() > 4 { &[3][..] } else { &COUNTS } {
                let orbits = *orbits;
                let what = (field.variables(), composition, orbits);
                agree(&[&map.at(0.05_f64).composed(composition)], orbits, &what);
                agree(&[&map.at(0.05_f32).composed(composition)], orbits, &what);
            }
        }
    }
}

/// A step stretches vectors by 2⁴¹. Without scaling, their squares would overflow after thirteen
/// steps.
#[test]
fn vectors_are_scaled_before_they_leave_the_numbers() {
    let field = Field::parse("xdot = x; ydot = y/2;").expect("a field");
    let map = field.map().expect("no parameters").at(1.0 - 1.0 / (1_u64 << 40) as f64);
    let mut columns = [[0.0; 3]; 2];
    let mut slices = columns.each_mut().map(|column| &mut column[..]);
    let reports = MapAt::observe_columns(&[&map], &mut slices, STEPS, |_| Fli::new(&map));
    let along_x = STEPS as f64 * 41.0 * std::f64::consts::LN_2;
    for indicator in reports.expect("columns that fit") {
        assert!(along_x - 2.0 < indicator && indicator < along_x, "{indicator} and {along_x}");
    }
}

#[test]
fn long_steps_scale_vectors_where_each_is_scaled_alone() {
    for (field, map) in maps() {
        for eps in [0.4, 2.5] {
            agree(&[&map.at(eps)], 19, &(field.variables(), eps));
        }
    }
}

#[test]
fn every_level_has_its_own_bits_side_by_side() {
    let (_, map) = maps().nth(3).expect("four variables");
    for level in [Level::Baseline, Level::Avx2, Level::Avx512, Level::Neon] {
        let Some(at) = map.at(0.05).at_level(level) else {
            println!("not run: no code at {level:?}");
            continue;
        };
        agree(&[&at], 20, &level);
    }
}

/// If ε is 0, or 1/ε is not finite, the step does not divide by ε.
#[test]
fn orbits_of_their_own_maps_are_those_that_each_is_alone() {
    for (text, parameters) in FIELDS {
        let field = Field::parse(text).expect("a field");
        let eps = |orbit: usize| match orbit {
            20 => 0.0,
            33 => 1e-310,
            _ => 0.01 * (orbit % 7 + 1) as f64,
        };
        let map = |orbit: usize| {
            let own = parameters.iter().map(|(name, value)| (*name, value + 0.125 * (orbit % 3) as f64));
            field.with(own).expect("its parameters").at(eps(orbit))
        };
        let maps: Vec<MapAt<f64>> = (0..if field.variables().len() > 4 { 3 } else { 37 }).map(map).collect();
        agree(&maps.iter().collect::<Vec<_>>(), maps.len(), &field.variables());
    }
}

#[test]
fn an_orbit_that_leaves_the_numbers_changes_no_other() {
    let field = Field::parse("xdot = y; ydot = 4*x;").expect("a field");
    let map = field.map().expect("no parameters").at(0.49);
    let mut columns = columns::<f64>(2, 16);
    columns[0][5] = 1e308;
    let reports = |columns: &mut [Vec<f64>]| {
        let mut slices: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
        MapAt::observe_columns(&[&map], &mut slices, 50, |_| Fli::new(&map)).expect("columns that fit")
    };
    let with = reports(&mut columns.clone());
    columns[0][5] = 1.0;
    let without = reports(&mut columns);
    assert!(with[5].is_nan() || with[5] == without[5]);
    for orbit in (0..16).filter(|orbit| *orbit != 5) {
        assert_eq!(with[orbit].to_bits(), without[orbit].to_bits());
    }
}

#[test]
fn maps_and_columns_have_to_fit() {
    let (_, map) = maps().nth(1).expect("two variables");
    let at = map.at(0.1);
    let refused = |maps: &[&MapAt<f64>], columns: &mut [Vec<f64>]| {
        let mut slices: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
        MapAt::observe_columns(maps, &mut slices, 1, |_| Fli::new(&at))
            .expect_err("they do not fit")
            .to_string()
    };
    assert_eq!(refused(&[&at, &at], &mut columns(2, 3)), "the maps are 2; give one, or 3, one an orbit");
    assert_eq!(refused(&[&at], &mut columns(3, 3)), "the columns are 3; give 2, one a variable");
    let uneven = &mut [vec![1.0; 3], vec![1.0; 2]];
    assert_eq!(refused(&[&at], uneven), "the column of `y` has 2 entries; give 3, as in the first");
}

fn ends<O: Observer<f64, Report: Debug>>(
    maps: &[&MapAt<f64>],
    variables: usize,
    observers: impl Fn(usize) -> O,
) -> [usize; 3] {
    const STEPS: u64 = 400;
    let mut columns = vec![vec![1.0; maps.len()]; variables];
    let mut slices: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
    let of = |orbit: usize| WhileFinite::new(observers(orbit));
    let found = MapAt::observe_columns(maps, &mut slices, STEPS, of).expect("columns that fit");
    let mut counts = [0; 3];
    for (orbit, found) in found.iter().enumerate() {
        let go_on = |_| ControlFlow::Continue(());
        let alone = maps[orbit].observe(&mut vec![1.0; variables], STEPS, observers(orbit), go_on);
        assert_eq!(format!("{found:?}"), format!("{:?}", alone.expect("a state that fits")), "orbit {orbit}");
        let ways = ["complete", "range", "stopped"];
        counts[ways.iter().position(|way| *way == found.end.name()).expect("one of them")] += 1;
    }
    counts
}

/// Fields have one, two and nine variables; orbits end at different steps within a burst of points.
#[test]
fn orbits_end_side_by_side_where_each_ends_alone() {
    let nine = "adot = a; bdot = b; cdot = c; ddot = d; edot = e; fdot = f; gdot = g; hdot = h; idot = i/2;";
    for text in ["xdot = x;", "xdot = x + y; ydot = y/2;", nine] {
        let field = Field::parse(text).expect("a field");
        let (map, variables) = (field.map().expect("no parameters").at(0.1), field.variables().len());
        let eps: Vec<f64> = (0..37).map(|k| 0.6 + 0.01 * f64::from(k)).collect();
        let maps = map.each(&eps, &[]).expect("an eps for each");
        let maps: Vec<&MapAt<f64>> = maps.iter().collect();
        let lasting = |orbit: usize| (Fli::new(maps[orbit]), Extrema::of(|x: &[f64]| x[0]));
        let [complete, range, done] = ends(&maps, variables, lasting);
        assert!(complete > 0 && range > 0 && done == 0, "{text}: {complete} {range}");
        let beyond = || Escape::when(|x: &[f64]| x[0] > 1e250).ending();
        let [complete, range, done] = ends(&maps, variables, |orbit| (lasting(orbit), beyond()));
        assert!(complete > 0 && range == 0 && done > 0, "{text}: {complete} {range} {done}");
    }
}
