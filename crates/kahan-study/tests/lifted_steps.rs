//! Tests steps of lifted fields: symmetric projection, and orbits on which a square root reaches 0.

use kahan_algebra::rational::Rational;
use kahan_core::{Step, Workspace};
use kahan_dynamics::Need;
use kahan_runtime::Follow;
use kahan_study::numbers::ScalarKind;
use kahan_study::trade::Trade;
use kahan_study::{
    Axis, AxisOver, Diagram, End, LiftCriterion, Lifting, NoOrbit, Observable, Observe, ObservedValue, Orbit,
    Over, Question, Range, Section, Study, StudyError, Subject, Systems, Table, Unwatched, Watch,
};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

const PENDULUM: &str = "xdot = v; vdot = -sin(x);";
const KEPLER: &str = "x' = p; y' = q; p' = -x/(x^2 + y^2)^(3/2); q' = -y/(x^2 + y^2)^(3/2); x(0) = 1; y(0) = 0; p(0) = 0; q(0) = 1.1";
const TORRICELLI: &str = "hdot = -sqrt(h);";

fn lifted(text: &str) -> Study {
    Subject::text(text).lifted(LiftCriterion::Automatic).study(&Systems).expect("a field that is lifted")
}

fn rational(above: i64, below: i64) -> Rational {
    Rational::new(above, below)
}

fn last(study: &Study, asked: Orbit) -> (Vec<f64>, End, Option<String>) {
    let found = asked.ask(study, &Unwatched).expect("an orbit");
    let columns = found.rows.columns.iter().zip(&found.rows.values).skip(2).take(study.shown().len());
    let last = columns.map(|(_, kept)| match kept {
        kahan_study::StoredColumn::F64(values) => *values.last().expect("a row"),
        other => panic!("{other:?}"),
    });
    (last.collect(), found.ending.end, found.ending.why)
}

#[test]
fn every_question_about_orbits_projects_the_same_steps() {
    let study = lifted(PENDULUM);
    let (eps, at) = (rational(1, 10), vec![rational(1, 1), rational(1, 2)]);
    for order in [2, 4, 8] {
        let plain = Orbit { order, ..Orbit::new(eps.clone(), at.clone(), 100) };
        let (expected, end, _) = last(&study, Orbit { reembed: true, ..plain.clone() });
        assert_eq!(end, End::Complete);
        assert_ne!(last(&study, plain).0, expected);
        let of = vec![Observable::Last, Observable::Extrema];
        let observe =
            Observe { order, observe: of, reembed: true, ..Observe::new(eps.clone(), at.clone(), 100) };
        let seen = observe.ask(&study, &Unwatched).expect("observations");
        assert_eq!(seen.of(Observable::Last), Some(&ObservedValue::Point(expected.clone())));
        let axis = AxisOver::from(Axis { name: "x".to_owned(), range: Range::read("1/2:1:2").unwrap() });
        let mut table = Table::default();
        let over = Question::Over(Over::new(Question::Observe(observe), vec![axis]));
        study.rows(&over, 0..u64::MAX, &mut table, &Unwatched).expect("rows");
        let column = |name: &str| {
            let place = table.columns.iter().position(|column| column.name == name).expect("a column");
            match &table.values[place] {
                kahan_study::StoredColumn::F64(values) => values[1],
                other => panic!("{other:?}"),
            }
        };
        assert_eq!([column("final_x"), column("final_v")], expected[..]);
    }
    let over = Axis { name: "eps".to_owned(), range: Range::read("1/10:1/5:2").unwrap() };
    let diagram = Diagram { transient: 90, reembed: true, ..Diagram::new(None, at.clone(), over, 10) };
    let found = diagram.ask(&study, &Unwatched).expect("a diagram");
    let (expected, ..) = last(&study, Orbit { reembed: true, ..Orbit::new(eps, at, 100) });
    assert_eq!(found.points[0].last(), Some(&expected[0]));
}

#[test]
fn sections_refine_crossings_on_projected_steps() {
    let study = lifted(PENDULUM);
    let asked = Section::new(rational(1, 20), vec![rational(1, 1), rational(0, 1)], 2000, "v");
    let found = Section { reembed: true, ..asked.clone() }.ask(&study, &Unwatched).expect("a section");
    let plain = asked.ask(&study, &Unwatched).expect("a section");
    assert!(found.count() > 20 && found.orbit().end == End::Complete);
    assert_ne!(found.point(3), plain.point(3));
    for row in 0..found.count() {
        let [x, v] = found.point(row)[..] else { panic!("{:?}", found.point(row)) };
        assert!(v.abs() < 1e-12 && (x + 1.0).abs() < 1e-3, "{x} {v}");
    }
}

