//! Questions as JSON, subjects that are wrong, and answers under the names of the command's JSON.

use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};
use std::time::Duration;

use kahan_algebra::rational::Rational;
use kahan_algebra::syntax::ClaimKind;
use kahan_discover::report::MOST_READABLE;
use kahan_study::{
    Answer, End, Finding, Progress, Question, Show, Study, StudyError, Subject, Systems, Unwatched, Verify,
    Watch, from_toml, list,
};
use serde_json::{Value, json};

fn one() -> Rational {
    Rational::from(1)
}

fn study(subject: Subject) -> Study {
    subject.study(&Systems).expect("a subject")
}

fn question(object: Value) -> Result<Question, String> {
    serde_json::from_value(object).map_err(|mistake| mistake.to_string())
}

fn answer(study: &Study, object: Value) -> Value {
    let question = question(object).expect("a question");
    json!(study.ask(&question, &Unwatched).expect("an answer"))
}

#[test]
fn a_question_writes_itself_as_it_was_read() {
    for object in [
        json!({"ask": "show", "as": "latex", "jacobian": true}),
        json!({"ask": "evaluate", "eps": "1/2", "at": ["-2", "1", "1/3"], "scalar": "dd"}),
        json!({"ask": "heights", "eps": "9/14", "at": ["1/2", "5/3"], "steps": 12, "digits": 99, "seconds": 0.5}),
        json!({
            "ask": "orbit", "eps": "-1/10", "at": ["1"], "transient": 4, "steps": 9, "every": 3, "scalar": "f32", "order": 2, "method": "rk4",
            "projective": false, "reembed": false,
        }),
        json!({"ask": "observe", "eps": "1/10", "at": ["1"], "transient": 4, "steps": 9, "order": 4, "renormalize": 3, "spectrum": 2, "escape": 2.5, "reembed": false, "observe": ["final", "fli"]}),
        json!({
            "ask": "diagram", "eps": null, "at": ["1"], "over": {"eps": "1:0:/5"}, "variable": "x",
            "transient": 7, "steps": 3, "plane": null, "direction": "rising", "crossings": null, "order": 2, "carry": false,
            "reembed": false,
        }),
        json!({
            "ask": "periodic", "eps": null, "at": ["1", "1"], "period": 2, "free": "eps", "transient": 5, "hold": "none",
            "over": {"eps": "1:0:/5"},
        }),
        json!({
            "ask": "section", "eps": "1/10", "at": ["1", "0"], "steps": 9, "plane": "y - 1/2", "direction": "both", "crossings": 3,
            "transient": 5, "order": 4, "reembed": true,
        }),
        json!({
            "ask": "section", "eps": null, "at": [], "steps": null, "plane": "y - 1/2", "direction": "rising", "crossings": 3,
            "transient": 0, "order": 2, "reembed": false, "starts": [["1", "0"], ["1/2", "0"]], "params": {"a": ["1", "2"]},
            "over": {"eps": "1/10:1:3"}, "carry": true,
        }),
        json!({
            "ask": "heights", "steps": 5, "digits": 99,
            "over": {"x": "0:1:/9", "eps": ["1/10", "1/20"], "y": {"draw": "sobol", "low": "-1/2", "high": "1/2"}},
            "starts": [["1", "2/3"], ["0", "1"]], "draws": 7, "seed": 3,
        }),
        json!({
            "ask": "observe", "eps": "1/10", "at": ["1"], "transient": 0, "steps": 9, "order": 4, "renormalize": 3, "spectrum": null, "escape": null, "reembed": false,
            "observe": ["fli"], "over": {"scalar": ["f32", "f64"], "order": ["2", "8"]}, "starts": [], "draws": 1, "seed": 1,
        }),
        json!({"ask": "poles", "eps": null, "steps": 6, "seconds": 10.0}),
        json!({"ask": "discover", "eps": "1", "degree": 4, "seconds": 2.5}),
        json!({
            "ask": "scan", "eps": null, "over": {"xi": "-2:2:+1/12", "eps": "1:2:/4"},
            "degree": 3, "seconds": 1.0,
        }),
        json!({"ask": "trade", "at": ["1", "1/2"], "horizon": "50", "need": "integrals", "tolerance": "1/1000", "seconds": 1.0}),
        json!({"ask": "verify", "mutate": true}),
    ] {
        let read = question(object.clone()).expect("a question");
        assert_eq!(json!(read), object);
    }
}

