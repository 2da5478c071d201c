//! Tests that the section of many orbits equals the sections of the single orbits, bit for bit.

use std::ops::ControlFlow;

use kahan_algebra::rational::Rational;
use kahan_study::{
    Axis, AxisOver, Diagram, Direction, End, Progress, Range, Section, SectionFound, Study, Subject, Systems,
    Unwatched, Watch,
};

const HENON_HEILES: &str = "xdot = p; ydot = q; pdot = -x - 2*x*y; qdot = y^2 - x^2 - y;";
const ROSSLER: &str = "xdot = -y - z; ydot = x + a*y; zdot = b + z*(x - c);";

fn rational(above: i64, below: i64) -> Rational {
    Rational::new(above, below)
}

fn henon_heiles() -> Study {
    Subject::text(HENON_HEILES).study(&Systems).expect("a field")
}

fn rossler() -> Study {
    let fifth = || rational(1, 5);
    Subject::text(ROSSLER).with("a", fifth()).with("b", fifth()).study(&Systems).expect("a field")
}

fn starts(count: i64) -> Vec<Vec<Rational>> {
    let start = |k| vec![rational(0, 1), rational(k, 4 * count), rational(9, 20), rational(1, 10)];
    (0..count).map(start).collect()
}

fn through(name: &str, range: &str) -> Axis {
    Axis { name: name.to_owned(), range: Range::read(range).expect("a range") }
}

struct Threads(usize);

impl Watch for Threads {
    fn threads(&self) -> usize {
        self.0
    }
}

fn asked(study: &Study, section: &Section) -> SectionFound {
    section.ask(study, &Unwatched).expect("a section")
}

/// Checks the rows of one orbit among many against the section of this orbit alone.
fn is_alone(study: &Study, many: &SectionFound, orbit: usize, own: &SectionFound) {
    let first: u64 = many.orbits[..orbit].iter().map(|one| one.crossings).sum();
    let (one, alone) = (&many.orbits[orbit], own.orbit());
    assert_eq!((one.steps, one.end, one.jumps), (alone.steps, alone.end, alone.jumps), "{orbit}");
    assert_eq!(one.crossings as usize, own.count(), "{orbit}");
    for row in 0..own.count() {
        let place = first as usize + row;
        assert_eq!(many.steps()[place], own.steps()[row]);
        assert_eq!(many.times()[place].to_bits(), own.times()[row].to_bits());
        let bits =
            |found: &SectionFound, row| found.point(row).iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(many, place), bits(own, row), "{} {orbit} {row}", study.name());
    }
}

#[test]
fn crossings_of_many_orbits_have_the_bits_of_single_ones() {
    let study = henon_heiles();
    for (direction, transient, order, plane) in [
        (Direction::Rising, 0, 2, "x"),
        (Direction::Both, 1500, 2, "x*y - 1/50"),
        (Direction::Falling, 7, 4, "sin(3*y) - q"),
    ] {
        let plain = Section::new(rational(1, 20), Vec::new(), 3000, plane);
        let plain = Section { direction, transient, order, crossings: Some(40), ..plain };
        let many = asked(&study, &Section { starts: starts(21), ..plain.clone() });
        assert_eq!(many.orbits.len(), 21);
        assert!(many.count() > 300, "{}", many.count());
        for (orbit, at) in starts(21).into_iter().enumerate() {
            is_alone(&study, &many, orbit, &asked(&study, &Section { at, ..plain.clone() }));
        }
    }
}

#[test]
fn orbits_end_alone_beside_others() {
    let study = henon_heiles();
    let mut starts = starts(9);
    starts[3][0] = kahan_study::numbers::number("1e200").expect("a number");
    starts[5] = vec![rational(0, 1); 4];
    let plain = Section { crossings: Some(12), ..Section::new(rational(1, 10), Vec::new(), 2000, "x") };
    let many = asked(&study, &Section { starts: starts.clone(), ..plain.clone() });
    for (orbit, at) in starts.into_iter().enumerate() {
        is_alone(&study, &many, orbit, &asked(&study, &Section { at, ..plain.clone() }));
    }
    assert!(matches!(many.orbits[0].end, End::Stopped(_)) && many.orbits[0].crossings == 12);
    assert!(many.orbits[3].end.is_early(), "{:?}", many.orbits[3]);
    assert_eq!((many.orbits[5].end, many.orbits[5].crossings), (End::Complete, 0));
}

#[test]
fn tables_do_not_depend_on_threads() {
    let study = rossler();
    let over = vec![AxisOver::from(through("c", "2:6:50"))];
    let at = vec![rational(1, 1), rational(1, 1), rational(0, 1)];
    let plain =
        Section { crossings: Some(5), transient: 2000, over, ..Section::new(rational(1, 40), at, 0, "y") };
    let asked = Section { steps: None, ..plain };
    let tables = [1, 2, 3, 7].map(|threads| {
        let found = asked.ask(&study, &Threads(threads)).expect("a section");
        assert_eq!(found.count(), 250);
        (found.rows, found.orbits)
    });
    assert!(tables.iter().all(|table| *table == tables[0]));
    let names: Vec<&str> = tables[0].0.columns.iter().map(|column| &*column.name).collect();
    assert_eq!(names, ["start", "c", "n", "t", "x", "y", "z"]);
    assert_eq!(tables[0].1[49].values, [6.0]);
}

