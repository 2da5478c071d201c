//! `Follow` gives the points of single steps and reports the end of the orbit.

use std::num::NonZeroU64;
use std::ops::ControlFlow;

use kahan_core::observe::{Escape, Visit};
use kahan_core::{Composition, FloatScalar, Step};
use kahan_runtime::{ChainAt, End, Field, FieldText, Follow, Followed, Lattice, MachineFloat, MapAt};

use super::support::{assert_same, catalog, number, steps};

fn go_on(_: u64) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// Returns the finite points of up to `steps` steps, made by single calls.
fn by_hand<S: Step<Scalar: FloatScalar>>(map: &S, start: &[S::Scalar], steps: u64) -> Vec<Vec<S::Scalar>> {
    let mut points = vec![start.to_vec()];
    for _ in 0..steps {
        let mut x = points[points.len() - 1].clone();
        map.run(&mut x, 1).expect("floats go on");
        if !x.iter().all(|x| kahan_core::Scalar::approximate(x).is_finite()) {
            break;
        }
        points.push(x);
    }
    points
}

/// Checks that all methods of `Follow` agree with single steps; returns how the orbit ended.
fn agree<S: Step<Scalar: FloatScalar>>(map: &S, start: &[S::Scalar], steps: u64) -> End {
    let expected = by_hand(map, start, steps);
    let made = expected.len() as u64 - 1;
    let last = &expected[expected.len() - 1];
    let end = if made == steps { End::Complete } else { End::Range(made) };

    let (mut x, mut seen, mut watched) = (start.to_vec(), Vec::new(), 0);
    let visit = Visit::by(|step, x: &[S::Scalar]| {
        assert_eq!(step, seen.len() as u64);
        seen.push(x.to_vec());
    });
    let followed = map.observe(&mut x, steps, visit, |steps| {
        watched += steps;
        ControlFlow::Continue(())
    });
    assert_eq!(followed, Ok(Followed { report: (), end }));
    assert_same(
        seen.iter().flatten().collect::<Vec<_>>(),
        expected.iter().flatten().collect::<Vec<_>>(),
        made,
    );
    assert_same(&x, last, "observed");
    assert!(watched <= made && (watched == steps) == (end == End::Complete), "{watched} of {made}");

    let mut x = start.to_vec();
    assert_eq!(map.follow(&mut x, steps, go_on), Ok(Followed { report: (), end }));
    assert_same(&x, last, "followed");

    for every in [1, 7, 5000] {
        let n = start.len();
        let count = (steps / every) as usize;
        let (mut x, untouched) = (start.to_vec(), start[0]);
        let mut rows = vec![untouched; count * n];
        let followed = map.rows(&mut x, NonZeroU64::new(every).unwrap(), &mut rows, go_on).unwrap();
        let (filled, wanted) = (followed.report, count as u64 * every);
        assert_eq!(filled, (made.min(wanted) / every) as usize);
        assert_eq!(followed.end, if made < wanted { End::Range(made) } else { End::Complete });
        for (k, row) in rows.chunks(n).enumerate() {
            match expected.get((k + 1) * every as usize) {
                Some(point) => assert_same(row, point, (every, k)),
                None => assert!(k >= filled && row.iter().all(|entry| *entry == untouched)),
            }
        }
        assert_same(&x, &expected[made.min(wanted) as usize], every);
    }
    end
}

fn map_agrees<T: MachineFloat>(field: &Field, steps: u64) {
    let map = field.with(field.parameters().iter().map(|name| (name, 1.25))).expect("parameters");
    let start: Vec<T> = (0..field.variables().len()).map(|k| number(0.25 + 0.125 * k as f64)).collect();
    for composition in [Composition::KAHAN, Composition::SUZUKI_4] {
        agree(&map.at(number::<T>(0.03125)).composed(composition), &start, steps);
    }
}

#[test]
fn points_are_those_of_single_steps() {
    for name in ["lv", "e6", "euler"] {
        map_agrees::<f64>(&catalog(name), 9000);
        map_agrees::<f32>(&catalog(name), 300);
    }
    // In nine variables the step solves its equations by elimination.
    let ring = |k: usize| format!("x{k}dot = x{k}*(x{} - x{});", (k + 1) % 9, (k + 8) % 9);
    map_agrees::<f64>(&Field::parse(&(0..9).map(ring).collect::<String>()).expect("a field"), 70);
}

fn parts_agree<T: MachineFloat>(field: &Field) {
    let map = field.with(field.parameters().iter().map(|name| (name, 1.25))).expect("parameters");
    let start: Vec<T> = (0..field.variables().len()).map(|k| number(0.25 + 0.125 * k as f64)).collect();
    for composition in [Composition::KAHAN, Composition::SUZUKI_4] {
        let at = map.at(number::<T>(0.03125)).composed(composition);
        for eps in steps::<T>() {
            let [mut part, mut whole] = [start.clone(), start.clone()];
            at.run_part(&eps, &mut part).expect("floats go on");
            map.at(eps).composed(composition).advance(&mut whole, 1).unwrap();
            assert_same(&part, &whole, (composition, eps));
        }
    }
}

