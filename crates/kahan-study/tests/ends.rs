//! All questions that follow an orbit agree on how and at which step the orbit ends.

use std::ops::ControlFlow;

use kahan_algebra::rational::Rational;
use kahan_study::{
    Answer, AxisOver, End, Observable, Observe, Orbit, Over, Question, Section, StoredColumn, Study, Subject,
    Systems, Unwatched,
};
use serde_json::json;

/// Cases: a field, a start, ε, a number of steps, and the expected end of the orbit.
const ENDS: [(&str, &[&str], &str, u64, End); 6] = [
    // 1/x falls by 1/10 in each step. After nine steps x = 10, which is the pole of the map.
    ("xdot = x^2;", &["1"], "1/20", 11, End::Range(9)),
    ("xdot = x^2;", &["1"], "1/20", 9, End::Complete),
    // The orbit jumps over the pole of the flow.
    ("xdot = x^2 + 1;", &["0"], "1/20", 40, End::Complete),
    ("xdot = x;", &["1"], "1/2", 1000, End::Range(646)),
    ("xdot = y; ydot = -x;", &["1", "0"], "1/20", 50, End::Complete),
    ("xdot = y; ydot = x^2;", &["1e200", "2"], "1/20", 50, End::Range(0)),
];

fn number(text: &str) -> Rational {
    Rational::parse(text).expect("a number")
}

fn over(study: &Study, asked: Observe, starts: &[&Vec<Rational>]) -> Vec<(String, i64, f64)> {
    let mut over = Over::new(Question::Observe(asked), Vec::<AxisOver>::new());
    over.starts = starts.iter().map(|start| (*start).clone()).collect();
    let Answer::Over(found) = study.ask(&Question::Over(over), &Unwatched).expect("cells") else {
        unreachable!("the answer to this question")
    };
    let place = |name: &str| found.columns.iter().position(|column| column == name).expect(name);
    let values = &found.rows.values;
    let [StoredColumn::Text(ended), StoredColumn::Integer(steps), StoredColumn::F64(last)] =
        ["ended", "ended_step", "final_x"].map(|name| &values[place(name)])
    else {
        panic!("{values:?}")
    };
    ended.iter().cloned().zip(steps).zip(last).map(|((ended, step), last)| (ended, *step, *last)).collect()
}

#[test]
fn an_orbit_ends_in_the_same_way_and_at_the_same_step_wherever_it_is_followed() {
    for (text, at, eps, steps, end) in ENDS {
        let study = Subject::text(text).study(&Systems).expect("a field");
        let (at, eps): (Vec<Rational>, _) = (at.iter().map(|x| number(x)).collect(), number(eps));
        let orbit = Orbit::new(eps.clone(), at.clone(), steps);
        for every in [1, 4] {
            let found = Orbit { every, ..orbit.clone() }.ask(&study, &Unwatched).expect("an orbit");
            assert_eq!((found.ending.end, found.ending.step), (end, end.steps(steps)), "{text}");
            assert_eq!(json!(found)["ended_step"], end.steps(steps));
        }
        let section = Section::new(eps.clone(), at.clone(), steps, "x - 1/3").ask(&study, &Unwatched);
        let section = section.expect("a section");
        assert_eq!((section.orbit().end, section.orbit().steps), (end, end.steps(steps)), "{text}");
        assert_eq!(json!(section)["ended"], end.name());

        let plain = Observe::new(eps.clone(), at.clone(), steps);
        let late = |transient: u64| Observe { transient, steps: steps - transient, ..plain.clone() };
        for (of, plain) in [
            (&Observable::usual()[..], plain.clone()),
            (&[Observable::Last], plain.clone()),
            (&[Observable::Last], late(5)),
            (&Observable::usual()[..], late(steps - 1)),
        ] {
            let asked = Observe { observe: of.to_vec(), ..plain };
            let observed = asked.ask(&study, &Unwatched).expect("observations");
            assert_eq!((observed.end, observed.steps), (end, end.steps(steps)), "{text}");
            assert_eq!(json!(observed)["ended"], end.name());
        }
        for of in [vec![Observable::Last], vec![Observable::Last, Observable::Sali]] {
            for (count, transient) in [(1, 0), (3, 0), (1, 7), (3, 7), (3, steps - 1)] {
                let asked = Observe { observe: of.clone(), ..late(transient) };
                for (ended, step, last) in over(&study, asked, &vec![&at; count]) {
                    assert_eq!((&*ended, step as u64), (end.name(), end.steps(steps)), "{text}");
                    assert_eq!(last.is_nan(), end != End::Complete, "{text}: {last}");
                }
            }
        }
        let map = study.map().expect("a map").at(eps.to_f64());
        let mut columns: Vec<Vec<f64>> = at.iter().map(|x| vec![x.to_f64(); 3]).collect();
        columns[0][1] = f64::NAN;
        let mut columns: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
        let ends = map.follow_columns(&mut columns, &[], &[], steps).expect("columns that fit");
        assert_eq!(ends, [end, End::Range(0), end], "{text}");
    }
}

