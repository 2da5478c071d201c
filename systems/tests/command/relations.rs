//! Claims `when` relations hold, in every command that shows or proves them.

use crate::running::{answer, object, refusal};

const FIELD: &str = "xdot = a1*a2*y; ydot = -a1*a2*x; udot = a5*a6*v; vdot = -a5*a6*u; \
     integral G = x*u + y*v when a1*a2 = a5*a6;";

#[test]
fn are_shown_with_what_may_not_vanish() {
    let line = "integral G = x*u + y*v when a1*a2 = a5*a6;";
    assert!(answer(&["show", "--field", FIELD]).contains(&format!("{line}    // a2 != 0")));
    assert!(answer(&["show", "--field", FIELD, "--macro"]).contains(line));
    let claim = &object(&["show", "--field", FIELD, "--json"])["claims"][0];
    assert_eq!(claim["when"], "a1*a2 = a5*a6");
    assert_eq!(claim["nonzero"], "a2 != 0");
    let latex = answer(&["show", "--field", FIELD, "--latex"]);
    assert!(latex.contains("\\text{where } a_{1} a_{2} = a_{5} a_{6}"), "{latex}");
}

#[test]
fn are_proved_by_normal_forms_over_the_rationals() {
    let report = object(&["verify", "--field", FIELD, "--json"]);
    assert_eq!(report["claims"][0]["outcome"], "proved", "{report}");
    let wrong = FIELD.replace("= a5*a6;", "= -a5*a6;");
    assert!(refusal(&["verify", "--field", &wrong]).contains("does not hold"));
}

#[test]
fn make_no_accessor() {
    let values = object(&[
        "eval", "--field", FIELD, "--eps", "1/2", "--at", "1,2,3,4", "--param", "a1=1", "--param", "a2=2",
        "--param", "a5=3", "--param", "a6=4", "--json",
    ]);
    assert_eq!(values["integrals"].as_object().map(serde_json::Map::len), Some(0), "{values}");
    // At parameters on the relation it holds, and has one.
    let values = object(&[
        "eval", "--field", FIELD, "--eps", "1/2", "--at", "1,2,3,4", "--param", "a1=1", "--param", "a2=12",
        "--param", "a5=3", "--param", "a6=4", "--json",
    ]);
    assert_eq!(values["integrals"]["G"], "11", "{values}");
}
