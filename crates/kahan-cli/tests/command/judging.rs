//! Tests the table of `kahan extremes`, which counts wrong and flagged steps.

use serde_json::Value;

use crate::running::kahan;

#[test]
fn the_object_has_a_cell_for_every_regime_tier_and_scalar() {
    let output = kahan(&["extremes", "e3", "--trials", "64", "--seed", "3", "--json"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let object: Value = serde_json::from_slice(&output.stdout).expect("one JSON object");
    assert_eq!((&object["system"], &object["trials"]), (&"e3".into(), &64.into()));
    let cells = object["cells"].as_array().expect("a list");
    // Each of seven regimes has seven pairs (`tier`, number type). Large steps have three further
    // cells for `lu`.
    assert_eq!(cells.len(), 7 * 7 + 3);
    let of_lu = |cell: &&Value| cell["tier"] == "lu";
    assert!(cells.iter().filter(of_lu).all(|cell| cell["regime"] == "large steps"));
    assert_eq!(cells.iter().filter(of_lu).count(), 3);
    for cell in cells {
        assert!(cell["regime"].is_string() && cell["tier"].is_string() && cell["scalar"].is_string());
        assert!(cell["trials"].as_u64().is_some_and(|trials| trials >= 8));
        for count in ["flagged", "unjustified_flags", "silently_wrong"] {
            assert!(cell[count].as_u64() <= cell["trials"].as_u64(), "{cell}");
        }
        let is_special = cell["regime"] == "infinite or NaN input";
        assert_eq!(cell["max_error_u"].is_null(), is_special, "{cell}");
    }
}

/// E3 as text and the built-in E3 run in the same interpreter, so all results are equal.
#[test]
fn a_field_of_ones_own_is_judged_as_its_compiled_code_would_be() {
    let cells = |arguments: &[&str]| {
        let output = kahan(&[arguments, &["--trials", "256", "--seed", "9", "--json"]].concat());
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        let object: Value = serde_json::from_slice(&output.stdout).expect("one JSON object");
        object["cells"].clone()
    };
    let field = ["extremes", "--field", "xdot = -x*z; ydot = -y*z; zdot = x^2 + y^2;"];
    let read = cells(&field);
    assert_eq!(read, cells(&["extremes", "e3"]));
    assert!(read.as_array().is_some_and(|cells| cells.iter().any(|cell| cell["silently_wrong"] != 0)));
    // This field divides by a random parameter, and its constant 1/3 must be rounded.
    cells(&["extremes", "--field", "xdot = x*y/mu + 1/3; ydot = mu - x^2;"]);
}

#[test]
fn random_fields_are_drawn_by_the_seed_and_told() {
    let object = |seed: &str| {
        let output =
            kahan(&["extremes", "e3", "--trials", "320", "--random-fields", "6", "--seed", seed, "--json"]);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        serde_json::from_slice::<Value>(&output.stdout).expect("one JSON object")
    };
    let (one, other) = (object("3"), object("4"));
    assert_eq!(
        (&one["cells"], &one["random_fields"]),
        (&object("3")["cells"], &object("3")["random_fields"])
    );
    assert_ne!(one["random_fields"], other["random_fields"]);
    assert_eq!(one["systems"].as_array().map(Vec::len), Some(7));
    let field = one["random_fields"][1][1].as_str().expect("the text of a field");
    let output = kahan(&["extremes", "--field", field, "--trials", "64"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Some of these fields have a map with too many terms to be reduced.
#[test]
fn every_field_of_odd_temper_is_judged() {
    let trials = ["--trials", "8", "--odd-fields", "20", "--odd-trials", "4"];
    let output = kahan(&[&["extremes", "e3"], &trials[..], &["--json"]].concat());
    let object: Value = serde_json::from_slice(&output.stdout).expect("one JSON object");
    assert_eq!(object["odd_fields"], 20);
    let cells = object["cells"].as_array().expect("a list");
    let stable = cells.iter().filter(|cell| cell["tier"] == "stable");
    let judged: u64 = stable.map(|cell| cell["trials"].as_u64().expect("a count")).sum();
    // For each of three number types, E3 has 8 trials and 24 special inputs. Nineteen fields of
    // --odd-fields have 4 trials and 24 inputs each, and one has 40 and 24.
    assert_eq!(judged, 3 * (8 + 24 + 19 * (4 + 24) + (40 + 24)));
    let broken = object["broken"].as_array().expect("a list");
    assert_eq!(output.status.code(), Some(i32::from(!broken.is_empty())));
    assert!(broken.iter().all(|field| field["text"].as_str().is_some_and(|text| text.contains("dot = "))));
}

/// For h = ±1 the leading terms of det A cancel, where A is the matrix of a step. `try_step` once
/// refused such steps without justification.
#[test]
fn a_field_whose_leading_terms_cancel_is_not_flagged() {
    let field = "xdot = h*y - x + y*z; ydot = h*x - y - x*z; zdot = -z + x*y;";
    let output = kahan(&["extremes", "--field", field, "--trials", "2000"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn what_cannot_be_judged_is_refused() {
    for (arguments, word) in [
        (&["extremes", "--field", "xdot = x^2/mu;", "--param", "mu=0"][..], "divides by zero"),
        (&["extremes", "e7", "--param", "mu=1"], "no parameter"),
        (&["extremes", "--param", "xi=1"], "of which system"),
        (&["extremes", "e1", "--trials", "0"], "1 or more"),
        (&["extremes", "e12"], "no system"),
    ] {
        let output = kahan(arguments);
        let paragraph = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {paragraph}");
        assert!(output.stdout.is_empty() && paragraph.contains(word), "{paragraph}");
    }
}
