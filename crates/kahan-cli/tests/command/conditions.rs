//! Claims with a condition `when`, in every command that shows or proves them.

use serde_json::json;

use crate::running::{answer, kahan, object};

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
    assert_eq!(kahan(&["verify", "--field", &wrong]).status.code(), Some(1));
}

#[test]
fn make_no_accessor() {
    let values = object(&[
        "eval", "--field", FIELD, "--eps", "1/2", "--at", "1,2,3,4", "--param", "a1=1", "--param", "a2=2",
        "--param", "a5=3", "--param", "a6=4", "--json",
    ]);
    assert_eq!(values["integrals"].as_object().map(serde_json::Map::len), Some(0), "{values}");
}

#[test]
fn hold_or_do_not_once_the_parameters_are_given() {
    let at = |a2: &str| {
        let given = ["--param", "a1=1", "--param", a2, "--param", "a5=3", "--param", "a6=4"];
        answer(&[&["show", "--field", FIELD, "--macro"][..], &given].concat())
    };
    assert!(at("a2=12").contains("integral G = x*u + y*v;"), "{}", at("a2=12"));
    assert!(!at("a2=2").contains("integral"), "{}", at("a2=2"));
}

#[test]
fn are_proposed_by_a_scan() {
    let field = "xdot = x*(y - z) + a*y^2; ydot = y*(z - x) + b*y^2; zdot = z*(x - y) + c*y^2;";
    let grid = ["--param", "a=-1:1:+1", "--param", "b=-1:1:+1", "--param", "c=-1:1:+1"];
    let arguments = [&["scan", "--field", field][..], &grid].concat();
    let claim = "integral H1 = x + y + z when c = -a - b;";
    let page = answer(&arguments);
    let seen = "when c = -a - b: all 7 points of the grid there are special, with 1 integral; proved:";
    assert!(page.contains(&format!("\n{seen}\n{claim}\n")), "{page}");
    let found = &object(&[&arguments[..], &["--json"]].concat())["relations"][0];
    assert_eq!((&found["relation"], &found["points"]), (&json!("c = -a - b"), &json!(7)));
    assert_eq!((&found["claims"], &found["proved"]), (&json!([claim]), &json!(true)));
    let field = "xdot = x*(1 - y); ydot = y*(x - 1) + a*x^2;";
    let page = answer(&["scan", "--field", field, "--param", "a=-4:4:+1", "--eps", "-4:4:+1"]);
    let seen = "when eps = 1: all 9 points of the grid there are special, with no integral; only seen, nothing is proved";
    assert!(page.contains(seen), "{page}");
}