#[test]
fn indicators_of_a_start_that_is_not_a_number_are_not_numbers() {
    let study = Subject::text("xdot = y; ydot = x^2 - x;").study(&Systems).expect("a field");
    let map = study.map().expect("a map").at(0.05);
    let of = vec![Observable::Sali, Observable::Fli, Observable::Extrema, Observable::Lyapunov];
    let asked = Observe { observe: of, ..Observe::new(Rational::zero(), Vec::new(), 50) };
    let found = asked.of_orbits(&study, &[&map, &map], &[vec![f64::NAN, 0.25], vec![0.0, 0.0]], &|_| {
        ControlFlow::Continue(())
    });
    assert_eq!(found[0].end, End::Range(0));
    assert!(found[0].report.iter().all(|number| number.is_nan()), "{found:?}");
    assert!(found[1].end == End::Complete && found[1].report.iter().all(|number| number.is_finite()));
    let pole = Subject::text("xdot = x^2;").study(&Systems).expect("a field");
    let observed =
        Observe::new(number("1/2"), vec![number("1")], 9).ask(&pole, &Unwatched).expect("observations");
    assert_eq!(observed.end, End::Range(0));
    let observed = json!(observed);
    assert!(["sali", "fli", "megno"].iter().all(|name| observed[name].is_null()), "{observed}");
}

/// The orbit 3ⁿ exceeds the bound 10⁶ from n = 13 on.
#[test]
fn an_orbit_ends_where_it_escapes_from_a_bound_that_was_asked_for() {
    let study = Subject::text("xdot = x;").study(&Systems).expect("a field");
    let of = vec![Observable::Last, Observable::Escape];
    let at = vec![number("1")];
    let asked = Observe { observe: of, ..Observe::new(number("1/2"), at.clone(), 100) };
    let bound = Observe { escape: Some(1e6), ..asked.clone() };
    assert_eq!(bound.ask(&study, &Unwatched).expect("observations").end, End::Escaped(13));
    for (ended, step, last) in over(&study, bound, &[&at; 17]) {
        assert!((&*ended, step) == ("escaped", 13) && last.is_nan());
    }
    let observed = asked.ask(&study, &Unwatched).expect("observations");
    assert_eq!((observed.end, &json!(observed)["escaped"]), (End::Complete, &json!(13)));
}