#[test]
fn parameters_beside_starts() {
    let study = rossler();
    let starts: Vec<Vec<Rational>> =
        [1, 2, 3].map(|x| vec![rational(x, 1), rational(1, 1), rational(0, 1)]).to_vec();
    let list = |name: &str, values: &[&str]| {
        let object = serde_json::json!({"ask": "section", "plane": "y", "eps": "1/40", "crossings": 4, "params": {name: values}});
        let kahan_study::Question::Section(asked) = serde_json::from_value(object).expect("a question")
        else {
            panic!("a section");
        };
        asked
    };
    let asked = Section { starts: starts.clone(), ..list("c", &["4", "5", "6"]) };
    let many = asked.ask(&study, &Unwatched).expect("a section");
    assert_eq!(many.orbits.iter().map(|one| one.values[0]).collect::<Vec<_>>(), [4.0, 5.0, 6.0]);
    for (orbit, (at, c)) in starts.iter().zip([4, 5, 6]).enumerate() {
        let study = Subject::text(ROSSLER).with("a", rational(1, 5)).with("b", rational(1, 5));
        let study = study.with("c", rational(c, 1)).study(&Systems).expect("a field");
        let single = Section { at: at.clone(), starts: Vec::new(), params: Vec::new(), ..asked.clone() };
        is_alone(&study, &many, orbit, &single.ask(&study, &Unwatched).expect("a section"));
    }
    let two = Section { starts: starts[..2].to_vec(), ..asked };
    let said = two.ask(&study, &Unwatched).expect_err("three values for two").to_string();
    assert_eq!(said, "c: one value for each of the 2 first points is needed");
}

/// For a method of order p, halving ε divides the error of a crossing time by 2^p.
#[test]
fn times_of_crossings_have_the_order_of_the_method() {
    let pendulum = Subject::text("xdot = y; ydot = -x - x^2/2;").study(&Systems).expect("a field");
    let time = |order: u32, parts: i64| {
        let at = vec![rational(1, 2), rational(0, 1)];
        let plain = Section::new(rational(1, parts), at, 100_000, "x - 1/10");
        let found = asked(&pendulum, &Section { order, crossings: Some(3), ..plain });
        found.times()[2]
    };
    let exact = time(8, 40);
    for (order, parts) in [(2, 20), (4, 8), (6, 5)] {
        let [coarse, fine] = [parts, 2 * parts].map(|parts| (time(order, parts) - exact).abs());
        let slope = (coarse / fine).log2();
        assert!((slope - f64::from(order)).abs() < 0.4, "order {order}: {slope}, {coarse:e} {fine:e}");
        assert!(fine > 1e-12, "{fine:e}");
    }
}

/// Maxima of x in Rössler's system take one value for c = 5/2, and two values for c = 7/2.
#[test]
fn a_diagram_shows_periods_that_double() {
    let study = rossler();
    let at = vec![rational(1, 1), rational(1, 1), rational(0, 1)];
    let plain = Diagram::new(Some(rational(1, 40)), at, through("c", "5/2:7/2:2"), 0);
    let asked = Diagram {
        plane: Some(study.rate("x").expect("a variable")),
        direction: Direction::Falling,
        crossings: Some(40),
        transient: 20_000,
        steps: None,
        ..plain
    };
    for carry in [false, true] {
        let found = Diagram { carry, ..asked.clone() }.ask(&study, &Unwatched).expect("a diagram");
        assert_eq!((found.values.len(), found.ended, found.stopped), (2, 0, false));
        let loops = |points: &[f64]| {
            let mut points: Vec<i64> = points.iter().map(|x| (x * 1e3).round() as i64).collect();
            points.sort_unstable();
            points.dedup_by(|a, b| (*a - *b).abs() < 5);
            points.len()
        };
        assert_eq!(found.points.iter().map(|points| loops(points)).collect::<Vec<_>>(), [1, 2], "{carry}");
    }
}

#[test]
fn a_carried_orbit_goes_on() {
    let turn = Subject::text("xdot = w*y; ydot = -w*x;").study(&Systems).expect("a field");
    let over = vec![AxisOver::from(through("w", "1:2:3"))];
    let at = vec![rational(1, 1), rational(0, 1)];
    let plain = Section { over, crossings: Some(2), ..Section::new(rational(1, 50), at, 1000, "x") };
    let anew = asked(&turn, &plain);
    let carried = asked(&turn, &Section { carry: true, ..plain });
    assert_eq!(anew.count(), 6);
    assert_eq!(carried.point(0), anew.point(0));
    // With `carry`, the second orbit starts on the section, and first crosses it a full turn later.
    let [first, next] = [&anew, &carried].map(|found| found.times()[2] * 1.5 / std::f64::consts::TAU);
    assert!((first - 0.75).abs() < 0.01 && (next - 1.0).abs() < 0.02, "{first} {next}");
}

#[test]
fn a_watch_ends_the_work() {
    struct Soon;
    impl Watch for Soon {
        fn look(&self, progress: &Progress<'_>) -> ControlFlow<()> {
            if progress.done > 100_000 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        }
    }
    let plain = Section { starts: starts(8), ..Section::new(rational(1, 20), Vec::new(), 1 << 40, "x") };
    let found = plain.ask(&henon_heiles(), &Soon).expect("a section");
    assert!(found.orbits.iter().all(|one| matches!(one.end, End::Stopped(steps) if steps < 100_000)));
    assert!(found.count() > 100);
}
