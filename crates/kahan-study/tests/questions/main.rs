//! Questions as JSON: wrong subjects are refused, and answers use the names of the command's JSON.

mod claims;
mod cycles;
mod orbits;
mod reading;
mod watched;

use std::ops::ControlFlow;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use kahan_algebra::rational::Rational;
use kahan_study::{Finding, Progress, Question, Study, Subject, Systems, Unwatched, Watch, list};
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

/// A clock that advances by a microsecond at each reading.
#[derive(Default)]
struct Clock(AtomicU64);

impl Clock {
    fn read(&self) -> Duration {
        Duration::from_micros(self.0.fetch_add(1, Ordering::Relaxed))
    }
}

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

/// E1 with ε = 1/2 has a removable pole at x = −2, where 1 + εx = 0.
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

#[test]
fn special_values_of_a_parameter() {
    let e9 = study(Subject::named("e9"));
    let asked = json!({"ask": "scan", "over": {"xi": "-1:1:+1"}, "degree": 2});
    let found = answer(&e9, asked);
    assert_eq!(found["points"].as_array().map(Vec::len), Some(3));
    let special = found["special"].as_array().expect("points");
    assert!(special.iter().any(|point| point["xi"] == "1"), "{found}");
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
