//! Tests the Pareto front, the choice and the refusals of `kahan trade`.

mod edges;

use kahan_algebra::rational::Rational;
use kahan_core::prelude::*;
use kahan_core::{Composition, Dd, ThroughF64};
use kahan_study::reference::{Reference, Trajectory, TrajectoryLimits};
use kahan_systems::E6;
use serde_json::Value;

#[cfg(unix)]
use crate::running::shell;
use crate::running::{answer, kahan, refusal};

fn json(arguments: &[&str]) -> Value {
    let output = kahan(&[arguments, &["--json"]].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("one JSON object")
}

fn number(object: &Value, key: &str) -> f64 {
    object[key].as_f64().unwrap_or_else(|| panic!("{key} in {object}"))
}

/// Computes ε from the time span and the number of steps, because JSON may round ε itself.
fn eps_of(setting: &Value, horizon: f64) -> f64 {
    let eps = horizon / (2.0 * number(setting, "steps"));
    match setting["scalar"].as_str() {
        Some("f64" | "dd") => eps,
        _ => f64::from(eps as f32),
    }
}

/// Returns the error with this key, or infinity if the error is `null`.
fn error(setting: &Value, key: &str) -> f64 {
    setting[key].as_f64().unwrap_or(f64::INFINITY)
}

const E6_SCENE: [&str; 8] = ["trade", "e6", "--at", "1,1/2,1/3", "--horizon", "3", "--seconds", "60"];

fn settings(object: &Value) -> &Vec<Value> {
    object["settings"].as_array().expect("settings")
}

#[test]
fn every_setting_has_the_keys_and_the_front_is_a_front() {
    let object = json(&[&E6_SCENE[..], &["--tolerance", "1e-6"]].concat());
    for key in ["system", "need", "tolerance", "scale", "reference", "timing", "settings", "choice"] {
        assert!(object.get(key).is_some(), "{key}");
    }
    assert_eq!(object["timing"], "measured");
    assert_eq!(object["reference"]["second_method"], "closed solution");
    let settings = settings(&object);
    assert!(settings.len() > 8, "{} settings", settings.len());
    for setting in settings {
        for key in ["scalar", "order", "compensated", "eps", "integral_drift", "return_error"] {
            assert!(setting.get(key).is_some(), "{key} in {setting}");
        }
        assert!(number(setting, "nanoseconds_per_unit_time") > 0.0);
        let eps = number(setting, "eps");
        assert!(
            (eps - eps_of(setting, 3.0)).abs() <= 4.0 * f64::EPSILON * eps,
            "an eps that meets the horizon: {setting}"
        );
    }
    let (price, miss) =
        (|s: &Value| number(s, "nanoseconds_per_unit_time"), |s: &Value| error(s, "trajectory_error"));
    for setting in settings {
        let beats = |other: &&Value| {
            (price(other) < price(setting) && miss(other) <= miss(setting))
                || (price(other) <= price(setting) && miss(other) < miss(setting))
        };
        let is_beaten = settings.iter().any(|other| beats(&other)) || miss(setting).is_infinite();
        assert_eq!(setting["on_front"], !is_beaten, "{setting}");
    }
    let choice = &object["choice"];
    assert!(miss(choice) <= 1e-6);
    let cheaper = settings.iter().filter(|other| price(other) < price(choice));
    assert!(cheaper.map(miss).all(|miss| miss > 1e-6), "a cheaper setting does too");
}

/// Returns the largest relative distance of the setting's orbit from the trajectory.
fn error_of(setting: &Value, horizon: f64) -> f64 {
    let start = ["1", "1/2", "1/3"].map(|text| Rational::parse(text).expect("a number").to_big());
    let asked =
        Trajectory { command: "e6", parameters: &[], start: &start, end: 1.01 * horizon, allowed: 1e-24 };
    let reference = Reference::of(&E6, &asked, &TrajectoryLimits::default()).expect("a reference");
    let (eps, steps) = (eps_of(setting, horizon), number(setting, "steps") as usize);
    let order = number(setting, "order") as u32;
    let composition = Composition::of_order(order).expect("2, 4, 6 or 8");
    let double = start.each_ref().map(|x| Rational::from(x.clone()).to_f64());
    let single = start.each_ref().map(|x| Rational::from(x.clone()).to_f32());
    let wide = |x: SVector<f64, 3>| x.map(Dd::from);
    let narrow = |x: SVector<f32, 3>| x.map(Dd::from);
    let is_compensated = setting["compensated"] == true;
    let points: Vec<SVector<Dd, 3>> = match setting["scalar"].as_str().expect("a name") {
        "f64" => {
            let orbit = E6.orbit(double.into(), eps).composed(composition);
            if is_compensated {
                orbit.compensated().map(wide).take(steps + 1).collect()
            } else {
                orbit.map(wide).take(steps + 1).collect()
            }
        }
        "f32" => {
            let orbit = E6.orbit(single.into(), eps as f32).composed(composition);
            if is_compensated {
                orbit.compensated().map(narrow).take(steps + 1).collect()
            } else {
                orbit.map(narrow).take(steps + 1).collect()
            }
        }
        "f32-through-f64" => {
            let orbit = ThroughF64(E6).orbit(single.into(), eps as f32).composed(composition);
            if is_compensated {
                orbit.compensated().map(narrow).take(steps + 1).collect()
            } else {
                orbit.map(narrow).take(steps + 1).collect()
            }
        }
        "dd" => {
            let start = SVector::from(start.map(|x| {
                let (high, low) = Rational::from(x).to_double_double();
                Dd::new(high, low)
            }));
            E6.orbit(start, Dd::from(eps)).composed(composition).take(steps + 1).collect()
        }
        other => panic!("{other}"),
    };
    let dt = Dd::from(2.0 * eps);
    let distances = points.iter().enumerate();
    distances.map(|(n, x)| reference.distance(dt * Dd::from(n as f64), x.as_slice())).fold(0.0, f64::max)
}

#[test]
fn the_choice_meets_its_tolerance_when_it_is_run_again() {
    for tolerance in ["1e-2", "1e-5", "1e-10"] {
        let object = json(&[&E6_SCENE[..], &["--tolerance", tolerance]].concat());
        let limit: f64 = tolerance.parse().expect("a number");
        let choice = &object["choice"];
        let (claimed, again) = (number(choice, "trajectory_error"), error_of(choice, 3.0));
        assert!(claimed <= limit, "{choice}");
        // The command compares only some points of the orbit, so it may miss the largest error.
        assert!(again >= 0.999 * claimed && again <= 1.05 * claimed, "{claimed} against {again}");
        let rust = choice["rust"].as_str().expect("a line");
        assert!(rust.starts_with("let orbit = ") && rust.contains("E6") && rust.ends_with(");"), "{rust}");
    }
}

#[test]
fn tolerances_beyond_f64_are_met_in_double_double() {
    let object = json(&[&E6_SCENE[..], &["--tolerance", "1e-20"]].concat());
    let choice = &object["choice"];
    assert_eq!(choice["scalar"], "dd", "{choice}");
    assert!(error_of(choice, 3.0) <= 1.05e-20);
    assert!(choice["rust"].as_str().expect("a line").contains("Dd::new("), "{choice}");
}

#[test]
fn integrals_are_kept_by_a_coarse_step_of_the_map_itself() {
    let scene = ["trade", "e6", "--at", "1,1/2,1/3", "--horizon", "20", "--need", "integrals"];
    let object = json(&[&scene[..], &["--tolerance", "1e-11", "--seconds", "60"]].concat());
    let choice = &object["choice"];
    assert!(number(choice, "integral_drift") <= 1e-11);
    assert_eq!(choice["order"], 2, "the map conserves its own integrals at any eps: {choice}");
    assert_eq!(choice["trajectory_error"], Value::Null, "only what is needed is measured");
    assert_eq!(object["reference"], Value::Null);
    assert!(number(choice, "flow_integral_drift") > 1e-4, "at this eps the flow's are not kept: {choice}");
}

/// At ε = 0 the claimed integrals of the Euler top are the constant 1. The drift of a composition
/// is therefore measured by the coefficient of ε² in an integral.
#[test]
fn an_integral_that_is_trivial_for_the_flow_is_measured_by_its_next_coefficient() {
    let scene = ["trade", "euler", "--param", "a1=1", "--param", "a2=-3", "--param", "a3=1"];
    let rest = ["--at", "1/2,1/4,-3/4", "--horizon", "10", "--need", "integrals", "--tolerance", "1e-3"];
    let object = json(&[&scene[..], &rest, &["--seconds", "60"]].concat());
    for setting in settings(&object) {
        let (own, flow) = (number(setting, "integral_drift"), number(setting, "flow_integral_drift"));
        assert!(flow > 1e-17, "a drift of nothing: {setting}");
        if setting["order"] != 2 {
            assert_eq!(own, flow, "{setting}");
        } else if setting["scalar"] == "f64" {
            assert!(own < 1e-12, "{setting}");
        }
    }
}

#[test]
fn a_field_of_the_users_own_is_run_and_pasted_as_it_was_given() {
    let field = ["trade", "--field", "xdot = y; ydot = 6*x^2 - a;", "--param", "a=2", "--at", "-1/2,1/5"];
    let object = json(&[&field[..], &["--horizon", "1", "--tolerance", "1e-4", "--seconds", "60"]].concat());
    assert_eq!(object["timing"], "measured");
    assert_eq!(object["reference"]["second_method"], "composition");
    // The errors of the setting and of the reference together must be within the tolerance 1e-4.
    let difference = number(&object["reference"], "difference");
    assert!(difference <= 1e-6 && difference + number(&object["choice"], "trajectory_error") <= 1e-4);
    let rust = object["choice"]["rust"].as_str().expect("a line");
    assert!(rust.contains("let a = 2.0;\nlet field = kahan! { xdot = y; ydot = 6*x^2 - a; };\n"), "{rust}");
    assert!(rust.contains("field"), "{rust}");
    assert_eq!(object["choice"]["integral_drift"], Value::Null);
}

#[test]
fn the_text_names_the_choice_and_what_stands_behind_it() {
    let output = kahan(&[&E6_SCENE[..], &["--tolerance", "1e-5"]].concat());
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    for part in ["e6 from (1, 1/2, 1/3)", "need trajectory", "choice ", "let orbit = ", "closed solution"] {
        assert!(text.contains(part), "{part} in {text}");
    }
    assert!(output.stderr.is_empty(), "no progress without a terminal");

    // A float of 53 bits cannot have a relative error of 1e-20.
    let output = kahan(&[&E6_SCENE[..], &["--tolerance", "1e-20"]].concat());
    let text = String::from_utf8(output.stdout).expect("UTF-8");
    assert!(text.contains("too coarse f64, order 8: at best "), "{text}");
}

#[cfg(unix)]
#[test]
fn the_text_has_a_call_that_makes_the_orbit_of_the_choice() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("spring.svg");
    let out = path.to_str().expect("UTF-8");
    let spring = ["trade", "--field", "xdot = v; vdot = -x - x^2;", "--at", "0.3,0", "--horizon", "5"];
    let text = answer(&[&spring[..], &["--tolerance", "1e-4", "--seconds", "60", "--out", out]].concat());
    assert!(text.contains("return") && !text.contains("integrals"), "{text}");
    assert!(text.ends_with(&format!("{out} written\n")), "{text}");
    let call =
        text.lines().map(str::trim).find(|line| line.starts_with("kahan orbit --field ")).expect("a call");
    let orbit = shell(call, folder.path());
    assert!(orbit.status.success(), "{call}");
    let rows = String::from_utf8(orbit.stdout).expect("UTF-8");
    let time = rows.lines().last().and_then(|row| row.split(',').nth(1)?.parse::<f64>().ok());
    assert!((time.expect("a time") - 5.0).abs() < 1e-5, "{call}: {rows}");
}

