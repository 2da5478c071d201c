//! Reads questions and subjects from text, and reports their mistakes.

use kahan_algebra::rational::Rational;
use kahan_study::{Question, StudyError, Subject, Systems, Unwatched, from_toml};
use serde_json::{Value, json};

use super::{one, question, study};

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
