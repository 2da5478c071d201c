//! Tests `kahan trade` near a pole, at very large or small numbers, and without time.

use std::process::Output;

use serde_json::Value;

use super::number;
use crate::running::kahan;

fn trade(arguments: &[&str]) -> Output {
    kahan(&[&["trade"], arguments].concat())
}

fn json(arguments: &[&str]) -> Value {
    let output = trade(&[arguments, &["--json", "--seconds", "60"]].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("one JSON object")
}

fn complaint(arguments: &[&str], status: i32) -> String {
    let output = trade(arguments);
    assert_eq!(output.status.code(), Some(status), "{}", String::from_utf8_lossy(&output.stdout));
    String::from_utf8(output.stderr).expect("UTF-8")
}

/// The solution is x = tan t, and the horizon is 0.0068 before the pole π/2.
#[test]
fn near_a_pole_errors_are_relative_to_the_trajectory_before_the_horizon() {
    let scene = ["--field", "xdot = x^2 + 1;", "--at", "0", "--horizon", "1.564", "--tolerance", "1e-4"];
    let object = json(&scene);
    // At the horizon, an error of t is amplified by 1 + tan² t ≈ 2·10⁴.
    assert!((number(&object, "scale") / 1.564_f64.tan() - 1.0).abs() < 1e-11, "{}", object["scale"]);
    let choice = &object["choice"];
    assert!(number(choice, "trajectory_error") <= 1e-4);
    // f′(x) = 2x is about 300 at the horizon, but mostly much smaller, so ε may exceed 1/300.
    assert!(number(choice, "eps") > 0.02, "{choice}");
}

/// E6 has the symmetry (x, ε) ↦ (λx, ε/λ), so errors in `f64` do not depend on the scale.
#[test]
fn a_homogeneous_field_is_served_alike_at_every_scale() {
    let of = |point: &str, horizon: &str| {
        let object = json(&[
            "e6",
            "--at",
            point,
            "--horizon",
            horizon,
            "--tolerance",
            "1e-10",
            "--need",
            "trajectory",
        ]);
        let settings = object["settings"].as_array().expect("settings").clone();
        let plain = settings.into_iter().find(|setting| {
            setting["scalar"] == "f64" && setting["order"] == 8 && setting["compensated"] == false
        });
        let plain = plain.expect("order 8 in f64 is always measured");
        (number(&object, "scale"), number(&plain, "steps"), number(&plain, "trajectory_error"))
    };
    let lambda = 125_f64.exp2();
    let digits = |number: f64| format!("{number:e}");
    let scaled = |factor: f64| [1.0, 0.5, 0.375].map(|x| digits(factor * x)).join(",");
    let (scale, steps, error) = of("1,0.5,0.375", "8");
    for factor in [lambda, 1.0 / lambda] {
        let (this_scale, this_steps, this_error) = of(&scaled(factor), &digits(8.0 / factor));
        assert!((this_scale / (factor * scale) - 1.0).abs() < 1e-12, "{this_scale:e}");
        assert_eq!(this_steps, steps);
        assert!((this_error / error - 1.0).abs() < 1e-6, "{this_error:e}, {error:e}");
    }
}

/// Over a time span of 1e60, ε exceeds the range of `f32`, so the command chooses `f64`.
#[test]
fn a_horizon_beyond_the_range_of_f32_is_served_by_f64() {
    let scene = ["e1", "--at", "1e-60,1e-60,1e-60", "--horizon", "1e60", "--tolerance", "1e-4"];
    let object = json(&scene);
    assert_eq!(object["choice"]["scalar"], "f64", "{object}");
    let settings = object["settings"].as_array().expect("settings");
    assert!(settings.iter().all(|setting| number(setting, "eps") > 0.0), "{object}");
}

#[test]
fn a_slope_across_the_motion_does_not_ask_for_fine_steps() {
    let object = json(&["e1", "--at", "1,1,1", "--horizon", "10000", "--tolerance", "1e-2"]);
    assert!(number(&object["choice"], "steps") < 1e5, "{}", object["choice"]);
}

#[test]
fn systems_beyond_the_paper_are_timed_as_compiled_too() {
    let object = json(&["volterra4", "--at", "1,1/2,3/4,1/4", "--horizon", "2", "--tolerance", "1e-4"]);
    assert_eq!(object["timing"], "measured");
    let parameters = ["--param", "al=3/2", "--param", "g=1/2", "--at", "1,0,1/2,1/4,0,1", "--horizon", "1"];
    let object = json(&[&["lagrange", "--tolerance", "1e-4"], &parameters[..]].concat());
    assert_eq!(object["timing"], "measured");
}

/// On this orbit, compensated `f64` at order 2 needs fifty times as many steps as double-double.
#[test]
fn double_double_is_tried_where_the_roundings_of_f64_are_felt() {
    let scene =
        ["e6", "--at", "1,1/2,1/3", "--horizon", "100", "--need", "integrals", "--tolerance", "4e-16"];
    let object = json(&scene);
    let settings = object["settings"].as_array().expect("settings");
    assert!(settings.iter().any(|setting| setting["scalar"] == "dd" && setting["order"] == 2), "{object}");
}

#[test]
fn without_time_nothing_is_said_of_accuracy() {
    let scene = ["lv", "--at", "1/2,5/3", "--horizon", "3000", "--seconds", "1e-6"];
    let refusal = complaint(&scene, 2);
    assert!(
        refusal.contains("longer than there is time") && refusal.contains("give more --seconds"),
        "{refusal}"
    );
    let scene = ["e6", "--at", "1,1/2,1/3", "--horizon", "1e12", "--need", "integrals", "--seconds", "1e-6"];
    let refusal = complaint(&scene, 1);
    assert!(refusal.contains("nothing was measured on"), "{refusal}");
    assert!(!refusal.contains("none gives"), "{refusal}");
}

#[test]
fn a_tolerance_beyond_32_digits_is_told_from_a_sensitive_solution() {
    let scene = ["lv", "--at", "1/2,5/3", "--horizon", "1", "--tolerance", "1e-30"];
    let refusal = complaint(&scene, 2);
    assert!(refusal.contains("choose a tolerance above ") && !refusal.contains("sensitive"), "{refusal}");
    let named = refusal.trim_end().rsplit(' ').next().expect("a number");
    json(&["lv", "--at", "1/2,5/3", "--horizon", "1", "--tolerance", named]);
}

/// The orbit of E6 through the point (1, 1/2, 1/3) is periodic, so it does not escape.
#[test]
fn a_long_horizon_is_not_taken_for_an_escape() {
    let refusal = complaint(&["e6", "--at", "1,1/2,1/3", "--horizon", "1e12", "--seconds", "0.2"], 2);
    assert!(!refusal.contains("escapes"), "{refusal}");
}
