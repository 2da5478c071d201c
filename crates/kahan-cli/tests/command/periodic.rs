//! Tests that `kahan periodic` finds, proves, continues and refuses cycles.

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
    // The eigenvalues λ = −1 and 2 of f′ give the multipliers (1 + ελ)/(1 − ελ).
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
    // The multipliers are the roots of the polynomial (z − 3/2)(z − 9/11).
    let exact = serde_json::json!(
        { "points": [["0", "0"]], "polynomial": "27/22 - 51/22*z + z^2", "stability": "saddle" }
    );
    assert_eq!(found["exact"], exact);
}

#[test]
fn cycles_of_an_integrable_map_come_in_families() {
    // Orbits of the Euler top lie on closed curves, some of which consist of cycles of period 7.
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
    assert!(
        table.starts_with("a,n,x,stability,multiplier1_re,multiplier1_im,change\n1.0,0,1.0,attracting,"),
        "{table}"
    );
    for row in table.lines().skip(1) {
        let numbers: Vec<f64> = row.split(',').filter_map(|cell| cell.parse().ok()).collect();
        assert!((numbers[0] - numbers[2] * numbers[2]).abs() < 1e-10, "{row}");
    }
}

#[test]
fn what_changes_the_stability_of_the_lorenz_system_is_found() {
    // The equilibria of the Lorenz system lose their stability at r = s(s + b + 3)/(s − b − 1) =
    // 470/19, for the flow and for the map. The multipliers of the map are (1 + ελ)/(1 − ελ).
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
    // In the steady state, s = 1/2 and i = r/2. The sum s + i + r is the same as at the start.
    for (start, state) in [
        ("0.5,0.2,0.3", ["1/2", "1/6", "1/3"]),
        ("1,0.5,0.5", ["1/2", "1/2", "1"]),
        ("0.1,0.1,0.9", ["1/2", "1/5", "2/5"]),
    ] {
        let found = object(&[&sirs[..], &["--at", start]].concat());
        assert_eq!(found["exact"]["points"][0], serde_json::json!(state), "{found}");
        assert_eq!((&found["family"], &found["stability"]), (&0.into(), &"attracting".into()), "{found}");
        assert_eq!(found["eigenvalues"].as_array().map(Vec::len), Some(2), "{found}");
        // With --hold none, the derivative f′ also has the eigenvalue 0, as s + i + r is preserved.
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
    // The integral a*x + y depends on a, so it is held only if a is fixed.
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
    // Lorenz's model of the atmosphere (1984) at a = 1/4, b = 4. The values at the Hopf point were
    // computed independently, in 40 digits.
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

/// The cycle of period 29 counts as neutral. The sum of its multipliers is 2 within the error of
/// about 1e-5.
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
    // The fixed points x = ±1/√6 are a saddle and a centre.
    assert_eq!(cycle("1/20", "0.41,0", "1")["stability"], "saddle");
    assert_eq!(cycle("1/20", "-0.41,0", "1")["stability"], "neutral");
}

/// Langford's field has a cycle of period 2π/3, whose multipliers cross the unit circle at b = 1/2.
const TORUS: &str = "xdot = x*z - b*x - 3*y; ydot = 3*x + y*z - b*y; zdot = 3/5 + z - z^2 - x^2 - y^2;";

fn number(value: &serde_json::Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("a number: {value}"))
}

#[test]
fn limit_cycles_of_the_flow_are_found_with_their_eps() {
    let free = ["periodic", "--field", TORUS, "--param", "b=1", "--free", "eps", "--eps", "0.02"];
    let period = 2.0 * std::f64::consts::PI / 3.0;
    for more in [&["--at", "0.5,0,1"][..], &["--at", "0.5,0,1", "--transient", "500", "--period", "50"]] {
        let found = object(&[&free[..], more, &["--json"]].concat());
        let flow = &found["flow"];
        let [value, error, eps] = ["period", "error", "eps"].map(|name| number(&flow[name]));
        assert!((value - period).abs() < 1e-8 && error < 1e-5, "{flow}");
        let steps = number(&found["period"]);
        assert!((2.0 * eps * steps / period - 1.0).abs() < 1e-2, "{flow}");
        assert_eq!(found["stability"], "attracting");
        // In (r, z), eigenvalues −1/2 ± iω at the fixed point give multipliers of size exp(−T/2).
        let size = flow["multipliers"].as_array().expect("multipliers").iter();
        let size: Vec<f64> = size.map(|one| number(&one[0]).hypot(number(&one[1]))).collect();
        assert!(
            size.len() == 2 && size.iter().all(|size| (size - (-period / 2.0).exp()).abs() < 1e-5),
            "{flow}"
        );
    }
    let said = answer(&[&free[..], &["--at", "0.5,0,1"]].concat());
    assert!(said.contains("period       2.0943951") && said.contains(" ± "), "{said}");
}