/// A step depends only on its point, and a step with −ε undoes it.
#[test]
fn projected_steps_are_reversible_and_forget_the_steps_before() {
    let study = lifted(KEPLER);
    let at = study.map().unwrap().at(0.05);
    let step = study.steps(&at, true).expect("a lifted field");
    let back = study.map().unwrap().at(-0.05);
    let back = study.steps(&back, true).expect("a lifted field");
    let start: Vec<f64> =
        study.point(&study.start().unwrap()).unwrap().iter().map(Rational::to_f64).collect();
    let (mut x, mut workspace) = (start.clone(), Workspace::new());
    for _ in 0..20 {
        step.advance(&mut x, 1, &mut workspace).unwrap();
    }
    let mut at_once = start.clone();
    step.advance(&mut at_once, 20, &mut workspace).unwrap();
    assert_eq!(x, at_once);
    back.advance(&mut x, 20, &mut workspace).unwrap();
    assert!(x.iter().zip(&start).all(|(x, start)| (x - start).abs() < 1e-12), "{x:?}");
}

#[test]
fn what_is_of_the_map_is_refused_with_its_reason() {
    let study = lifted(PENDULUM);
    let (eps, at) = (rational(1, 10), vec![rational(1, 1), rational(0, 1)]);
    let plain = Observe { reembed: true, ..Observe::new(eps.clone(), at.clone(), 10) };
    for (one, name) in [(Observable::Sali, "sali"), (Observable::PassedPoles, "passed_poles")] {
        let refused =
            Observe { observe: vec![Observable::Last, one], ..plain.clone() }.ask(&study, &Unwatched);
        let refused = refused.expect_err("a refusal");
        assert!(matches!(refused, StudyError::Orbit(NoOrbit::OfTheMap(known)) if known == name));
        assert!(refused.to_string().contains("extrema"), "{refused}");
    }
    let quadratic = Subject::text("xdot = v; vdot = -x;").study(&Systems).unwrap();
    let section = Section { reembed: true, ..Section::new(eps.clone(), at.clone(), 10, "v") };
    let observe = Observe { observe: vec![Observable::Last], ..plain };
    let orbit = Orbit { reembed: true, ..Orbit::new(eps, at, 10) };
    let no_relations = [
        section.ask(&quadratic, &Unwatched).map(drop),
        observe.ask(&quadratic, &Unwatched).map(drop),
        orbit.ask(&quadratic, &Unwatched).map(drop),
        Orbit { scalar: ScalarKind::F32, ..orbit.clone() }.ask(&study, &Unwatched).map(drop),
    ];
    for refused in no_relations {
        assert!(matches!(refused, Err(StudyError::Orbit(NoOrbit::Reembed))), "{refused:?}");
    }
}

#[test]
fn orbits_end_where_no_step_leads_back() {
    let text = "x' = 1 + x^2*y - 4*x; y' = 3*x - x^2*y";
    let study = lifted(text);
    let (eps, at) = (rational(1, 10), vec![rational(1, 1), rational(1, 1)]);
    let asked = Orbit { reembed: true, ..Orbit::new(eps.clone(), at.clone(), 1000) };
    let (_, end, why) = last(&study, asked);
    let End::Reembed(steps) = end else { panic!("{end:?}") };
    assert!(why.is_some_and(|why| why.contains("relations of the lift") && why.contains("smaller eps")));
    let observe = Observe {
        reembed: true,
        observe: vec![Observable::Extrema],
        ..Observe::new(eps.clone(), at.clone(), 1000)
    };
    assert_eq!(observe.ask(&study, &Unwatched).unwrap().end, End::Reembed(steps));
    let section = Section { reembed: true, ..Section::new(eps, at, 1000, "x - 1") };
    let found = section.ask(&study, &Unwatched).unwrap();
    assert!(found.orbit().end == End::Reembed(steps) && found.orbit().why.is_some());
}

#[test]
fn torricellis_law_ends_where_the_water_does() {
    let study = lifted(TORRICELLI);
    for scalar in [ScalarKind::F64, ScalarKind::F32, ScalarKind::Dd] {
        for (every, order) in [(1, 2), (7, 2), (1, 4)] {
            let asked =
                Orbit { scalar, every, order, ..Orbit::new(rational(1, 64), vec![rational(1, 1)], 500) };
            let found = asked.ask(&study, &Unwatched).expect("an orbit");
            // Without rounding errors, the height h would be 0 after 64 steps.
            let End::Range(steps) = found.ending.end else { panic!("{:?}", found.ending) };
            assert!((63..=65).contains(&steps), "{scalar:?} {every} {order}: {steps}");
            let why = found.ending.why.expect("a reason");
            assert!(
                why.contains("sqrt(h)") && why.contains("never negative") && why.contains("h = "),
                "{why}"
            );
        }
    }
    for reembed in [false, true] {
        let (eps, at) = (rational(1, 60), vec![rational(1, 1)]);
        let asked = Orbit { reembed, ..Orbit::new(eps.clone(), at.clone(), 500) };
        let (point, end, _) = last(&study, asked);
        assert!(matches!(end, End::Range(58..=60)) && (0.0..1e-3).contains(&point[0]), "{end:?} {point:?}");
        let of = vec![Observable::Extrema];
        let observe = Observe { reembed, observe: of, ..Observe::new(eps.clone(), at.clone(), 500) };
        let seen = observe.ask(&study, &Unwatched).unwrap();
        assert_eq!(seen.end, end);
        assert!(seen.why.is_some_and(|why| why.contains("sqrt(h)")));
        let section = Section { reembed, ..Section::new(eps, at, 500, "h - 1/2") };
        let section =
            Section { direction: kahan_study::Direction::Both, ..section }.ask(&study, &Unwatched).unwrap();
        assert_eq!((section.orbit().end, section.count()), (end, 1));
    }
}

