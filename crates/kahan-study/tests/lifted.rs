//! Tests points of lifted fields, and errors of the relations between new and original variables.

use kahan_algebra::rational::Rational;
use kahan_study::{
    Axis, AxisOver, LiftCriterion, Lifting, Observable, Observe, Orbit, Over, Question, Range, RelationFate,
    Study, StudyError, Subject, Systems, Unwatched,
};

const PENDULUM: &str = "xdot = v; vdot = -g*sin(x);";

fn lifted(text: &str, values: &[(&str, i64)]) -> Study {
    let subject = Subject::text(text).lifted(LiftCriterion::Automatic);
    let subject = values.iter().fold(subject, |subject, (name, value)| subject.with(*name, (*value).into()));
    subject.study(&Systems).expect("a field that is lifted")
}

fn rational(numbers: &[(i64, i64)]) -> Vec<Rational> {
    numbers.iter().map(|(above, below)| Rational::new(*above, *below)).collect()
}

#[test]
fn an_orbit_shows_the_original_variables_and_what_is_kept() {
    let study = lifted(PENDULUM, &[("g", 2)]);
    let asked = Orbit::new(Rational::new(1, 20), rational(&[(1, 1), (0, 1)]), 50);
    let found = asked.ask(&study, &Unwatched).expect("an orbit");
    let columns: Vec<&str> = found.head.columns.iter().map(|column| column.name.as_str()).collect();
    assert_eq!(columns, ["n", "t", "x", "v", "energy", "R1"]);
    assert_eq!(found.head.variables, ["x", "v"]);
    assert!(study.proved().is_ok());
    assert_eq!(study.point(&asked.at).unwrap()[2].to_f64(), libm::sin(1.0));
    let all = rational(&[(1, 1), (0, 1), (3, 5), (4, 5)]);
    assert_eq!(study.point(&all).unwrap(), all);
    let one = study.point(&all[..1]);
    assert!(matches!(one, Err(StudyError::Coordinates { given: 1, .. })), "{one:?}");
}

#[test]
fn rational_lifts_embed_exactly() {
    let study = lifted("xdot = -x/(3 + x);", &[]);
    let point = study.point(&rational(&[(1, 3)])).unwrap();
    let new: Vec<&str> = study.variables()[1..].iter().map(String::as_str).collect();
    assert!(!new.is_empty());
    // At x = 1/3, the new variables are powers of 1/(3 + x) = 3/10, which is not a float.
    let powers: Vec<Rational> = (1..4).map(|k| Rational::new(3_i64.pow(k), 10_i64.pow(k))).collect();
    assert!(point[1..].iter().all(|value| powers.contains(value)), "{new:?}: {point:?}");
}

#[test]
fn parameters_that_go_through_values_go_into_the_embedding() {
    let study = lifted("xdot = v; vdot = -sin(k*x);", &[]);
    let starts = rational(&[(1, 1), (0, 1)]);
    let of = vec![Observable::Last];
    let asked = Observe { observe: of, ..Observe::new(Rational::new(1, 20), starts.clone(), 10) };
    let axis = AxisOver::from(Axis { name: "k".to_owned(), range: Range::read("1:2:2").expect("a range") });
    let over = Over::new(Question::Observe(asked), vec![axis]);
    let found = over.ask(&study, &Unwatched).expect("cells");
    let name = found.columns.iter().position(|name| name == "final_x").expect("a column");
    assert!(!found.columns.iter().any(|name| name.contains("sin")), "{:?}", found.columns);
    for (row, k) in [1, 2].into_iter().enumerate() {
        let own = lifted("xdot = v; vdot = -sin(k*x);", &[("k", k)]);
        let orbit = Orbit::new(Rational::new(1, 20), starts.clone(), 10).ask(&own, &Unwatched).unwrap();
        let last = orbit.rows.values[2].values().cell(10).to_string();
        assert_eq!(found.rows.values[name].values().cell(row).to_string(), last, "k = {k}");
    }
}

#[test]
fn relations_drift_where_a_potential_is_singular() {
    let fates = |text: &str, start: &[(i64, i64)]| {
        let lifting = Lifting { start: Some(rational(start)), ..Lifting::default() };
        let study = Subject::text(text).lifting(lifting).study(&Systems).expect("a lift");
        let found = study.lift_found(None).expect("a start").expect("a lift");
        found.relations.iter().map(|relation| relation.along.expect("a start")).collect::<Vec<_>>()
    };
    assert_eq!(
        fates("xdot = v; vdot = -sin(x);", &[(1, 1), (0, 1)]),
        [RelationFate::Kept, RelationFate::Bounded, RelationFate::Bounded]
    );
    let kepler = "xdot = u; ydot = v; udot = -x/(x^2 + y^2)^(3/2); vdot = -y/(x^2 + y^2)^(3/2);";
    assert!(fates(kepler, &[(1, 1), (0, 1), (0, 1), (11, 10)]).contains(&RelationFate::Drifts));
}