#[test]
fn numbers_of_questions_are_exact() {
    let text = r#"{"ask": "evaluate", "eps": 0.1, "at": [1, "2/3", -0.3333333333333333333333333333]}"#;
    let Ok(Question::Evaluate(asked)) = serde_json::from_str(text) else { panic!("a question") };
    assert_eq!(asked.eps, Rational::new(1, 10));
    assert_eq!(asked.at[1], Rational::new(2, 3));
    assert_eq!(asked.at[2].to_string(), "-3333333333333333333333333333/10000000000000000000000000000");
}

#[test]
fn toml_says_what_json_says() {
    for (text, object) in [
        (
            "ask = 'evaluate'\neps = 0.1\nat = [+1, '2/3', -0.3333333333333333333333333333, 1e-400]",
            r#"{"ask": "evaluate", "eps": 0.1, "at": [1, "2/3", -0.3333333333333333333333333333, 1e-400]}"#,
        ),
        (
            "ask = 'scan'\ndegree = 0x3\nover = { xi = '-2:2:+1/12' }",
            r#"{"ask": "scan", "degree": 3, "over": {"xi": "-2:2:+1/12"}}"#,
        ),
        ("ask = 'verify'\nmutate = true", r#"{"ask": "verify", "mutate": true}"#),
    ] {
        let read: Question = from_toml(text).expect("a question");
        assert_eq!(read, serde_json::from_str(object).expect("a question"));
    }
    for (text, said) in [
        ("ask = 'evaluate'\neps = 1\nat = [1]\nepsilon = 1", "unknown field `epsilon`"),
        ("ask = 'poles'\nsteps = 'two'", "expected usize"),
        ("ask = 'poles'\nseconds = inf", "`inf` is no finite number"),
        ("ask = 'poles'\neps = 1979-05-27", "is a date"),
        ("ask = 'poles'\nsteps =", "line 2"),
    ] {
        let mistake = from_toml::<Question>(text).expect_err("a mistake");
        assert!(mistake.contains(said), "{text}: {mistake}");
    }
}

#[test]
fn subjects_read_themselves() {
    let read: Subject = from_toml("name = 'e7'\nparams = { xi = 0.1 }").expect("a subject");
    assert_eq!(study(read).values().expect("all values"), [Rational::new(1, 10)]);
    let read: Subject = serde_json::from_value(json!({"name": "toda", "sites": 3})).expect("a subject");
    assert_eq!(study(read).variables().len(), 6);
    let read = json!({"field": "xdot = a*x;", "params": {"a": "1/3"}});
    let read: Subject = serde_json::from_value(read).expect("a subject");
    assert_eq!(study(read).values().expect("all values"), [Rational::new(1, 3)]);
    for (object, said) in [
        (json!({"name": "e7", "field": "xdot = x;"}), "either `name` or `field`"),
        (json!({}), "either `name` or `field`"),
        (json!({"name": "e7", "parameters": {"xi": 1}}), "unknown field `parameters`"),
        (json!({"name": "e7", "params": {"xi": "one"}}), "`one` is not an exact number"),
    ] {
        let mistake = serde_json::from_value::<Subject>(object.clone()).expect_err("a mistake");
        assert!(mistake.to_string().contains(said), "{object}: {mistake}");
    }
}

#[test]
fn what_a_question_does_not_have_is_a_mistake() {
    for (object, said) in [
        (json!({"ask": "evaluate", "eps": 1, "at": [1], "epsilon": 1}), "unknown field `epsilon`"),
        (json!({"ask": "evaluate", "at": [1]}), "missing field `eps`"),
        (json!({"ask": "evaluate", "eps": "a half", "at": [1]}), "`a half` is not an exact number"),
        (json!({"ask": "evaluate", "eps": "1/0", "at": [1]}), "`1/0` divides by zero"),
        (json!({"ask": "evaluate", "eps": 1, "at": [1], "scalar": "f16"}), "unknown variant `f16`"),
        (json!({"ask": "scan", "over": {"xi": "0:1"}}), "over.xi: `0:1` is no range; write FROM:TO:COUNT"),
        (
            json!({"ask": "heights", "steps": 1, "eps": 1, "over": {"x": {"draw": "sobol", "low": 0}}}),
            "over.x: missing field `high`",
        ),
        (
            json!({"ask": "observe", "eps": 1, "steps": 1, "over": {"x": 1}, "observe": ["drifts"]}),
            "observe: unknown variant `drifts`",
        ),
        (json!({"ask": "weather"}), "unknown variant `weather`, expected one of `show`"),
        (json!({"eps": 1, "at": [1]}), "missing field `ask`"),
    ] {
        let mistake = question(object.clone()).expect_err("a mistake");
        assert!(mistake.contains(said), "{object}: {mistake}");
    }
}

#[test]
fn subjects_that_are_wrong_say_so() {
    let error = |subject: Subject| subject.study(&Systems).expect_err("a mistake");
    assert!(matches!(
        error(Subject::named("lorentz")),
        StudyError::UnknownSystem { nearest: Some("lorenz"), .. }
    ));
    assert!(matches!(error(Subject::text("xdot = x^3;")), StudyError::Field(_)));
    assert!(matches!(error(Subject::named("e6").with("xi", one())), StudyError::UnknownParameter { .. }));
    let twice = Subject::named("e7").with("xi", one()).with("xi", one());
    assert!(matches!(error(twice), StudyError::ParameterTwice { .. }));
    assert!(matches!(error(Subject::named("e6").sites(4)), StudyError::NoFamily));
    assert!(matches!(error(Subject::named("toda").sites(101)), StudyError::ManySites { sites: 101 }));
    assert_eq!(study(Subject::named("toda").sites(3)).variables().len(), 6);
}

#[test]
fn questions_that_do_not_fit_say_so() {
    let error = |subject: Subject, object: Value| {
        let question = question(object).expect("a question");
        study(subject).ask(&question, &Unwatched).expect_err("a mistake")
    };
    let evaluate = json!({"ask": "evaluate", "eps": 1, "at": [1, 2, 3]});
    assert!(matches!(
        error(Subject::named("e7"), evaluate.clone()),
        StudyError::MissingParameters { names, .. } if names == ["xi"]
    ));
    assert!(matches!(
        error(Subject::named("lv"), evaluate.clone()),
        StudyError::Coordinates { what: "at", given: 3, .. }
    ));
    let false_claim = Subject::text("xdot = y; ydot = -x; integral H = x;");
    assert!(matches!(
        error(false_claim, json!({"ask": "evaluate", "eps": 1, "at": [1, 2]})),
        StudyError::Field(_)
    ));
    let nowhere = Subject::text("xdot = x/a;").with("a", Rational::zero());
    assert!(matches!(
        error(nowhere, json!({"ask": "evaluate", "eps": 1, "at": [1]})),
        StudyError::UndefinedField { .. }
    ));
    let nowhere = Subject::text("xdot = x/(1 - eps^2);");
    for question in [
        json!({"ask": "evaluate", "eps": 1, "at": [1]}),
        json!({"ask": "orbit", "eps": 1, "at": [1], "steps": 1}),
        json!({"ask": "heights", "eps": 1, "at": [1], "steps": 1}),
    ] {
        let mistake = error(nowhere.clone(), question);
        assert!(mistake.to_string().contains("divides by zero at eps = 1;"), "{mistake}");
    }
    let trade = json!({"ask": "trade", "at": [1, 1], "horizon": 1});
    assert!(matches!(error(Subject::named("lv"), trade.clone()), StudyError::NoClock));
    let negative = json!({"ask": "trade", "at": [1, 1], "horizon": -1});
    assert!(matches!(error(Subject::named("lv"), negative), StudyError::NotPositive { what: "horizon", .. }));
    let observe = |rest: Value| {
        let mut object = json!({"ask": "observe", "eps": "1/10", "at": [1, 1], "steps": 9});
        object.as_object_mut().expect("an object").extend(rest.as_object().expect("an object").clone());
        object
    };
    let third = observe(json!({"order": 3}));
    assert!(matches!(error(Subject::named("lv"), third), StudyError::Order(3)));
    let never = observe(json!({"renormalize": 0}));
    assert!(matches!(
        error(Subject::named("lv"), never),
        StudyError::NotPositive { what: "renormalize", .. }
    ));
    let none = observe(json!({"spectrum": 0}));
    assert!(matches!(error(Subject::named("lv"), none), StudyError::NotPositive { what: "spectrum", .. }));
    for (far, said) in [
        (json!({"eps": "1e400"}), "eps is beyond the range of f64"),
        (json!({"at": [1, "-1e400"]}), "at: the coordinate y is beyond the range of f64"),
    ] {
        assert_eq!(error(Subject::named("lv"), observe(far)).to_string(), said);
    }
    let section = |plane: &str| json!({"ask": "section", "eps": 1, "at": [1, 1], "steps": 9, "plane": plane});
    assert!(matches!(
        error(Subject::named("lv"), section("x - z")),
        StudyError::Formula { what: "plane", .. }
    ));
    assert!(matches!(error(Subject::named("lv"), section("eps + 1")), StudyError::ConstantPlane { .. }));
    let scan = |axes: Value| json!({"ask": "scan", "over": axes});
    assert!(matches!(error(Subject::named("e7"), scan(json!({}))), StudyError::NoAxis));
    assert!(matches!(
        error(Subject::named("e7"), scan(json!({"zeta": "0:1:2"}))),
        StudyError::UnknownParameter { name, .. } if name == "zeta"
    ));
    let fixed = Subject::named("e7").with("xi", one());
    let twice = scan(json!({"xi": "0:1:2"}));
    assert!(matches!(error(fixed, twice), StudyError::ParameterTwice { .. }));
    let many = scan(json!({"xi": "0:1:100000", "eps": "1:2:100000"}));
    assert!(matches!(error(Subject::named("e7"), many), StudyError::ManyPoints { .. }));
    let too_high = json!({"ask": "discover", "degree": 1000});
    assert!(matches!(error(Subject::named("lv"), too_high), StudyError::Degree { asked: 1000, .. }));
    let collapse = json!({"ask": "discover", "eps": 0});
    assert!(matches!(error(Subject::named("lv"), collapse), StudyError::Discover { .. }));
}

/// E1 at x = −2, ε = 1/2: 1 + εx = 0 is a removable pole.
#[test]
fn every_object_at_a_point() {
    let e1 = study(Subject::named("e1"));
    let values = answer(&e1, json!({"ask": "evaluate", "eps": "1/2", "at": [-2, 1, "1/3"]}));
    assert_eq!(values["det_A"], "0");
    assert!(values["x_next"].is_array() && values["integrals"]["H"].is_string(), "{values}");
    let names: Vec<&String> = values.as_object().expect("an object").keys().collect();
    assert_eq!(names[..5], ["system", "variables", "parameters", "eps", "x"]);
    let float = answer(&e1, json!({"ask": "evaluate", "eps": "1/2", "at": [1, 1, 1], "scalar": "f64"}));
    assert!(float["x_next"][0].is_f64(), "{float}");
}

#[test]
fn heights_and_poles_of_the_lotka_volterra_map() {
    let lv = study(Subject::named("lv"));
    let heights = answer(&lv, json!({"ask": "heights", "eps": "9/14", "at": ["1/2", "5/3"], "steps": 9}));
    assert_eq!((&heights["growth"], &heights["steps"]), (&json!("exponential"), &json!(9)));
    assert_eq!(heights["log_heights"]["x"].as_array().map(Vec::len), Some(9));
    assert_eq!(heights["seconds"], Value::Null, "without a clock");
    let poles = answer(&lv, json!({"ask": "poles", "steps": 4}));
    assert!(poles["patterns"].as_array().is_some_and(|patterns| !patterns.is_empty()), "{poles}");
}

/// ẋ = x² + 1 reaches a pole of the flow; rotations about the fixed point of x″ = −x take 2π a
/// turn.
#[test]
fn what_orbits_do() {
    let away = study(Subject::text("xdot = x^2 + 1;"));
    let observed =
        answer(&away, json!({"ask": "observe", "eps": "1/20", "at": [0], "steps": 100, "escape": 5}));
    assert!(observed["escaped"].as_u64().is_some_and(|step| step < 20), "{observed}");
    let turning = study(Subject::text("xdot = y; ydot = -x; integral E = x^2 + y^2;"));
    let asked = json!({"ask": "observe", "eps": "1/20", "at": [1, 0], "steps": 10_000});
    let observed = answer(&turning, asked.clone());
    // tan of half the angle of a step is ε.
    let turns = 0.05_f64.atan() / std::f64::consts::PI;
    // Backwards, as the phase of x and its rate goes. A weighted mean over 10⁴ steps rounds as
    // often.
    let value = observed["rotation"]["x"]["value"].as_f64().expect("a number");
    assert!((value + turns).abs() < 1e4 * f64::EPSILON * turns, "{observed}");
    assert!(observed["drift"]["E"]["max"].as_f64().is_some_and(|drift| drift < 1e-11), "{observed}");
    assert_eq!(observed["extrema"]["y"].as_array().map(Vec::len), Some(2));
    let stopped =
        Listening { clock: Clock::default(), heard: Mutex::new(vec![String::new()]), stops_at_first: true };
    let Ok(Answer::Observe(part)) = turning.ask(&question(asked).expect("a question"), &stopped) else {
        panic!("observations")
    };
    assert!(matches!(part.end, End::Stopped(steps) if steps == part.steps && steps < 10_000));
}

#[test]
fn special_values_of_a_parameter() {
    let e9 = study(Subject::named("e9"));
    let asked = json!({"ask": "scan", "over": {"xi": "-1:1:+1"}, "degree": 2});
    let found = answer(&e9, asked);
    assert_eq!(found["points"].as_array().map(Vec::len), Some(3));
    let special = found["special"].as_array().expect("points");
    assert!(special.iter().any(|point| point["xi"] == "1"), "{found}");
}

/// ẋ = y, ẏ = −x turns clockwise: y rises through 0 at x = −1.
#[test]
fn crossings_of_a_plane() {
    let turning = study(Subject::text("xdot = y; ydot = -x;"));
    let asked =
        json!({"ask": "section", "eps": "1/100", "at": [1, "1/2"], "steps": 1000, "plane": "y", "points": 2});
    let found = answer(&turning, asked);
    let points = found["points"].as_array().expect("points");
    assert_eq!((points.len(), found["times"].as_array().map(Vec::len)), (2, Some(2)));
    let x = points[0][0].as_f64().expect("a number");
    // The map keeps x² + y², and the crossing lies on its curve.
    assert!((x + 1.25_f64.sqrt()).abs() < 1e-3, "{found}");
}

/// The fixed point of the Lotka-Volterra map at (1, 1), and the fold of x = ±√a at a = 0.
#[test]
fn cycles_and_their_branches() {
    let lv = study(Subject::named("lv"));
    let found = answer(&lv, json!({"ask": "periodic", "eps": "1/10", "at": ["0.9", "1.1"]}));
    assert_eq!((&found["period"], &found["stability"]), (&json!(1), &json!("neutral")));
    assert_eq!(found["exact"]["points"], json!([["1", "1"]]));
    assert!(found.get("branch").is_none(), "{found}");
    let fold = study(Subject::text("xdot = a - x^2;"));
    let over = json!({"a": "1:-1:41"});
    let found = answer(&fold, json!({"ask": "periodic", "eps": "1/10", "at": [1], "over": over}));
    assert_eq!(found["branch"]["turns"][0]["change"], "fold, two steady states meet");
    let error =
        |object: Value| fold.ask(&question(object).expect("a question"), &Unwatched).expect_err("a mistake");
    let other = json!({"b": "1:-1:41"});
    assert!(matches!(
        error(json!({"ask": "periodic", "eps": 1, "at": [1], "over": other})),
        StudyError::UnknownAxis { .. }
    ));
    assert!(matches!(
        error(json!({"ask": "periodic", "at": [1], "period": 2, "over": over})),
        StudyError::MissingStep
    ));
    assert!(matches!(
        error(json!({"ask": "periodic", "eps": 1, "at": [1], "period": 601, "over": over})),
        StudyError::LongCycle { .. }
    ));
}

/// A clock of the test's own: a microsecond passes each time that it is read.
#[derive(Default)]
struct Clock(AtomicU64);

impl Clock {
    fn read(&self) -> Duration {
        Duration::from_micros(self.0.fetch_add(1, Ordering::Relaxed))
    }
}

/// A clock, and what was heard.
struct Listening {
    clock: Clock,
    heard: Mutex<Vec<String>>,
    stops_at_first: bool,
}

impl Watch for Listening {
    fn now(&self) -> Option<Duration> {
        Some(self.clock.read())
    }

    fn look(&self, _: &Progress<'_>) -> ControlFlow<()> {
        let heard = self.heard.lock().expect("no listener fails");
        if self.stops_at_first && !heard.is_empty() {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    fn found(&self, finding: &Finding) {
        self.heard.lock().expect("no listener fails").push(finding.text.clone());
    }
}

#[test]
fn findings_are_told_when_they_are_proved() {
    let e6 = study(Subject::named("e6"));
    for stops_at_first in [false, true] {
        let watch = Listening { clock: Clock::default(), heard: Mutex::default(), stops_at_first };
        let asked = question(json!({"ask": "discover", "degree": 2})).expect("a question");
        let Ok(Answer::Discover(found)) = e6.ask(&asked, &watch) else { panic!("a report") };
        let heard = watch.heard.into_inner().expect("no listener fails");
        let claims: Vec<&str> = found.claims().map(|(text, _)| text).collect();
        assert!(heard.iter().all(|text| claims.contains(&text.as_str())), "{heard:?} of {claims:?}");
        // Once it is told to stop, the search says no more.
        assert_eq!(heard.len(), if stops_at_first { 1 } else { claims.len() });
        assert_eq!(found.report.out_of_time, stops_at_first);
    }
}

/// A clock, and a `Break` at every look; that the watch is asked again after it is a mistake.
struct Ending {
    clock: Clock,
    looks: AtomicU32,
}

impl Watch for Ending {
    fn now(&self) -> Option<Duration> {
        Some(self.clock.read())
    }

    fn look(&self, _: &Progress<'_>) -> ControlFlow<()> {
        self.looks.fetch_add(1, Ordering::Relaxed);
        ControlFlow::Break(())
    }
}

#[test]
fn a_question_that_was_stopped_asks_no_more() {
    let lv = study(Subject::named("lv"));
    let over = json!({"eps": "1/10:1:9"});
    for object in [
        json!({"ask": "orbit", "eps": "1/10", "at": [1, 2], "steps": 100_000}),
        json!({"ask": "observe", "eps": "1/10", "at": [1, 2], "steps": 100_000}),
        json!({"ask": "section", "eps": "1/10", "at": [1, 2], "steps": 100_000, "plane": "x - y"}),
        json!({"ask": "periodic", "at": [1, 1], "over": over}),
        json!({"ask": "heights", "eps": "9/14", "at": ["1/2", "5/3"], "steps": 9}),
        json!({"ask": "poles"}),
        json!({"ask": "discover"}),
        json!({"ask": "scan", "over": over}),
        json!({"ask": "trade", "at": [1, 2], "horizon": 5}),
    ] {
        let watch = Ending { clock: Clock::default(), looks: AtomicU32::new(0) };
        lv.ask(&question(object.clone()).expect("a question"), &watch).expect("what is known by then");
        assert_eq!(watch.looks.into_inner(), 1, "{object}");
    }
}

#[test]
fn what_is_found_can_be_claimed() {
    let asked = question(json!({"ask": "discover", "degree": 2})).expect("a question");
    let Ok(Answer::Discover(found)) = study(Subject::named("e6")).ask(&asked, &Unwatched) else {
        panic!("a report")
    };
    let claimed = found.claimed();
    assert_eq!(claimed.claims.len(), found.claims().count());
}

/// The second flow of Clebsch's system has a density of some 40 000 characters.
#[test]
fn long_claims_are_not_for_people_to_read() {
    let clebsch = "m1dot = (w3 - w2)*(m2*m3 - w1*p2*p3); m2dot = (w1 - w3)*(m3*m1 - w2*p3*p1); \
        m3dot = (w2 - w1)*(m1*m2 - w3*p1*p2); p1dot = w3*p2*m3 - w2*p3*m2; \
        p2dot = w1*p3*m1 - w3*p1*m3; p3dot = w2*p1*m2 - w1*p2*m1;";
    let asked = question(json!({"ask": "discover"})).expect("a question");
    let Ok(Answer::Discover(found)) = study(Subject::text(clebsch)).ask(&asked, &Unwatched) else {
        panic!("a report")
    };
    let [density] = &found.report.densities[..] else { panic!("a density") };
    assert!(density.text.len() > MOST_READABLE, "{}", density.text.len());
    assert!(found.claims().any(|(text, _)| text == density.text));
    let readable = found.readable();
    assert!(readable.claims.iter().all(|claim| claim.kind != ClaimKind::Density));
    let said = format!("Its formula has {} characters", density.text.len());
    assert!(found.report.sentences.iter().any(|sentence| sentence.contains(&said)));
}

#[test]
fn formulas_come_one_by_one_in_every_notation() {
    let swing = study(Subject::text("struct Swing { lambda } xdot = lambda*y; ydot = -x^2/2;"));
    let shown = |form: &str| answer(&swing, json!({"ask": "show", "as": form}));
    assert_eq!(shown("text")["A"], json!([["1", "-eps*lambda"], ["eps*x", "1"]]));
    assert_eq!(shown("latex")["A"][0][1], "-\\varepsilon \\lambda");
    let sympy = shown("sympy");
    assert_eq!(sympy["field"], json!(["lambda_*y", "-1/2*x**2"]));
    assert_eq!(sympy["bilinear"][1], "-1/2*x*x_prime");
    let moved = "x + 2*eps*(lambda_*y - 1/2*eps*lambda_*x**2)/(1 + eps**2*lambda_*x)";
    assert_eq!(sympy["map"][0], moved);
    let script = sympy["script"].as_str().expect("a script");
    assert!(script.contains(&format!("\nmap = Matrix(sympify([\n    [\"{moved}\"],\n")), "{script}");
    assert!(script.contains("\nparameters = [Symbol(name) for name in [\"lambda_\"]]\n"), "{script}");
    assert_eq!(shown("text").get("script"), None);
    assert_eq!(shown("kahan")["macro"], shown("text")["macro"]);
    assert_eq!(shown("plan")["objects"][0]["object"], "field f");
    assert_eq!(shown("plan")["derive_ms"], Value::Null);

    let claimed = "xdot = lambda*y; ydot = -x/2; integral H = x^2 + 2*lambda*y^2 when lambda = 1;";
    let claimed = study(Subject::text(claimed));
    let claim = |form: &str| answer(&claimed, json!({"ask": "show", "as": form}))["claims"][0].clone();
    assert_eq!(claim("text")["when"], "lambda = 1");
    assert_eq!(claim("text")["equations"], json!([["H", "x^2 + 2*lambda*y^2"]]));
    assert_eq!(claim("sympy")["equations"], json!([["H", "x**2 + 2*lambda_*y**2"]]));
    assert_eq!(claim("latex")["condition"], "\\lambda = 1");
}

#[test]
fn parameters_are_put_in_before_the_map_is_reduced() {
    let shown = |subject: Subject| answer(&study(subject), json!({"ask": "show"}));
    let put_in = shown(Subject::named("e9").with("xi", Rational::from(1)));
    assert_eq!(put_in["parameters"], json!([]));
    assert_eq!(put_in["map"], shown(Subject::named("e3"))["map"]);
    let nowhere = study(Subject::text("xdot = x/(a - b);").with("a", one()).with("b", one()));
    let error = nowhere.ask(&Question::Show(Show::default()), &Unwatched).expect_err("a mistake");
    assert!(error.to_string().contains("divides by zero at a = 1, b = 1"), "{error}");
}

#[test]
fn a_catalog_lists_itself() {
    let listed = json!(list(&Systems).expect("the catalog has no mistake"));
    let of = |key: &str, name: &str| {
        let all = listed[key].as_array().expect("a list").iter();
        all.clone().find(|one| one["name"] == name).cloned().expect("it is there")
    };
    let e9 = of("systems", "e9");
    assert_eq!([&e9["type"], &e9["variables"]], [&json!("E9"), &json!(["x", "y", "z"])]);
    assert_eq!([&e9["parameters"], &e9["claims"][0]], [&json!(["xi"]), &json!("rho")]);
    let species = of("families", "species");
    assert_eq!([&species["arrays"], &species["parameters"]], [&json!(["n"]), &json!(["mu", "r[i]"])]);
}

#[test]
fn an_orbit_diagram_shows_what_is_left_after_the_transient() {
    // A sink at a, whatever a is; with ε = 1/10 the distance from it falls to 9/11 in a step.
    let sink = study(Subject::text("xdot = a - x; ydot = -y;"));
    let asked = json!({
        "ask": "diagram", "eps": "1/10", "at": [7, 1], "over": {"a": "0:2:3"},
        "transient": 400, "steps": 2,
    });
    let found = answer(&sink, asked.clone());
    assert_eq!(found["values"], json!(["0", "1", "2"]));
    assert_eq!([&found["variable"], &found["axis"]], [&json!("x"), &json!("a")]);
    assert_eq!(found["ended"], 0);
    assert!(found["points"][2].as_array().is_some_and(|points| points.len() == 3), "{found}");
    assert!((found["points"][2][0].as_f64().expect("a number") - 2.0).abs() < 1e-14, "{found}");
    let of = |changed: &str, value: Value| {
        let mut asked = asked.clone();
        asked[changed] = value;
        question(asked).map(|asked| sink.ask(&asked, &Unwatched).map(|answer| json!(answer)))
    };
    let short = of("transient", json!(0)).expect("a question").expect("an answer");
    let exact = [7.0, 2.0 + 5.0 * 9.0 / 11.0, 2.0 + 5.0 * 81.0 / 121.0];
    for (i, x) in exact.into_iter().enumerate() {
        let shown = short["points"][2][i].as_f64().expect("a number");
        assert!((shown - x).abs() < 1e-14, "{short}");
    }
    let y = of("variable", json!("y")).expect("a question").expect("an answer");
    assert!(y["points"][0][0].as_f64().is_some_and(|y| y > 0.0 && y < 1e-30), "{y}");
    for (changed, value, said) in [
        ("variable", json!("q"), "`q` is no variable of field; there is x, y"),
        ("over", json!({"b": "0:1:3"}), "`b` is no parameter of field; there is a, eps"),
    ] {
        let refused = of(changed, value).expect("a question").expect_err("a mistake");
        assert_eq!(refused.to_string(), said);
    }
    let over_eps = of("over", json!({"eps": "1/10:1/5:2"})).expect("a question");
    assert!(over_eps.is_err_and(|error| matches!(error, StudyError::MissingParameters { .. })));
}

#[test]
fn claims_of_a_field_hold_or_not() {
    let field =
        "xdot = a*y; ydot = -a*x; integral H = x^2 + y^2; integral L = x when a = 0; integral Z = a*x*y;";
    let verdicts = |subject: Subject| answer(&study(subject), json!({"ask": "verify"}));
    let of_field = verdicts(Subject::text(field));
    let outcomes: Vec<&Value> =
        of_field["claims"].as_array().expect("a list").iter().map(|claim| &claim["outcome"]).collect();
    assert_eq!(json!([outcomes, of_field["failed"]]), json!([["proved", "proved", "failed"], 1]));
    assert_eq!(of_field["claims"][0]["id"], "field.H");
    assert_eq!(of_field["claims"][0]["detail"], "by normal forms over Q, and modulo primes");
    // What does not fit the values of parameters is gone.
    let put_in = verdicts(Subject::text(field).with("a", one()));
    assert_eq!(put_in["claims"].as_array().map(Vec::len), Some(2));
    // Of a system of the catalog as it stands the paper's claims are meant.
    assert_eq!(verdicts(Subject::named("e9").with("xi", one()))["claims"][1]["id"], "e9.H3");
    let of_paper = verdicts(Subject::named("lagrange"));
    assert_eq!([&of_paper["failed"], &of_paper["claims"][0]["system"]], [&json!(0), &json!("lagrange")]);
}

#[test]
fn a_claim_that_is_changed_fails() {
    let mutate = Verify { mutate: true };
    let swing = |claim: &str| study(Subject::text(format!("xdot = y; ydot = -x; {claim}")));
    let mutated = json!(mutate.ask(&swing("integral H = x^2 + y^2;"), &Unwatched).expect("an answer"));
    assert_eq!(mutated["survived"], 0);
    assert_eq!(mutated["mutations"][0]["id"], "field.H");
    assert!(matches!(mutate.ask(&swing("integral H = x;"), &Unwatched), Err(StudyError::Field(_))));
}