#[test]
fn the_picture_is_well_formed_and_complete() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("e6.svg");
    let file = path.to_str().expect("UTF-8");
    let object = json(&[&E6_SCENE[..], &["--tolerance", "1e-5", "--out", file]].concat());
    let picture = std::fs::read_to_string(&path).expect("the picture");
    let mut reader = quick_xml::Reader::from_str(&picture);
    let (mut depth, mut elements) = (0_i32, 0);
    loop {
        match reader.read_event().expect("well-formed XML") {
            quick_xml::events::Event::Start(_) => (depth, elements) = (depth + 1, elements + 1),
            quick_xml::events::Event::Empty(_) => elements += 1,
            quick_xml::events::Event::End(_) => depth -= 1,
            quick_xml::events::Event::Eof => break,
            _ => {}
        }
    }
    assert_eq!(depth, 0);
    assert!(elements > 30, "{elements}");
    assert!(picture.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" "), "{picture}");
    assert!(picture.contains("tolerance") && picture.contains("choice") && picture.contains("order 8"));
    assert!(object["choice"].is_object());
}

#[test]
fn what_cannot_be_measured_is_refused_with_a_reason() {
    let escape = refusal(&["trade", "e1", "--at", "-1/2,1/3,1", "--horizon", "5"]);
    assert!(escape.contains("escapes to infinity, or beyond the largest double, near t = 2.0"), "{escape}");
    let none = refusal(&["trade", "lv", "--at", "1/2,5/3", "--horizon", "5", "--need", "integrals"]);
    assert!(none.contains("no integral is claimed"), "{none}");
    let horizon = refusal(&["trade", "e6", "--at", "1,2,3", "--horizon", "-1"]);
    assert!(horizon.contains("--horizon") && horizon.contains("above 0"), "{horizon}");
    let tolerance = refusal(&["trade", "e6", "--at", "1,2,3", "--horizon", "1", "--tolerance", "0"]);
    assert!(tolerance.contains("--tolerance"), "{tolerance}");
    let point = refusal(&["trade", "e6", "--at", "1,2", "--horizon", "1"]);
    assert!(point.contains("3 coordinates"), "{point}");
    let beyond = refusal(&["trade", "e6", "--at", "1,1/2,1/3", "--horizon", "3", "--tolerance", "1e-33"]);
    assert!(beyond.contains("differ by"), "{beyond}");
    let nine: Vec<String> = (0..9).map(|i| format!("x{i}dot = x{i}^2;")).collect();
    let wide =
        refusal(&["trade", "--field", &nine.concat(), "--at", "1,1,1,1,1,1,1,1,1", "--horizon", "1/2"]);
    assert!(wide.contains("9 variables"), "{wide}");
}

#[test]
fn a_tolerance_that_nothing_meets_is_a_complaint_with_the_best() {
    // No setting reaches 1e-40, because the most accurate arithmetic has 32 digits.
    let output = kahan(&[
        "trade",
        "e6",
        "--at",
        "1,1/2,1/3",
        "--horizon",
        "3",
        "--need",
        "integrals",
        "--tolerance",
        "1e-40",
    ]);
    assert_eq!(output.status.code(), Some(1));
    let complaint = String::from_utf8(output.stderr).expect("UTF-8");
    assert!(
        complaint.contains("no setting reaches the tolerance 1e-40") && complaint.contains("the best is dd"),
        "{complaint}"
    );
}
