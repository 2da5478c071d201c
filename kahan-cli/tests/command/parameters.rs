//! Parameters that are given.

use serde_json::json;

use crate::running::{answer, object, refusal};

#[test]
fn are_put_in_before_the_map_is_reduced() {
    // E9 at xi = 1 is E3, whose map loses the factor 1 + eps*z.
    let special = object(&["show", "e9", "--param", "xi=1", "--json"]);
    let e3 = object(&["show", "e3", "--json"]);
    for key in ["field", "A", "map"] {
        assert_eq!(special[key], e3[key], "{key}");
    }
    assert_eq!(special["parameters"], json!([]));
}

#[test]
fn turn_their_conditions_into_nothing_and_drop_the_others() {
    let block = answer(&["show", "e9", "--param", "xi=-1", "--macro"]);
    assert!(block.contains("integral H4 = ") && !block.contains("H3") && !block.contains("when"), "{block}");
    assert_eq!(block.matches("density").count(), 1, "{block}");
    let report = object(&["verify", "e9", "--param", "xi=-1", "--json"]);
    assert_eq!(report["failed"], 0);
}

#[test]
fn may_not_make_the_field_divide_by_zero() {
    let paragraph = refusal(&["show", "--field", "xdot = x/(a - 1);", "--param", "a=1"]);
    assert!(paragraph.contains("a=1") && paragraph.contains("divides by zero"), "{paragraph}");
}
