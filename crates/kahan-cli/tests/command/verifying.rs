//! Tests `kahan verify`: outcomes, tables, mutations, and false claims.

use serde_json::Value;

use crate::running::{answer, kahan, object, refusal, text};

/// Tests one system as an example; `crates/kahan-paper/tests` proves the whole paper.
#[test]
fn every_claim_of_a_system_has_an_outcome_and_a_place() {
    let report = object(&["verify", "--system", "E3", "--json"]);
    let claims = report["claims"].as_array().expect("a list");
    assert_eq!(report["failed"], 0);
    let ids: Vec<&str> = claims.iter().filter_map(|claim| claim["id"].as_str()).collect();
    for id in ["e3.H", "e3.Q", "table1.e3.P", "table3.e3.P12", "table4.e3.Q31", "theorem1.e3.map"] {
        assert!(ids.contains(&id), "{id} is missing");
    }
    for claim in claims {
        let outcome = claim["outcome"].as_str().expect("a word");
        assert!(["proved", "proved-mod-p", "exact", "numerical", "misprint"].contains(&outcome), "{claim}");
        assert_eq!(claim["system"], "e3");
        for key in ["id", "source", "statement", "detail"] {
            assert!(claim[key].as_str().is_some_and(|value| !value.is_empty()), "{key} of {claim}");
        }
    }
}

#[test]
fn every_claim_has_a_line_and_with_all_its_time() {
    let claims = object(&["verify", "e2", "--json"])["claims"].as_array().expect("a list").len();
    let total = format!("\n{claims} claims: ");
    let short = answer(&["verify", "e2"]);
    assert!(short.starts_with("e2: ") && short.contains(&total), "{short}");
    assert_eq!(short.lines().filter(|line| line.starts_with("  ")).count(), claims);
    assert!(short.lines().all(|line| line.chars().count() <= 100 && !line.ends_with(" ms")), "{short}");
    assert!(short.contains("Table 2, i = 2"), "{short}");
    let long = answer(&["verify", "e2", "--all"]);
    assert!(long.starts_with("e2: ") && long.contains(&total) && long.ends_with(" s\n"), "{long}");
    assert_eq!(long.lines().filter(|line| line.starts_with("  ") && line.ends_with(" ms")).count(), claims);
}

#[test]
fn what_is_printed_wrong_is_shown_with_its_counterexample() {
    let table = answer(&["verify", "e3", "--all"]);
    assert!(table.contains("misprint: corrected form established"), "{table}");
    assert!(table.contains("printed: Q31_eps := y*(1 - eps^2*z)/("), "{table}");
    assert!(table.contains("-1/200 on the left, 1/40 on the right"), "{table}");
}

#[test]
fn no_claim_of_a_system_survives_every_mutation() {
    let report = object(&["verify", "lv", "--mutate", "--json"]);
    assert_eq!(report["survived"], 0);
    let mutations = report["mutations"].as_array().expect("a list");
    assert!(mutations.len() > 10);
    assert!(mutations.iter().all(|one| one["failed"].is_string() && one["tried"].as_u64() >= Some(1)));
    let text = answer(&["verify", "lv", "--mutate"]);
    assert!(text.contains("0 survived"), "{text}");
}

#[test]
fn one_system_at_a_time() {
    assert!(refusal(&["verify", "e1", "--system", "e2"]).contains("--system"));
    assert!(refusal(&["verify", "--system", "e10"]).contains("`e10`"));
    assert!(answer(&["verify", "--system", "general"]).starts_with("general: "));
}

#[test]
fn a_false_claim_fails_with_a_counterexample_and_status_1() {
    let field = "xdot = y; ydot = -x; integral F = x^2 + 2*y^2; integral H = x^2 + y^2;";
    let output = kahan(&["verify", "--field", field, "--json"]);
    assert_eq!(output.status.code(), Some(1));
    let report: Value = serde_json::from_slice(&output.stdout).expect("one JSON object");
    assert_eq!(report["failed"], 1);
    assert_eq!(report["claims"][0]["outcome"], "failed");
    assert!(report["claims"][0]["detail"].as_str().is_some_and(|detail| detail.contains("x = ")));
    assert_eq!(report["claims"][1]["outcome"], "proved");
    assert!(text(&output.stderr).contains("field.F"));
    let lines = text(&kahan(&["verify", "--field", field]).stdout);
    let statement = "integral F = x^2 + 2*y^2";
    assert!(lines.matches(statement).count() == 1 && !lines.contains("--all"), "{lines}");
}

#[test]
fn a_vacuous_claim_fails() {
    let output = kahan(&["verify", "--field", "xdot = y; ydot = -x; integral C = eps;"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stdout).contains("says nothing"));
}

#[test]
fn no_claim_of_a_field_of_ones_own_survives_every_mutation() {
    let field = "struct S { a, b } xdot = y; ydot = -x; zdot = 0*a*b; integral H = x^2 + y^2; \
                 integral K = H*z + 3; integral Z = z; integral W = H + a*x when a = 0; density one = 1; \
                 bracket P { {x,y} = 1; };";
    let report = object(&["verify", "--field", field, "--mutate", "--json"]);
    let mutations = report["mutations"].as_array().expect("a list");
    assert_eq!((mutations.len(), &report["survived"]), (6, &Value::from(0)), "{report}");
    let failed = |k: usize| mutations[k]["failed"].as_str().expect("a claim");
    assert_eq!(failed(0), "integral H = x^3 + y^2;");
    assert!(failed(3).ends_with(" when a = 0;"), "{}", failed(3));
    assert!(failed(2) != "integral Z = 2*z;" && failed(4) != "density one = 2;");
    // The changed claims use only known names, so `verify` can read and disprove them.
    for (k, original) in [(0, "integral H = x^2 + y^2;"), (2, "integral Z = z;")] {
        let said = text(&kahan(&["verify", "--field", &field.replace(original, failed(k))]).stderr);
        assert!(said.contains("claims failed"), "{}: {said}", failed(k));
    }
    let special = answer(&["verify", "e9", "--param", "xi=1", "--mutate"]);
    assert!(special.contains(" 0 survived"), "{special}");
}

#[test]
fn what_cannot_be_made_false_is_said_to_survive() {
    // The map is the identity, so every function is an integral.
    let output = kahan(&["verify", "--mutate", "--field", "xdot = 0*y; ydot = 0*x; integral H = x + 2*y;"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("field.H"), "{}", text(&output.stderr));
    assert!(answer(&["verify", "--mutate", "--field", "xdot = x;"]).starts_with("0 claims"));
    let false_claim = "xdot = y; ydot = -x; integral H = x^2 + 2*y^2;";
    assert!(refusal(&["verify", "--mutate", "--field", false_claim]).contains("does not hold"));
}
