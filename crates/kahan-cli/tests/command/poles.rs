//! `kahan poles`.

use serde_json::{Value, json};

use crate::running::{BEYOND_THE_BUDGET, answer, object, refusal};

fn verdicts(object: &Value) -> Vec<Value> {
    let patterns = object["patterns"].as_array().expect("a list").iter();
    patterns.map(|one| json!([one["curve"], one["steps"], one["confined"]])).collect()
}

#[test]
fn the_object_has_its_keys_and_verdicts() {
    let found = object(&["poles", "--field", "xdot = y; ydot = 6*x^2 - a;", "--steps", "8", "--json"]);
    let keys: Vec<&str> = found.as_object().expect("an object").keys().map(String::as_str).collect();
    let expected = [
        "system",
        "patterns",
        "bound",
        "complete",
        "degrees",
        "implied_degrees",
        "growth",
        "entropy",
        "seconds",
    ];
    assert_eq!(keys, expected);
    let expected = [
        json!(["-1 + 12*eps^2*x", 4, true]),
        json!(["1 - 24*eps^2*x - 24*eps^3*y + 24*eps^4*a", 6, true]),
        json!(["infinity", 2, true]),
    ];
    assert_eq!(verdicts(&found), expected);
    assert_eq!((&found["bound"], &found["growth"]), (&json!(8), &json!("quadratic")));
    assert_eq!(found["implied_degrees"], json!([1, 2, 3, 5, 7, 11, 15, 20, 25]));
    let lost = object(&["poles", "lv", "--steps", "5", "--json"]);
    let undecided = object(&["poles", "lv", "--seconds", "1e-9", "--json"]);
    assert!(!verdicts(&lost).is_empty() && !verdicts(&undecided).is_empty());
    assert!(verdicts(&lost).iter().all(|one| one[1] == 5 && one[2] == false), "{lost}");
    assert!(verdicts(&undecided).iter().all(|one| one[1] == 0 && one[2].is_null()), "{undecided}");
    assert_eq!(undecided["implied_degrees"], Value::Null);
}

#[test]
fn the_table_says_what_comes_back() {
    let table = answer(&["poles", "weierstrass"]);
    assert!(table.contains("confined after 4 steps"), "{table}");
    assert!(table.contains("quadratic"), "{table}");
    let table = answer(&["poles", "lv", "--steps", "7"]);
    assert!(table.contains("none within 7 steps"), "{table}");
    let table = answer(&["poles", "e4"]);
    assert!(table.contains("nothing is lost") && !table.contains('…'), "{table}");
    assert!(table.lines().count() <= 60 && table.lines().all(|line| line.chars().count() <= 100), "{table}");
    assert!(answer(&["poles", "lv", "--seconds", "1e-9"]).contains("undecided"));
    assert!(table.lines().count() <= 40 && table.lines().all(|line| line.chars().count() <= 100), "{table}");
}

#[test]
fn bad_usage_is_one_paragraph() {
    assert!(refusal(&["poles"]).contains("--field"));
    assert!(refusal(&["poles", "lv", "--steps", "0"]).contains("--steps"));
    assert!(refusal(&["poles", "lv", "--eps", "0"]).contains("identity"));
    assert!(refusal(&["poles", "--field", BEYOND_THE_BUDGET]).contains("budget of terms"));
}
