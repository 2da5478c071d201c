//! Reads the published cases and proves the shortest forms that they list. `examples/literature`
//! compares them with the findings of `discover`.

use std::collections::BTreeSet;

#[path = "../examples/literature/case.rs"]
#[allow(dead_code, reason = "the comparison uses the rest")]
mod case;

use case::Case;

const CASES: &str = include_str!("../examples/literature/cases.jsonl");

#[test]
fn every_case_is_read_and_its_claims_are_proved() {
    let mut names = BTreeSet::new();
    for line in CASES.lines() {
        let case = Case::read(line).unwrap_or_else(|why| panic!("{why}"));
        assert!(names.insert(case.name.clone()), "{} stands there twice", case.name);
    }
    assert!(names.len() >= 85, "{} cases", names.len());
}

#[test]
fn what_is_wrong_with_a_case_is_said() {
    let case = |end: &str| {
        format!(r#"{{"name": "c", "source": "s", "field": "xdot = y; ydot = -x;", "known": {{}}{end}}}"#)
    };
    assert!(Case::read(&case("")).is_ok());
    for (end, why) in [
        (r#", "shortest": ["integral H = x^2 - y^2;"]"#, "integral H = x^2 - y^2; is not proved"),
        (r#", "shortest": "x""#, "`shortest` must be a list"),
        (r#", "params": {"a": 0.5}"#, "`a` needs a whole number"),
        (r#", "today": 1"#, "`today` is none of"),
    ] {
        let said = Case::read(&case(end)).expect_err("the case is wrong");
        assert!(said.contains(why), "{said}");
    }
}
