//! `kahan heights`.

use std::process::Output;

use serde_json::Value;

use crate::running::{self, text};

fn kahan(arguments: &[&str]) -> Output {
    running::kahan(&[&["heights"], arguments].concat())
}

fn run(status: i32, arguments: &[&str]) -> (String, String) {
    let output = kahan(arguments);
    let error = text(&output.stderr);
    assert_eq!(output.status.code(), Some(status), "{arguments:?}: {error}");
    (text(&output.stdout), error)
}

fn object(status: i32, arguments: &[&str]) -> Value {
    serde_json::from_str(&run(status, arguments).0).expect("one JSON object")
}

const LV: [&str; 5] = ["lv", "--eps", "9/14", "--at", "1/2,5/3"];

#[test]
fn the_object_has_its_keys_in_order() {
    let object = object(0, &[&LV[..], &["--steps", "12", "--json"]].concat());
    let keys: Vec<&str> = object.as_object().expect("an object").keys().map(String::as_str).collect();
    assert_eq!(keys, ["system", "steps", "log_heights", "growth", "entropy", "seconds", "stopped"]);
    assert_eq!(object["steps"], 12);
    assert_eq!(object["log_heights"]["x"].as_array().map(Vec::len), Some(12));
    assert_eq!(object["log_heights"]["x"][0], 7.46737106691756);
    assert_eq!(object["log_heights"]["y"][11], 23380.791224805);
    assert_eq!(object["growth"], "exponential");
    assert!(object["entropy"].as_f64().is_some_and(|entropy| (entropy - 2.0_f64.ln()).abs() < 1e-3));
    assert!(object["seconds"].as_f64().is_some_and(|seconds| seconds > 0.0));
    assert_eq!(object["stopped"], Value::Null);
}

#[test]
fn the_table_shows_heights_growth_and_entropy() {
    let (table, error) = run(0, &["e3", "--eps", "1/2", "--at", "3/7,11/13,23/47", "--steps", "100"]);
    assert_eq!(error, "");
    assert!(table.starts_with("n    h(x)"), "{table}");
    assert!(table.lines().any(|line| line.starts_with("2    33.1563508727446")), "{table}");
    assert!(table.lines().any(|line| line.starts_with("100  ")), "{table}");
    assert!(table.contains("\ngrowth    linear\nentropy   0\n"), "{table}");
    assert!(table.lines().count() < 40, "a table fits a screen");
}

#[test]
fn parameters_and_decimals_go_with_any_field() {
    let text = "xdot = y; ydot = 6*x^2 - a;";
    let decimal = object(
        0,
        &["--field", text, "--param", "a=0.5", "--eps", "0.25", "--at", "0,1", "--steps", "6", "--json"],
    );
    let fraction = object(
        0,
        &["--field", text, "--param", "a=1/2", "--eps", "1/4", "--at", "0,1.0", "--steps", "6", "--json"],
    );
    assert_eq!(decimal["log_heights"], fraction["log_heights"]);
    assert_eq!(decimal["system"], "field");
}

#[test]
fn a_bound_ends_the_orbit_with_a_note_and_without_an_error() {
    let (table, error) = run(0, &[&LV[..], &["--steps", "60", "--digits", "1000"]].concat());
    assert_eq!(error, "");
    assert!(table.contains("stopped after 8 of 60 steps"), "{table}");
    assert!(table.contains("--digits 1000 ") && table.contains("increase --digits"), "{table}");
    let object = object(0, &[&LV[..], &["--steps", "60", "--digits", "1000", "--json"]].concat());
    assert_eq!(object["stopped"], "digits");
    assert_eq!(object["steps"], 8);
    let (table, _) = run(0, &[&LV[..], &["--steps", "60", "--seconds", "0.2"]].concat());
    assert!(table.contains("--seconds 0.2"), "{table}");
}

#[test]
fn a_pole_ends_the_orbit_with_what_is_known() {
    let pole = ["--field", "xdot = x^2;", "--eps", "1", "--at", "1/6", "--steps", "9"];
    let (table, error) = run(1, &pole);
    assert!(table.lines().any(|line| line.starts_with("2  0.693147180559945")), "{table}");
    assert!(
        error.starts_with("error: ") && error.contains("det A = 0") && error.contains("step 2"),
        "{error}"
    );
    let object = object(1, &[&pole[..], &["--json"]].concat());
    assert_eq!(object["stopped"], "pole");
    assert_eq!(object["steps"], 2);
}

#[test]
fn every_step_goes_into_the_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("heights.csv");
    let path_text = path.to_str().expect("UTF-8");
    let (table, said) =
        run(0, &["e4", "--eps", "1/2", "--at", "7/3,11/13,23/47", "--steps", "30", "--out", path_text]);
    assert!(table.contains("growth    quadratic"), "{table}");
    assert_eq!(said, "");
    let csv = std::fs::read_to_string(&path).expect("the file");
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines.len(), 32);
    assert_eq!(lines[0], "n,h_x,h_y,h_z,digits");
    assert_eq!(lines[2], "1,16.040286638396,14.0172776521616,17.3927107137843,8");
}

#[test]
fn bad_usage_is_one_paragraph() {
    let good = |extra: &[&'static str]| [&LV[..], &["--steps", "3"], extra].concat();
    let bad = [
        vec!["lv", "--eps", "1/2", "--at", "1/2,5/3"],
        vec!["lv", "--eps", "1/2", "--at", "1/2", "--steps", "3"],
        vec!["lv", "--eps", "half", "--at", "1/2,5/3", "--steps", "3"],
        vec!["lv", "--eps", "1/2", "--at", "1/2,5/3", "--steps", "-3"],
        vec!["e7", "--eps", "1/2", "--at", "1,2,3", "--steps", "3"],
        vec!["--field", "xdot = x^2/k;", "--param", "k=0", "--eps", "1", "--at", "1", "--steps", "3"],
        good(&["--seconds", "0"]),
        good(&["--seconds", "nan"]),
        good(&["--digits", "0"]),
        good(&["--out", "/nowhere/at/all.csv"]),
    ];
    for arguments in bad {
        let (out, error) = run(2, &arguments);
        assert!(out.is_empty(), "{arguments:?} printed something");
        assert!(error.starts_with("error: ") && !error.trim_end().contains("\n\n"), "{arguments:?}: {error}");
    }
}