#[test]
fn a_part_of_a_step_is_the_step_at_another_eps() {
    for name in ["lv", "e6", "euler", "lorenz"] {
        parts_agree::<f64>(&catalog(name));
        parts_agree::<f32>(&catalog(name));
    }
}

fn chain(sites: usize) -> ChainAt {
    let text = "for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); }";
    let family = FieldText::new(text.to_owned(), "chain".to_owned()).family().unwrap().unwrap();
    let none: [(&str, [f64; 1]); 0] = [];
    Lattice::of(&family).at(0.01, sites, none).expect("a chain")
}

#[test]
fn chains_are_followed_by_the_same_calls() {
    for sites in [3, 200] {
        let start: Vec<f64> = (0..sites).map(|k| 1.0 + (k % 7) as f64 / 8.0).collect();
        assert_eq!(agree(&chain(sites), &start, 50), End::Complete);
    }
    let mut x = vec![1.0; 200];
    let stopped = chain(200).follow(&mut x, 1000, |_| ControlFlow::Break(())).unwrap();
    assert!(matches!(stopped.end, End::Stopped(steps) if steps < 100), "{stopped:?}");
}

/// The growth exp(2εn) leaves the range near step 7092.
#[test]
fn an_orbit_ends_at_its_last_finite_point() {
    let growth = Field::parse("xdot = x; ydot = x - y;").unwrap().map().unwrap();
    assert!(matches!(agree(&growth.at(0.05), &[1.0, 0.5], 20_000), End::Range(7000..7092)));
    assert!(matches!(agree(&growth.at(0.05_f32), &[1.0, 0.5], 20_000), End::Range(_)));
    let pole = Field::parse("xdot = x^2;").unwrap().map().unwrap().at(0.5);
    assert_eq!(agree(&pole, &[1.0], 5), End::Range(0));
    assert_eq!(agree(&pole, &[1.0], 0), End::Complete);
    // Observers see a start that is not finite, and nothing else.
    let (mut x, mut seen) = ([f64::INFINITY], 0);
    let followed = pole.observe(&mut x, 9, Visit::by(|_, _: &[f64]| seen += 1), go_on).unwrap();
    assert_eq!((followed.end, seen, x), (End::Range(0), 1, [f64::INFINITY]));
}

#[test]
fn observers_and_a_watch_end_a_run() {
    let growth: MapAt<f64> = Field::parse("xdot = x;").unwrap().map().unwrap().at(0.001);
    let beyond = |size: f64| Escape::when(move |x: &[f64]| x[0] > size).ending();
    let mut x = [1.0];
    let done = growth.observe(&mut x, 9999, (beyond(2.0), beyond(3.0)), go_on).unwrap();
    let expected = by_hand(&growth, &[1.0], 9999);
    let first = expected.iter().position(|x| x[0] > 2.0).expect("it grows") as u64;
    assert_eq!(done, Followed { report: (Some(first), None), end: End::Stopped(first) });
    assert_eq!(x[..], expected[first as usize]);
    let at_once = growth.observe(&mut x, 9999, beyond(2.0), go_on).unwrap();
    assert_eq!(at_once, Followed { report: Some(0), end: End::Stopped(0) });

    for most in 1..4 {
        let (mut x, mut told) = ([1.0], Vec::new());
        let followed = growth.follow(&mut x, 10_000, |steps| {
            told.push(steps);
            if told.len() == most { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        let end = [End::Stopped(4096), End::Stopped(8192), End::Complete][most - 1];
        assert_eq!(followed, Ok(Followed { report: (), end }));
        assert_eq!(told, [4096, 4096, 1808][..most]);
        let mut by_one_call = [1.0];
        growth.advance(&mut by_one_call, end.steps(10_000)).unwrap();
        assert_eq!(x, by_one_call);
    }
}

#[test]
fn states_and_rows_have_to_fit() {
    let map: MapAt<f64> = Field::parse("xdot = y; ydot = -x;").unwrap().map().unwrap().at(0.1);
    let one = NonZeroU64::MIN;
    let refused = map.rows(&mut [1.0, 0.0], one, &mut [0.0; 5], go_on).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "the rows have 5 entries; give a multiple of 2, one a variable in each row"
    );
    let refused = map.follow(&mut [1.0], 3, go_on).unwrap_err();
    assert_eq!(refused.to_string(), "the state has 1 entry; give 2, one a variable");
    assert!(
        map.observe(&mut [1.0; 3], 3, (), go_on).is_err()
            && map.rows(&mut [1.0], one, &mut [], go_on).is_err()
    );
    let none = map.rows(&mut [1.0, 0.0], one, &mut [], go_on).unwrap();
    assert_eq!(none, Followed { report: 0, end: End::Complete });
}