#[test]
fn limit_cycles_keep_the_totals_of_their_start() {
    let field = format!("{TORUS} wdot = b*x - x*z + 3*y;");
    let line = ["periodic", "--field", &field, "--param", "b=1", "--free", "eps", "--eps", "0.02"];
    let line = [&line[..], &["--at", "0.5,0,1,1"]].concat();
    let found = object(&[&line[..], &["--json"]].concat());
    assert_eq!(found["held"], serde_json::json!(["x + w = 3/2"]));
    assert!((number(&found["flow"]["period"]) - 2.0 * std::f64::consts::PI / 3.0).abs() < 1e-8, "{found}");
    let totals = found["points"].as_array().expect("points").iter().map(|x| number(&x[0]) + number(&x[3]));
    assert!(totals.into_iter().all(|total| (total - 1.5).abs() < 1e-15), "{found}");
    let free = kahan(&[&line[..], &["--hold", "none"]].concat());
    assert_eq!(free.status.code(), Some(1));
    assert!(text(&free.stderr).contains("family"), "{}", text(&free.stderr));
}

#[test]
fn changes_of_limit_cycles_are_extrapolated() {
    let line =
        ["periodic", "--field", TORUS, "--free", "eps", "--eps", "0.02", "--at", "1,0,0.6", "--period", "52"];
    let found = object(&[&line[..], &["--over", "b=0.6:0.4:5", "--json"]].concat());
    let turns = found["branch"]["turns"].as_array().expect("turns");
    assert_eq!(
        (turns.len(), &turns[0]["change"]),
        (1, &"a pair of multipliers goes through the unit circle".into())
    );
    assert!((number(&turns[0]["parameter"]) - 0.5).abs() < 1e-7, "{turns:?}");
    assert!(number(&turns[0]["error"]) < 1e-5, "{turns:?}");
    assert!(number(&found["branch"]["points"][0]["eps"]) > 0.0);
}

#[test]
fn limit_cycles_of_lifted_fields_have_no_multipliers_of_relations() {
    // Period and multiplier come from shooting with SciPy's DOP853 at tolerance 1e-13.
    let field = "xdot = y; ydot = m*(1 - x^2)*y - x;";
    let line = ["periodic", "--field", field, "--param", "m=1", "--lift", "--free", "eps", "--eps", "0.01"];
    let found = object(&[&line[..], &["--at", "2,0", "--json"]].concat());
    let flow = &found["flow"];
    assert!((number(&flow["period"]) - 6.663_286_859_323).abs() < 2e-5, "{flow}");
    let multipliers = flow["multipliers"].as_array().expect("multipliers");
    assert_eq!((multipliers.len(), &found["stability"]), (1, &"attracting".into()));
    assert!((number(&multipliers[0][0]) - 8.597e-4).abs() < 1e-5, "{flow}");
    assert_eq!(found["variables"], serde_json::json!(["x", "y"]));
}

#[test]
fn families_and_what_no_step_belongs_to_are_said() {
    let swing = ["periodic", "--field", "xdot = y; ydot = x^2 - x;", "--free", "eps", "--eps", "0.032"];
    let output = kahan(&[&swing[..], &["--at", "0.3,0", "--period", "100"]].concat());
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("eps = T/(2K)"), "{}", text(&output.stderr));
    let torus = ["periodic", "--field", TORUS, "--free", "eps", "--at", "1,0,0.6"];
    for (more, word) in [
        (&["--param", "b=1", "--over", "eps=0.02:0.01:5"][..], "cannot go through values"),
        (&["--param", "b=1", "--eps", "0.02", "--period", "1000000"], "beyond the"),
    ] {
        let said = refusal(&[&torus[..], more].concat());
        assert!(said.contains(word), "{word}: {said}");
    }
    let forced = ["periodic", "--field", "xdot = y; ydot = -x - y + cos(t);", "--lift", "--free", "eps"];
    assert!(refusal(&[&forced[..], &["--eps", "0.02", "--at", "1,0"]].concat()).contains("depends on t"));
}