/// After a transient, observations equal those of an orbit that starts where the transient ends.
#[test]
fn a_transient_is_not_observed() {
    let study = Subject::text("xdot = y; ydot = x^2 - x;").study(&Systems).expect("a field");
    let (eps, at) = (number("1/20"), vec![number("1/4"), number("0")]);
    let before = Orbit::new(eps.clone(), at.clone(), 40).ask(&study, &Unwatched).expect("an orbit");
    let settled = before.rows.values[2..].iter().map(|kept| match kept {
        StoredColumn::F64(list) => Rational::from_f64(list[40]).expect("a point"),
        other => panic!("{other:?}"),
    });
    let mut of = Observable::usual();
    of.push(Observable::Last);
    let plain = Observe { observe: of, ..Observe::new(eps, settled.collect(), 1000) };
    let late = Observe { at: at.clone(), transient: 40, ..plain.clone() };
    let [plain, mut found] = [&plain, &late].map(|asked| json!(asked.ask(&study, &Unwatched).expect("seen")));
    assert_eq!(found["steps"], 1040);
    (found["steps"], found["ended_step"]) = (json!(1000), json!(1000));
    assert_eq!(found, plain);
    for count in [1, 3] {
        let asked = Observe { observe: vec![Observable::Last, Observable::Sali], ..late.clone() };
        for (ended, step, last) in over(&study, asked, &vec![&at; count]) {
            assert!((&*ended, step) == ("complete", 1040) && plain["final"]["x"] == json!(last));
        }
    }
    let study = Subject::text("xdot = x;").study(&Systems).expect("a field");
    for (transient, bound, end) in
        [(10, None, End::Complete), (10, Some(1e6), End::Escaped(13)), (20, Some(1e6), End::Escaped(13))]
    {
        let asked =
            Observe { escape: bound, transient, ..Observe::new(number("1/2"), vec![number("1")], 100) };
        let asked = Observe { observe: vec![Observable::Escape], ..asked };
        let observed = asked.ask(&study, &Unwatched).expect("observations");
        assert_eq!((observed.end, &json!(observed)["escaped"]), (end, &json!(13)), "{transient} {bound:?}");
    }
}

#[test]
fn a_spectrum_may_have_its_first_exponents_alone() {
    let text = "xdot = 10*(y - x); ydot = x*(28 - z) - y; zdot = x*y - 8/3*z;";
    let study = Subject::text(text).study(&Systems).expect("a field");
    let at = vec![number("1"), number("1"), number("20")];
    let all = Observe {
        observe: vec![Observable::Last, Observable::Spectrum],
        transient: 2000,
        ..Observe::new(number("1/400"), at.clone(), 40_000)
    };
    let exponents = |asked: &Observe| -> Vec<f64> {
        let seen = json!(asked.ask(&study, &Unwatched).expect("exponents"));
        seen["spectrum"]
            .as_array()
            .expect("a list")
            .iter()
            .map(|one| one.as_f64().expect("a number"))
            .collect()
    };
    let whole = exponents(&all);
    assert!(whole.len() == 3 && (whole[0] - 0.9).abs() < 0.1, "{whole:?}");
    for count in [1, 2, 3, 7] {
        let some = Observe { spectrum: Some(count), ..all.clone() };
        let found = exponents(&some);
        assert_eq!(found.len(), count.min(3));
        let columns = some.columns(&study).len();
        assert_eq!(columns, 3 + found.len());
        assert!(found.iter().zip(&whole).all(|(a, b)| (a - b).abs() < 0.05), "{found:?} {whole:?}");
        let mut asked = Over::new(Question::Observe(some), Vec::<AxisOver>::new());
        asked.starts = vec![at.clone(); 3];
        let Answer::Over(cells) = study.ask(&Question::Over(asked), &Unwatched).expect("cells") else {
            unreachable!("the answer to this question")
        };
        let StoredColumn::F64(last) = cells.rows.values.last().expect("a column") else { panic!("numbers") };
        assert_eq!(last[2], found[found.len() - 1]);
    }
}

#[test]
fn exact_orbits_end_at_poles() {
    let study = Subject::text("xdot = x^2;").study(&Systems).expect("a field");
    let orbit = Orbit::new(number("1/20"), vec![number("1")], 11);
    let orbit = Orbit { scalar: kahan_study::numbers::ScalarKind::Exact, ..orbit };
    assert_eq!(orbit.ask(&study, &Unwatched).expect("an orbit").ending.end, End::Pole(9));
}
