//! Periodic points: what is found, proved, followed and refused.

use std::fs;

#[cfg(unix)]
use crate::running::examples_run;
use crate::running::{answer, kahan, object, refusal, text};

#[cfg(unix)]
#[test]
fn the_examples_of_the_help_run() {
    let folder = tempfile::tempdir().expect("a folder");
    assert!(examples_run("periodic", folder.path()) > 0);
}

#[test]
fn multipliers_of_a_linear_field_are_those_of_the_formula() {
    // Eigenvalues −1 and 2: (1 + ελ)/(1 − ελ).
    let found = object(&[
        "periodic",
        "--field",
        "xdot = -x; ydot = x + 2*y;",
        "--eps",
        "1/10",
        "--at",
        "1,1",
        "--json",
    ]);
    let multipliers = found["multipliers"].as_array().expect("multipliers");
    for (multiplier, expected) in multipliers.iter().zip([1.2 / 0.8, 0.9 / 1.1]) {
        let (re, im) = (multiplier[0].as_f64().expect("a number"), multiplier[1].as_f64().expect("a number"));
        assert!((re - expected).abs() < 1e-14 && im == 0.0, "{multiplier}");
    }
    assert_eq!((&found["stability"], &found["family"]), (&"saddle".into(), &0.into()));
    // (z − 3/2)(z − 9/11)
    let exact = serde_json::json!(
        { "points": [["0", "0"]], "polynomial": "27/22 - 51/22*z + z^2", "stability": "saddle" }
    );
    assert_eq!(found["exact"], exact);
}

#[test]
fn cycles_of_an_integrable_map_come_in_families() {
    // The orbits of the Euler top are circles of the map's own curves, where some have period 7.
    let euler = ["euler", "--param", "a1=1", "--param", "a2=-2", "--param", "a3=1", "--eps", "1/2"];
    let found =
        object(&[&["periodic"], &euler[..], &["--at", "0.2,1.6,0.4", "--period", "7", "--json"]].concat());
    assert!(found["family"].as_u64().expect("a number") >= 1, "{found}");
    assert!(found["residual"].as_f64().expect("a number") < 1e-11);
}

#[test]
fn a_small_orbit_is_no_point_that_stands_still() {
    let at = |start: &str| {
        let field = ["--field", "xdot = y; ydot = -x;", "--eps", "0.7265425280053609", "--period", "5"];
        let mut found = object(&[&["periodic"], &field[..], &["--at", start, "--json"]].concat());
        found["points"].take();
        (found["residual"].take(), found)
    };
    let (_, ordinary) = at("1,0");
    assert_eq!((&ordinary["period"], &ordinary["family"]), (&5.into(), &2.into()));
    for start in ["1e-9,0", "1e9,0", "1e-300,0"] {
        let (residual, found) = at(start);
        assert_eq!(
            [&found["period"], &found["family"], &found["stability"], &found["exact"]],
            [&ordinary["period"], &ordinary["family"], &ordinary["stability"], &ordinary["exact"]]
        );
        let size: f64 = start.split_once(',').and_then(|(x, _)| x.parse().ok()).expect("a number");
        assert!(residual.as_f64().expect("a number") < 1e-14 * size, "{start}");
    }
}

#[test]
fn a_branch_goes_round_its_fold() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("branch.csv");
    let field = ["--field", "xdot = a - x^2;", "--eps", "1/10", "--at", "1"];
    let over = ["--over", "a=1:-1:+-1/20", "--out", out.to_str().expect("UTF-8"), "--json"];
    let found = object(&[&["periodic"], &field[..], &over[..]].concat());
    let turns = found["branch"]["turns"].as_array().expect("turns");
    assert_eq!((turns.len(), &turns[0]["change"]), (1, &"fold, two steady states meet".into()));
    assert!(turns[0]["parameter"].as_f64().expect("a number").abs() < 1e-9);
    let table = fs::read_to_string(out).expect("the table");
    assert!(table.starts_with("a,n,x,stability\n1.0,0,1.0,attracting\n"), "{table}");
    // Fixed points of the map are those of the flow: a = x².
    for row in table.lines().skip(1) {
        let numbers: Vec<f64> = row.split(',').filter_map(|cell| cell.parse().ok()).collect();
        assert!((numbers[0] - numbers[2] * numbers[2]).abs() < 1e-10, "{row}");
    }
}

#[test]
fn what_changes_the_stability_of_the_lorenz_system_is_found() {
    // Equilibria lose their stability at r = s(s + b + 3)/(s − b − 1) = 470/19, those of the flow
    // and of the map: multipliers are (1 + ελ)/(1 − ελ).
    let lorenz = ["lorenz", "--param", "s=10", "--param", "b=8/3", "--eps", "1/1000", "--at", "8,8,27"];
    let found = object(&[&["periodic"], &lorenz[..], &["--over", "r=28:20:+-2/5", "--json"]].concat());
    let turns = found["branch"]["turns"].as_array().expect("turns");
    assert_eq!(turns.len(), 1, "{turns:?}");
    assert_eq!(turns[0]["change"], HOPF);
    assert!((turns[0]["parameter"].as_f64().expect("a number") - 470.0 / 19.0).abs() < 1e-8, "{turns:?}");
}

const HOPF: &str = "Hopf point, a pair of eigenvalues of f' goes through the imaginary axis";