#[test]
fn orbits_side_by_side_end_alone() {
    let study = lifted(TORRICELLI);
    let of = vec![Observable::Last];
    let observe = Observe { observe: of, ..Observe::new(rational(1, 64), vec![rational(1, 1)], 80) };
    let axis = AxisOver::from(Axis { name: "h".to_owned(), range: Range::read("1:4:4").unwrap() });
    for of in [vec![Observable::Last], vec![Observable::Last, Observable::Extrema]] {
        let observe = Observe { observe: of, ..observe.clone() };
        let over = Over::new(Question::Observe(observe), vec![axis.clone()]);
        let found = over.ask(&study, &Unwatched).expect("a table");
        let ended = serde_json::to_value(&found).unwrap();
        let text = ended.to_string();
        assert_eq!(text.matches("\"range\"").count(), 1, "{text}");
        assert_eq!(text.matches("\"complete\"").count(), 3, "{text}");
    }
}

#[test]
fn other_variables_may_change_their_signs() {
    for (text, at) in [
        ("xdot = v; vdot = -x^3;", vec![rational(1, 1), rational(0, 1)]),
        (PENDULUM, vec![rational(1, 1), rational(0, 1)]),
        ("xdot = cbrt(1 + y); ydot = -x;", vec![rational(0, 1), rational(1, 1)]),
    ] {
        let study = lifted(text);
        let (_, end, why) = last(&study, Orbit::new(rational(1, 50), at, 300));
        assert_eq!(end, End::Complete, "{text}: {why:?}");
    }
}

/// A clock that advances by a microsecond at each reading, independent of the machine's speed.
#[derive(Debug, Default)]
struct Clock(AtomicU64);

impl Watch for Clock {
    fn now(&self) -> Option<Duration> {
        Some(Duration::from_micros(self.0.fetch_add(1, Ordering::Relaxed)))
    }

    fn look(&self, _: &kahan_study::Progress<'_>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    fn found(&self, _: &kahan_study::Finding) {}

    fn threads(&self) -> usize {
        1
    }
}

/// Errors are relative to the size of the original variables.
#[test]
fn trades_of_lifted_fields_measure_the_original_variables() {
    let scale = |time: i64| {
        let text = "xdot = v; vdot = -x + cos(2*t);";
        let lifting = Lifting { time: time.into(), ..Lifting::default() };
        let study = Subject::text(text).lifting(lifting).study(&Systems).expect("a field that is lifted");
        let (at, tolerance) = (vec![rational(1, 1), rational(0, 1)], rational(1, 1000));
        let asked = Trade { tolerance, seconds: 4.0, ..Trade::new(at, rational(5, 1)) };
        assert_eq!(asked.need, Need::Trajectory);
        let found = asked.ask(&study, &Clock::default()).expect("a trade");
        let choice = found.choice().expect("a setting");
        (found.scale.expect("a scale"), choice.setting.eps(), choice.error())
    };
    for time in [0, 1000] {
        let (scale, eps, error) = scale(time);
        assert!((1.0..3.0).contains(&scale), "{time}: {scale}");
        assert!(eps < 1.0 && error <= 1e-3, "{time}: {eps} {error}");
    }
}

#[test]
fn steps_follow_like_those_of_any_map() {
    let study = lifted(TORRICELLI);
    let at = study.map().unwrap().at(1.0 / 64.0);
    let step = study.steps(&at, false).expect("a root has a sign");
    let mut x = vec![1.0, 1.0];
    let followed = step.follow(&mut x, 1000, |_| ControlFlow::Continue(())).unwrap();
    assert_eq!(followed.end, End::Range(64));
    assert_eq!((step.dimension(), x[1]), (2, 0.0));
    let end = at.follow(&mut [1.0, 1.0], 1000, |_| ControlFlow::Continue(())).unwrap().end;
    assert_eq!(end, End::Complete);
}
