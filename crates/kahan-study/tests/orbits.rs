//! Orbits as tables: rows, ranges of rows, equality of bits, methods, and ends.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU32, Ordering};

use kahan_algebra::rational::Rational;
use kahan_runtime::{Field, Follow};
use kahan_study::numbers::ScalarKind;
use kahan_study::{
    Answer, Column, End, Exact, Method, NoOrbit, Orbit, Orbited, Progress, Question, Rows, StoredColumn,
    Study, StudyError, Subject, Systems, Table, Unwatched, Values, Watch,
};
use serde_json::json;

fn study(subject: Subject) -> Study {
    subject.study(&Systems).expect("a subject")
}

fn lv() -> Study {
    study(Subject::named("lv"))
}

fn rational(p: i64, q: i64) -> Rational {
    Rational::new(p, q)
}

fn asked(steps: u64) -> Orbit {
    Orbit::new(rational(1, 7), vec![rational(1, 2), rational(5, 3)], steps)
}

fn answer(study: &Study, asked: &Orbit) -> Orbited {
    let Ok(Answer::Orbit(orbit)) = study.ask(&Question::Orbit(asked.clone()), &Unwatched) else {
        panic!("an orbit")
    };
    *orbit
}

fn rows(study: &Study, asked: &Orbit, range: std::ops::Range<u64>) -> Table {
    let mut table = Table::default();
    study.rows(&Question::Orbit(asked.clone()), range, &mut table, &Unwatched).expect("rows");
    table
}

fn doubles(table: &Table, column: usize) -> &[f64] {
    let StoredColumn::F64(list) = &table.values[column] else { panic!("doubles") };
    list
}

fn every_sort(steps: u64) -> Vec<Orbit> {
    let mut sorts = Vec::new();
    for scalar in ScalarKind::ALL {
        let orbit = Orbit { scalar, ..asked(steps) };
        sorts.push(Orbit { projective: true, ..orbit.clone() });
        for method in Method::ALL {
            // Exact Runge–Kutta steps are left out: each makes numbers sixteen times as long.
            if scalar != ScalarKind::Exact || [Method::Kahan, Method::Euler].contains(&method) {
                sorts.push(Orbit { method, ..orbit.clone() });
            }
        }
    }
    sorts
}

#[test]
fn a_range_of_rows_is_the_slice_of_all_of_them() {
    for plain in every_sort(7) {
        let orbit = Orbit { every: 2, ..plain.clone() };
        let (whole, steps) = (rows(&lv(), &orbit, 0..u64::MAX), rows(&lv(), &plain, 0..u64::MAX));
        assert_eq!(whole, answer(&lv(), &orbit).rows);
        // Rows are taken at n = 0, 2, 4 and 6; the seventh step has no row.
        let StoredColumn::Integer(counts) = &whole.values[0] else { panic!("counts") };
        assert_eq!(counts[..], [0, 2, 4, 6]);
        let cells = |table: &Table, row: usize| -> Vec<String> {
            table.values.iter().map(|kept| kept.values().cell(row).to_string()).collect()
        };
        for row in 0..4 {
            assert_eq!(cells(&whole, row), cells(&steps, 2 * row), "{orbit:?}");
            let one = rows(&lv(), &orbit, row as u64..row as u64 + 1);
            assert_eq!(cells(&one, 0), cells(&whole, row), "{orbit:?}");
        }
        assert_eq!(rows(&lv(), &orbit, 4..9), Table::default());
    }
}

struct Blocks {
    most: usize,
    blocks: Vec<usize>,
}