#[test]
fn steady_states_keep_the_totals_of_their_start() {
    let sirs = ["periodic", "--field", "sdot = -2*s*i + r/2; idot = 2*s*i - i; rdot = i - r/2;", "--json"];
    // s = 1/2, i = r/2, and the total is that of the start.
    for (start, state) in [
        ("0.5,0.2,0.3", ["1/2", "1/6", "1/3"]),
        ("1,0.5,0.5", ["1/2", "1/2", "1"]),
        ("0.1,0.1,0.9", ["1/2", "1/5", "2/5"]),
    ] {
        let found = object(&[&sirs[..], &["--at", start]].concat());
        assert_eq!(found["exact"]["points"][0], serde_json::json!(state), "{found}");
        assert_eq!((&found["family"], &found["stability"]), (&0.into(), &"attracting".into()), "{found}");
        assert_eq!(found["eigenvalues"].as_array().map(Vec::len), Some(2), "{found}");
        // With all three variables, the total has an eigenvalue 0 of its own.
        let free = object(&[&sirs[..], &["--at", start, "--hold", "none"]].concat());
        assert_eq!((&free["family"], &free["stability"]), (&1.into(), &"neutral".into()), "{free}");
        assert_eq!(
            (found["held"].as_array().map(Vec::len), &free["held"]),
            (Some(1), &serde_json::json!([]))
        );
    }
    let total = object(&[&sirs[..], &["--at", "1,0.5,0.5"]].concat());
    assert_eq!(total["held"], serde_json::json!(["s + i + r = 2"]));
}

#[test]
fn coefficients_of_what_is_held_may_be_parameters_that_stand_still() {
    // a*x + y is kept; over a there is no integral with constant coefficients.
    let field = ["periodic", "--field", "xdot = y - x; ydot = -a*(y - x);", "--at", "1,0"];
    let held = |more: &[&str]| object(&[&field[..], more, &["--json"]].concat())["held"].clone();
    assert_eq!(held(&["--param", "a=3"]), serde_json::json!(["3*x + y = 3"]));
    assert_eq!(held(&["--over", "a=3:4:3"]), serde_json::json!([]));
    assert_eq!(held(&["--param", "a=3", "--over", "eps=1/10:1/5:3"]), serde_json::json!(["3*x + y = 3"]));
}

#[test]
fn steady_states_need_no_step_and_have_the_eigenvalues_of_the_field() {
    let rates = ["1", "1e-12", "1e12"];
    for rate in rates {
        let field = format!("xdot = {rate}*(x - x^2);");
        let found = object(&["periodic", "--field", &field, "--at", "0.9", "--json"]);
        let eigenvalue = found["eigenvalues"][0][0].as_f64().expect("a number");
        let expected: f64 = rate.parse().expect("a number");
        assert!((eigenvalue / expected + 1.0).abs() < 1e-12, "{found}");
        assert_eq!(found["exact"]["points"], serde_json::json!([["1"]]), "{found}");
    }
    // Lorenz' atmosphere of 1984 at a = 1/4, b = 4. At the Hopf point f = 0, and a₁a₂ = a₃ of the
    // characteristic polynomial of f': solved apart, in 40 digits.
    let field = "xdot = -y^2 - z^2 - x/4 + F/4; ydot = x*y - 4*x*z - y + G; zdot = 4*x*y + x*z - z;";
    let over = ["--param", "G=1/5", "--at", "1,0,0", "--over", "F=0.8:1.2:21", "--json"];
    let found = object(&[&["periodic", "--field", field], &over[..]].concat());
    let turns = found["branch"]["turns"].as_array().expect("turns");
    assert_eq!((turns.len(), &turns[0]["change"]), (1, &HOPF.into()), "{turns:?}");
    let parameter = turns[0]["parameter"].as_f64().expect("a number");
    assert!((parameter - 1.012_459_976_6).abs() < 1e-10, "{parameter}");
    let said = refusal(&[
        "periodic", "--field", field, "--param", "F=1", "--param", "G=1", "--at", "1,0,0", "--period", "2",
    ]);
    assert!(said.contains("--eps"), "{said}");
}

#[test]
fn what_is_no_cycle_and_what_does_not_fit_is_said() {
    let output = kahan(&["periodic", "--field", "xdot = x^2 + 1;", "--eps", "1/10", "--at", "0.3"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("no cycle was found"), "{}", text(&output.stderr));
    let lv = ["periodic", "lv", "--eps", "1/10", "--at", "0.9,1"];
    for (arguments, word) in [
        (&["--period", "0"][..], "whole number"),
        (&["--period", "500"], "200"),
        (&["--over", "b=0:1:+1/5"], "no parameter"),
        (&["--over", "eps=1:1:5"], "two ends"),
        (&["--over", "eps=1/10:1:+1/5", "--out", "x.txt"], ".svg"),
        (&["--out", "x.csv"], "--over"),
    ] {
        let said = refusal(&[&lv[..], arguments].concat());
        assert!(said.contains(word), "{word}: {said}");
    }
    let over = ["periodic", "lv", "--at", "0.9,1", "--over", "eps=1/10:1:+1/5"];
    assert!(answer(&over).contains("neutral"));
}

/// trace − 2 is 1.5e-10 there, and rounding makes it a hundred thousand times as much.
#[test]
fn a_verdict_takes_account_of_the_error_of_its_multipliers() {
    let cycle = |eps: &str, at: &str, period: &str| {
        object(&[
            "periodic",
            "weierstrass",
            "--param",
            "a=1",
            "--eps",
            eps,
            "--at",
            at,
            "--period",
            period,
            "--json",
        ])
    };
    assert_eq!(cycle("1/20", "0.41,0.1", "29")["stability"], "neutral");
    // Its fixed points, at x = ±1/√6, are a saddle and a centre.
    assert_eq!(cycle("1/20", "0.41,0", "1")["stability"], "saddle");
    assert_eq!(cycle("1/20", "-0.41,0", "1")["stability"], "neutral");
}
