//! `kahan eval`: every object at a point.

use serde_json::{Value, json};

use crate::running::{answer, kahan, object, text};

#[test]
fn every_object_of_e1_has_the_value_of_the_oracle() {
    let values = object(&["eval", "e1", "--eps", "1/2", "--at", "3/7,11/13,23/47", "--json"]);
    let expected = json!({
        "system": "e1",
        "variables": ["x", "y", "z"],
        "parameters": {},
        "eps": "1/2",
        "x": ["3/7", "11/13", "23/47"],
        "field": ["-9/49", "-33/91", "91279/55601"],
        "field_jacobian": [["-6/7", "0", "0"], ["-11/13", "-3/7", "0"], ["23/47", "44/13", "3/7"]],
        "A": [["10/7", "0", "0"], ["11/26", "17/14", "0"], ["-23/94", "-22/13", "11/14"]],
        "b": ["3/7", "11/13", "23/47"],
        "det_A": "935/686",
        "x_next": ["3/10", "77/130", "1740459/873730"],
        "jacobian": [["49/100", "0", "0"], ["-539/1300", "7/10", "0"], ["50669577/96110300", "196/65", "161/110"]],
        "det_jacobian": "55223/110000",
        "integrals": { "H": "77/39", "K": "1441160/1485341" },
        "density": "5059691/1698510",
        "brackets": {
            "P": [["0", "0", "561/1372"], ["0", "0", "2057/2548"], ["-561/1372", "-2057/2548", "0"]],
            "Q": [["0", "27/343", "-198/637"], ["-27/343", "0", "9321201/72781709"], ["198/637", "-9321201/72781709", "0"]],
        },
        "drifts": {},
    });
    for (key, value) in expected.as_object().expect("an object") {
        assert_eq!(&values[key], value, "{key}");
    }
    let keys = |object: &Value| object.as_object().expect("an object").keys().cloned().collect::<Vec<_>>();
    assert_eq!(keys(&values), keys(&expected));
}

#[test]
fn parameters_and_negative_numbers_are_read_exactly() {
    let arguments =
        ["eval", "e7", "--eps", "1/2", "--at", "3/7,11/13,23/47", "--param", "xi=19/17", "--json"];
    let values = object(&arguments);
    assert_eq!(values["parameters"], json!({ "xi": "19/17" }));
    assert_eq!(values["x_next"], json!(["3/10", "21791/38350", "9131905909/4381755950"]));
    assert_eq!(values["density"], "17836/6171");
    let back = object(&[
        "eval",
        "e7",
        "--eps",
        "-1/2",
        "--at",
        "0.3,21791/38350,9131905909/4381755950",
        "--param",
        "xi=19/17",
        "--json",
    ]);
    assert_eq!(back["x_next"], json!(["3/7", "11/13", "23/47"]));
    let negative = object(&["eval", "e4", "--eps", "-1e-1", "--at", "-1,2,3", "--json"]);
    assert_eq!((&negative["eps"], &negative["x"]), (&json!("-1/10"), &json!(["-1", "2", "3"])));
}

#[test]
fn removable_poles_have_the_value_of_the_reduced_map() {
    let e1 = object(&["eval", "e1", "--eps", "1/2", "--at", "-2,1,1/3", "--json"]);
    assert_eq!(
        (&e1["x_next"], &e1["det_jacobian"], &e1["det_A"]),
        (&json!(["2", "-1", "-2/3"]), &json!("-1"), &json!("0"))
    );
    assert_eq!((&e1["integrals"]["K"], &e1["brackets"]["Q"]), (&Value::Null, &Value::Null));
    let e3 = object(&["eval", "e3", "--eps", "1/2", "--at", "3/2,1,-2", "--json"]);
    assert_eq!((&e3["x_next"], &e3["det_jacobian"]), (&json!(["24/13", "16/13", "2"]), &json!("4096/2197")));
}

#[test]
fn at_a_pole_the_rest_is_printed_and_the_status_is_1() {
    let point = ["eval", "e1", "--eps", "1/2", "--at", "2,1,1/3", "--json"];
    for scalar in ["exact", "f64", "f32"] {
        let output = kahan(&[&point[..], &["--scalar", scalar]].concat());
        assert_eq!(output.status.code(), Some(1), "{scalar}");
        let values: Value = serde_json::from_slice(&output.stdout).expect("one JSON object");
        for key in ["x_next", "jacobian", "det_jacobian"] {
            assert_eq!(values.get(key), Some(&Value::Null), "{key}, {scalar}");
        }
        assert_eq!(values["integrals"]["H"], if scalar == "exact" { json!("1/2") } else { json!(0.5) });
        let complaint = text(&output.stderr);
        assert!(
            complaint.contains("det A = 0") && complaint.contains("x = 2, y = 1, z = 1/3"),
            "{complaint}"
        );
    }
}

#[test]
fn floats_are_numbers_near_the_exact_values() {
    let point = ["eval", "lv", "--eps", "1/2", "--at", "1/2,5/3", "--json", "--scalar"];
    for (scalar, tolerance) in [("f64", 4.0 * f64::EPSILON), ("f32", 4.0 * f64::from(f32::EPSILON))] {
        let values = object(&[&point[..], &[scalar]].concat());
        for (value, exact) in [(&values["x_next"][0], 7.0 / 18.0), (&values["x_next"][1], 25.0 / 27.0)] {
            assert!(
                value.as_f64().is_some_and(|value| (value - exact).abs() <= tolerance),
                "{scalar}: {value}"
            );
        }
    }
}

#[test]
fn a_field_of_ones_own_takes_its_free_names_as_parameters() {
    let field = "xdot = y; ydot = 6*x^2 - a;";
    let values =
        object(&["eval", "--field", field, "--param", "a=2", "--eps", "1/10", "--at", "0,1", "--json"]);
    assert_eq!(values["system"], "field");
    assert_eq!(values["field"], json!(["1", "-2"]));
    assert_eq!(values["density"], Value::Null);
    assert_eq!((&values["integrals"], &values["brackets"]), (&json!({}), &json!({})));
}

#[test]
fn a_drift_has_its_value_and_the_next_one() {
    let field = "xdot = x^2; drift F = 1/x by F - 2*eps;";
    let values = object(&["eval", "--field", field, "--eps", "1/10", "--at", "1/3", "--json"]);
    assert_eq!(values["drifts"], json!({ "F": ["3", "14/5"] }));
    assert_eq!(values["x_next"], json!(["5/14"]));
}

#[test]
fn coefficients_of_eps_are_those_of_the_step_and_the_field_is_at_0() {
    let field = "xdot = y + eps^2*x^2; ydot = -x;";
    let values = object(&["eval", "--field", field, "--eps", "1/2", "--at", "2,1", "--json"]);
    assert_eq!(values["field"], json!(["1", "-2"]));
    assert_eq!(values["A"], json!([["1/2", "-1/2"], ["1/2", "1"]]));
}

#[test]
fn the_readable_form_shows_the_same_values() {
    let page = answer(&["eval", "e1", "--eps", "1/2", "--at", "-2,1,1/3"]);
    assert!(page.contains("(2, -1, -2/3)") && page.contains("undefined"), "{page}");
}