impl Rows for Blocks {
    fn block(&mut self, columns: &[Column], values: &[Values<'_>]) -> ControlFlow<()> {
        assert_eq!(columns.len(), values.len());
        let count = values[0].count();
        assert!(values.iter().all(|values| values.count() == count));
        self.blocks.push(count);
        if self.blocks.len() < self.most { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    }
}

#[test]
fn rows_of_floats_come_some_thousand_at_once_as_long_as_they_are_wanted() {
    let mut all = Blocks { most: usize::MAX, blocks: Vec::new() };
    let orbit = asked(10_000);
    assert_eq!(
        orbit.begin(&lv()).expect("an orbit").rows(0..u64::MAX, &mut all, &Unwatched).end,
        End::Complete
    );
    assert_eq!(all.blocks.iter().sum::<usize>(), 10_001);
    assert!(all.blocks.len() < 20 && all.blocks.iter().all(|rows| *rows <= 4096), "{:?}", all.blocks);
    let mut two = Blocks { most: 2, blocks: Vec::new() };
    assert_eq!(
        orbit.begin(&lv()).expect("an orbit").rows(0..u64::MAX, &mut two, &Unwatched).end.name(),
        "stopped"
    );
    assert_eq!(two.blocks.len(), 2);
}

#[test]
fn rows_of_doubles_have_the_bits_of_the_library() {
    let field = Field::parse(lv().text()).expect("a field");
    let map = field.map().expect("no parameters").at(1.0 / 7.0);
    let (mut x, mut points) = ([0.5, 5.0 / 3.0], [[0.0_f64; 2]; 3000]);
    let every = std::num::NonZeroU64::MIN;
    map.rows(&mut x, every, points.as_flattened_mut(), |_| ControlFlow::Continue(())).expect("fits");
    let table = answer(&lv(), &asked(3000)).rows;
    for i in 0..2 {
        let expected: Vec<u64> = points.iter().map(|point| point[i].to_bits()).collect();
        let found: Vec<u64> = doubles(&table, 2 + i)[1..].iter().map(|x| x.to_bits()).collect();
        assert_eq!(found, expected);
    }
}

struct Impatient(AtomicU32);

impl Watch for Impatient {
    fn look(&self, progress: &Progress<'_>) -> ControlFlow<()> {
        assert!(progress.done <= 1_000_000 && progress.of == Some(1_000_000));
        if self.0.fetch_add(1, Ordering::Relaxed) == 0 {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    }
}

#[test]
fn a_transient_is_not_shown() {
    for plain in every_sort(9) {
        let whole = rows(&lv(), &plain, 0..u64::MAX);
        let late = Orbit { transient: 3, steps: 6, every: 2, ..plain.clone() };
        let found = answer(&lv(), &late);
        let cells = |table: &Table, row: usize| -> Vec<String> {
            let all = table.values.iter().map(|kept| kept.values().cell(row).to_string());
            // A transient changes where the flow's Taylor series begin, and so the last digits.
            let digits = if plain.method == Method::Flow { 30 } else { usize::MAX };
            all.map(|cell| cell.chars().take(digits).collect()).collect()
        };
        assert_eq!(found.rows.count(), 4, "{late:?}");
        for row in 0..4 {
            assert_eq!(cells(&found.rows, row), cells(&whole, 3 + 2 * row), "{late:?}");
        }
        assert_eq!((found.head.transient, found.ending.step), (3, 9));
        let part = rows(&lv(), &late, 1..3);
        assert_eq!(cells(&part, 0), cells(&whole, 5), "{late:?}");
    }
    let study = Subject::text("xdot = x^2;").study(&Systems).unwrap();
    let orbit = Orbit { transient: 20, ..Orbit::new(rational(1, 20), vec![rational(1, 1)], 5) };
    let found = orbit.ask(&study, &Unwatched).unwrap();
    assert_eq!((found.rows.count(), found.ending.end.name(), found.ending.step), (0, "range", 9));
}

#[test]
fn a_watch_that_breaks_leaves_what_is_known() {
    for orbit in every_sort(1_000_000) {
        let orbit = Orbit { every: 10, eps: rational(1, 1000), ..orbit };
        let watch = Impatient(AtomicU32::new(0));
        let mut table = Table::default();
        assert_eq!(
            orbit.begin(&lv()).expect("an orbit").rows(0..u64::MAX, &mut table, &watch).end.name(),
            "stopped",
            "{orbit:?}"
        );
        assert!(table.values[0].values().count() >= 1);
        assert_eq!(watch.0.into_inner(), 2, "{orbit:?}");
    }
}

/// For ẋ = x over a time step of 1, the growth factor is 2 by Euler's method, 65/24 by Runge–Kutta,
/// e by the flow, and 3 by Kahan's map.
#[test]
fn each_method_is_what_it_is_called() {
    let growth = study(Subject::text("xdot = x;"));
    let orbit = Orbit::new(rational(1, 2), vec![Rational::from(1)], 2);
    for (method, factor) in [
        (Method::Kahan, 3.0),
        (Method::Euler, 2.0),
        (Method::Rk4, 65.0 / 24.0),
        (Method::Flow, std::f64::consts::E),
    ] {
        let table = answer(&growth, &Orbit { method, ..orbit.clone() }).rows;
        for (n, x) in [(0, 1.0), (1, factor), (2, factor * factor)] {
            assert!((doubles(&table, 2)[n] - x).abs() <= 8.0 * f64::EPSILON * x, "{method:?} {n}");
        }
    }
    let exact = Orbit { scalar: ScalarKind::Exact, method: Method::Rk4, ..orbit.clone() };
    let StoredColumn::Exact(values) = &answer(&growth, &exact).rows.values[2] else {
        panic!("exact numbers")
    };
    assert_eq!(values[1], Exact::Number((&rational(65, 24)).into()));
    let back = Orbit { eps: rational(-1, 2), method: Method::Flow, ..orbit };
    assert!((doubles(&answer(&growth, &back).rows, 2)[2] - (-2.0_f64).exp()).abs() < 1e-16);
}

/// The solution of ẋ = x² + 1 from 0 is tan t, which is infinite at π/2; Kahan's map jumps over the
/// pole.
#[test]
fn the_flow_ends_where_it_escapes() {
    let away = study(Subject::text("xdot = x^2 + 1;"));
    let orbit = Orbit { method: Method::Flow, ..Orbit::new(rational(1, 20), vec![Rational::zero()], 100) };
    let found = answer(&away, &orbit);
    assert_eq!(found.ending.end, End::Range(15));
    let why = found.ending.why.expect("a sentence");
    assert!(why.contains("escapes to infinity") && why.contains("x = 14.1"), "{why}");
    for (t, x) in doubles(&found.rows, 1).iter().zip(doubles(&found.rows, 2)) {
        // Near its pole, tan amplifies the rounding error of t.
        assert!((x - t.tan()).abs() <= 1e-15 * (1.0 + x * x), "{t}: {x}");
    }
    assert_eq!(doubles(&found.rows, 1).len(), 16);
}

#[test]
fn what_does_not_go_together_says_so() {
    let error = |orbit: Orbit| lv().ask(&Question::Orbit(orbit), &Unwatched).expect_err("a mistake");
    let (order, scalar) = (4, ScalarKind::Exact);
    let refused = |orbit: Orbit| match error(orbit) {
        StudyError::Orbit(why) => why,
        other => panic!("{other:?}"),
    };
    let plain = || asked(5);
    assert_eq!(refused(Orbit { order, scalar, ..plain() }), NoOrbit::Irrational(4));
    assert_eq!(refused(Orbit { order, projective: true, ..plain() }), NoOrbit::ProjectiveOrder);
    let method = Method::Euler;
    assert_eq!(refused(Orbit { method, projective: true, ..plain() }), NoOrbit::ProjectiveMethod);
    assert_eq!(refused(Orbit { method, order, ..plain() }), NoOrbit::OwnOrder(method));
    assert_eq!(refused(Orbit { method: Method::Flow, scalar, ..plain() }), NoOrbit::ExactFlow);
    assert!(matches!(error(Orbit { order: 3, ..plain() }), StudyError::Order(3)));
    assert!(matches!(error(Orbit { every: 0, ..plain() }), StudyError::NotPositive { what: "every", .. }));
    assert!(matches!(error(asked(1 << 23)), StudyError::TooLong { cells } if cells > 1 << 24));
    let far = Orbit { scalar: ScalarKind::F32, eps: rational(10_i64.pow(18), 1), ..plain() };
    let far =
        Orbit { at: vec![rational(10_i64.pow(18), 1), Rational::parse("1e40").expect("a number")], ..far };
    assert!(matches!(
        error(far),
        StudyError::BeyondRange { what: "at", name, scalar: ScalarKind::F32 } if name == "y"
    ));
    let heights = serde_json::from_value(json!({"ask": "heights", "eps": 1, "at": [1, 2], "steps": 3}));
    let none = lv().rows(&heights.expect("a question"), 0..9, &mut Table::default(), &Unwatched);
    assert!(matches!(none, Err(StudyError::NoRows("heights"))));
}

#[test]
fn crossings_are_rows_too() {
    let asked =
        json!({"ask": "section", "eps": "1/100", "at": [1, "1/2"], "steps": 5000, "plane": "y - x/2"});
    let question: Question = serde_json::from_value(asked).expect("a question");
    let turning = study(Subject::text("xdot = y; ydot = -x;"));
    let Ok(Answer::Section(found)) = turning.ask(&question, &Unwatched) else { panic!("crossings") };
    assert!(found.rows.count() > 10);
    let mut table = Table::default();
    let end = turning.rows(&question, 3..7, &mut table, &Unwatched).expect("rows");
    assert_eq!((end, doubles(&table, 1).len()), (End::Complete, 4));
    for column in 1..4 {
        assert_eq!(doubles(&table, column), &doubles(&found.rows, column)[3..7]);
    }
}

#[test]
fn every_method_shows_the_integrals_that_it_keeps() {
    let e6 = study(Subject::named("e6"));
    let at = vec![rational(1, 1), rational(2, 1), rational(3, 1)];
    let columns = |orbit: Orbit| -> (f64, f64) {
        let found = answer(&e6, &orbit);
        let StoredColumn::F64(values) = &found.rows.values[5] else { panic!("doubles") };
        let greatest = values.iter().map(|value| (value - values[0]).abs()).fold(0.0, f64::max);
        (values[0], greatest / values[0])
    };
    let orbit = Orbit::new(rational(1, 20), at, 50);
    let (own, drift) = columns(orbit.clone());
    assert!(own != 7.0 && drift < 1e-13, "{own}, {drift}");
    // At the start the integral xz + y² is 7. The flow preserves it, a composition nearly does.
    let (flow, drift) = columns(Orbit { method: Method::Flow, ..orbit.clone() });
    assert!(flow == 7.0 && drift < 1e-13, "{flow}, {drift}");
    for other in [Orbit { order: 8, ..orbit.clone() }, Orbit { method: Method::Rk4, ..orbit.clone() }] {
        let (first, drift) = columns(other);
        assert!(first == 7.0 && drift > 1e-13, "{first}, {drift}");
    }
}

#[test]
fn what_is_claimed_at_one_step_is_a_column_there() {
    let kept = "xdot = a*y; ydot = -x; integral H = x^2 + y^2 when a = 1; integral K = x^2 + a*y^2 when eps = 1/2, a = 2;";
    let columns = |a: i64, eps: Rational| {
        let study = study(Subject::text(kept).with("a", a.into()));
        let orbit = Orbit::new(eps, vec![1.into(), 0.into()], 3);
        let found = answer(&study, &orbit);
        let named: Vec<String> = found.head.columns[4..].iter().map(|column| column.name.clone()).collect();
        assert_eq!(rows(&study, &orbit, 0..4), found.rows);
        named.join(" ")
    };
    assert_eq!(columns(1, rational(1, 2)), "H");
    assert_eq!(columns(2, rational(1, 2)), "K");
    assert_eq!(columns(2, rational(1, 3)), "");
}

#[test]
fn components_that_steps_do_not_resolve_are_noted() {
    let decay = study(Subject::text("xdot = -100*(x - y); ydot = -y;"));
    let oscillator = study(Subject::text("xdot = y; ydot = -x;"));
    let at = |study: &Study, eps: Rational| {
        ScalarKind::ALL.map(|scalar| {
            let orbit = Orbit::new(eps.clone(), vec![Rational::zero(), Rational::one()], 20);
            answer(study, &Orbit { scalar, ..orbit }).ending.note
        })
    };
    // Exact orbits have long steps on purpose, and get no warning.
    for (scalar, note) in ScalarKind::ALL.into_iter().zip(at(&decay, rational(1, 10))) {
        let is_noted = note.is_some_and(|note| note.contains("up to 20 for an eigenvalue"));
        assert_eq!(is_noted, scalar != ScalarKind::Exact, "{scalar:?}");
    }
    assert_eq!(at(&decay, rational(99, 10_000)), [const { None }; 4]);
    assert_eq!(at(&oscillator, rational(1, 10)), [const { None }; 4]);
    assert!(at(&oscillator, rational(3, 2))[1..].iter().all(Option::is_some));
    let noted = Orbit::new(rational(1, 10), vec![Rational::zero(), Rational::one()], 3);
    assert!(json!(answer(&decay, &noted))["note"].is_string());
    assert_eq!(json!(answer(&oscillator, &noted)).get("note"), None);
    assert_eq!(answer(&decay, &Orbit { method: Method::Flow, ..noted }).ending.note, None);
}