#[test]
fn a_subject_says_in_json_that_it_is_lifted() {
    let read = |text: &str| serde_json::from_str::<Subject>(text);
    let subject = read(r#"{"field": "xdot = sin(x);", "lift": "smallest"}"#).expect("a subject");
    assert_eq!(subject.study(&Systems).unwrap().coordinates(), ["x"]);
    assert!(read(r#"{"field": "xdot = sin(x);", "lift": "least"}"#).is_err());
    assert!(Subject::text("xdot = sin(x);").study(&Systems).is_err());
}

#[test]
fn claims_of_the_text_are_those_of_the_lift() {
    let claimed = "integral H = v^2/2 - g*cos_x - eps^2*g^2*sin_x^2/2;";
    let study = lifted(&format!("{PENDULUM} {claimed}"), &[]);
    assert!(study.proved().is_ok());
    assert_eq!(study.system().claims.len(), 3);
    let wrong = lifted(&format!("{PENDULUM} integral H = v^2/2 - g*cos_x;"), &[]);
    assert!(matches!(wrong.proved(), Err(StudyError::Field(_))));
    let lv = Subject::named("lv").lifted(LiftCriterion::Automatic).study(&Systems).unwrap();
    assert_eq!(lv.text(), Subject::named("lv").study(&Systems).unwrap().text());
}

#[test]
fn relations_have_errors_along_an_orbit() {
    let study = lifted(PENDULUM, &[("g", 1)]);
    let errors = |eps: (i64, i64), steps: u64| {
        let start = rational(&[(1, 1), (0, 1)]);
        study.relation_errors(&start, &Rational::new(eps.0, eps.1), steps, 8).expect("an orbit")
    };
    let (coarse, fine) = (errors((1, 20), 800), errors((1, 40), 1600));
    assert_eq!((coarse.errors.len(), coarse.steps), (3, 800));
    for (coarse, fine) in coarse.errors.iter().zip(&fine.errors) {
        assert_eq!(coarse.len(), 8);
        let most = |errors: &[f64]| errors.iter().copied().fold(0.0, f64::max);
        let ratio = most(coarse) / most(fine);
        assert!((3.5..4.5).contains(&ratio), "{coarse:?} {fine:?}");
        assert!(coarse[7] < 1.5 * coarse[0], "{coarse:?}");
    }
    let few = errors((1, 20), 1);
    assert!(few.errors.iter().all(|errors| errors.len() == 5 && errors[3] < 1e-15 && errors[4] > 1e-6));
    let none = Subject::named("lv").study(&Systems).unwrap();
    assert!(none.relation_errors(&[], &Rational::one(), 1, 1).unwrap().errors.is_empty());
}

#[test]
fn a_lift_to_show_is_chosen_along_an_orbit() {
    let neuron = "v' = v - v^3/3 - w + 1/2, w' = (v + 0.7 - 0.8*w)*0.08";
    let subject = Subject::text(neuron).lifted(LiftCriterion::Automatic);
    let fates = |study: Study| study.lift_found(None).unwrap().expect("a lift").relations[0].along;
    assert_eq!(fates(subject.study(&Systems).unwrap()), None);
    let study = subject.study_to_show(&Systems).unwrap();
    assert_eq!(study.lift_start(), Some(rational(&[(1, 1), (1, 2)])));
    assert_eq!(fates(study), Some(RelationFate::Decays));
    // If the text gives a start, lifts are compared along the orbit from this start.
    let begun = Subject::text(format!("{neuron}\ninit v=1, w=0")).lifted(LiftCriterion::Automatic);
    assert_eq!(begun.study_to_show(&Systems).unwrap().lift_start(), Some(rational(&[(1, 1), (0, 1)])));
    let generic = Subject::text(PENDULUM).lifted(LiftCriterion::Automatic).study_to_show(&Systems).unwrap();
    assert_eq!(generic.lift_start(), None);
}

#[test]
fn a_lift_to_show_begins_where_the_original_orbit_stays() {
    for (text, largest, smallest, error) in [
        ("x' = -x + tanh(y), y' = -y + tanh(2*x) + 1/10", 0.25, 0.01, 0.11),
        ("xdot = u; ydot = v; udot = -x/(x^2 + y^2)^(3/2); vdot = -y/(x^2 + y^2)^(3/2);", 0.05, 0.0009, 4.0),
        (PENDULUM, 0.25, 0.05, 0.11),
    ] {
        let subject = Subject::text(text).lifted(LiftCriterion::Automatic);
        let subject = if text == PENDULUM { subject.with("g", 1.into()) } else { subject };
        let study = subject.study_to_show(&Systems).unwrap();
        let start = study.lift_start().expect("an orbit");
        let shown = study.shown_orbit(None, Some(&start)).unwrap();
        let eps = shown.eps.to_f64();
        assert!(shown.stays && (smallest..largest).contains(&eps), "{text}: {shown:?}");
        assert_eq!(start[0], Rational::one(), "{text}");
        let seen = study.relation_errors(&start, &shown.eps, 4000, 1).unwrap();
        assert!(seen.errors.iter().all(|errors| errors[0] < error), "{text}: {seen:?}");
        assert!(study.lift().unwrap().warning().is_none(), "{text}");
    }
}

#[test]
fn what_is_not_quadratic_calls_for_a_lift() {
    for (text, calls) in [
        (PENDULUM, true),
        ("x'' = -x/(x^2 + y^2)^(3/2), y'' = -y/(x^2 + y^2)^(3/2)", true),
        ("xdot = x - x^3;", true),
        ("xdot = x^2;", false),
        ("xdot = abs(x);", false),
        ("xdot = sin(x", false),
        ("xdot = x*y*;", false),
        ("xdot = y; ydot = -x; integral H = x;", false),
    ] {
        assert_eq!(Subject::text(text).calls_for_a_lift(), calls, "{text}");
    }
    assert!(!Subject::text(PENDULUM).lifted(LiftCriterion::Automatic).calls_for_a_lift());
    assert!(!Subject::named("lv").calls_for_a_lift());
}
