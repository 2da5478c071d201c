//! Tests that in other units of length and time, every number changes by a power of two.

use serde_json::Value;

use crate::running::{answer, object, text};

/// A driven oscillator. If q is 2^k, lengths are multiplied by 2^−k. If nu is 2^j, times are
/// multiplied by 2^−j.
const FIELD: &str = "xdot = nu*y; ydot = nu*(0.1/q - x - 0.2*y + 0.3*q*x^2);";
const UNITS: [[i32; 2]; 4] = [[40, 0], [-250, 0], [0, 30], [17, -40]];

fn scaled(n: i64, exponent: i32) -> String {
    let power = f64::from(exponent.abs()).exp2();
    if exponent < 0 { format!("{n}/{power:.0}") } else { format!("{:.0}", n as f64 * power) }
}

/// Returns the arguments in scaled units. In unscaled units, the start is (3/4, 1/4) and ε is 1/8.
fn arguments(command: &str, [k, j]: [i32; 2], more: &[&str]) -> Vec<String> {
    let (start, eps) = (format!("{},{}", scaled(3, -k - 2), scaled(1, -k - 2)), scaled(1, -j - 3));
    let values = [format!("q={}", scaled(1, k)), format!("nu={}", scaled(1, j))];
    let given = [command, "--field", FIELD, "--param", &values[0], "--param", &values[1]];
    let given = given.into_iter().chain(["--eps", &eps, "--at", &start]).chain(more.iter().copied());
    given.map(str::to_owned).collect()
}

fn run<R>(run: impl Fn(&[&str]) -> R, arguments: &[String]) -> R {
    run(&arguments.iter().map(String::as_str).collect::<Vec<_>>())
}

/// Returns the numbers of a table, each column scaled by a power of two. Cells may be empty.
fn numbers(table: &str, exponents: &[i32]) -> Vec<Option<f64>> {
    let rows = table.lines().skip(1).flat_map(|row| row.split(',').zip(exponents));
    rows.map(|(cell, exponent)| Some(cell.parse::<f64>().ok()? * f64::from(*exponent).exp2())).collect()
}

fn of(value: &Value, exponent: i32) -> Vec<f64> {
    match value {
        Value::Array(values) => values.iter().flat_map(|value| of(value, exponent)).collect(),
        Value::Object(values) => values.values().flat_map(|value| of(value, exponent)).collect(),
        value => value.as_f64().map(|number| number * f64::from(exponent).exp2()).into_iter().collect(),
    }
}

#[test]
fn tables_of_orbits_and_sections_are_the_same_in_every_unit() {
    let table = |command: &str, unit: [i32; 2], more: &[&str]| {
        let [k, j] = unit;
        numbers(&run(answer, &arguments(command, unit, more)), &[0, j, k, k])
    };
    for order in ["2", "8"] {
        let more = ["--steps", "50", "--order", order];
        let ordinary = table("orbit", [0, 0], &more);
        assert!(ordinary.len() >= 200);
        for unit in UNITS {
            assert_eq!(table("orbit", unit, &more), ordinary, "{order} in {unit:?}");
        }
    }
    let more = ["--plane", "x - 1/10/q", "--direction", "both", "--steps", "300"];
    let ordinary = table("section", [0, 0], &more);
    assert!(ordinary.len() > 20);
    for unit in UNITS {
        assert_eq!(table("section", unit, &more), ordinary, "{unit:?}");
    }
}

#[test]
fn dynamics_are_the_same_in_every_unit() {
    let said = |unit: [i32; 2]| {
        let [k, j] = unit;
        let found = run(object, &arguments("dynamics", unit, &["--steps", "300", "--json"]));
        let rates = ["lyapunov", "lyapunov_error", "spectrum", "spectrum_errors", "mean_log_det"]
            .map(|name| of(&found[name], -j));
        let others = ["steps", "fli", "megno", "sali", "rotation"].map(|name| of(&found[name], 0));
        [rates.concat(), others.concat(), of(&found["extrema"], k)].concat()
    };
    let ordinary = said([0, 0]);
    assert_eq!(ordinary.len(), 7 + 8 + 4);
    for unit in UNITS {
        assert_eq!(said(unit), ordinary, "{unit:?}");
    }
}

#[test]
fn charts_are_the_same_in_every_unit() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("chart.csv");
    let cells = |unit: [i32; 2], colour: &str| {
        let k = unit[0];
        let over = ["x", "y"].map(|name| format!("{name}=0:{}:/6", scaled(1, -k)));
        let file = out.to_str().expect("UTF-8");
        let more =
            ["--over", &over[0], "--over", &over[1], "--steps", "100", "--color", colour, "--out", file];
        run(answer, &arguments("chart", unit, &more));
        numbers(&text(&std::fs::read(&out).expect("a table")), &[k, k, 0])
    };
    for colour in ["sali", "fli", "megno"] {
        let ordinary = cells([0, 0], colour);
        assert_eq!(ordinary.len(), 3 * 36);
        for unit in UNITS {
            assert_eq!(cells(unit, colour), ordinary, "{colour} in {unit:?}");
        }
    }
}

#[test]
fn cycles_and_branches_are_the_same_in_every_unit() {
    let said = |unit: [i32; 2]| {
        let [k, j] = unit;
        let over = format!("eps={}:{}:+{}", scaled(1, -j - 3), scaled(1, -j - 1), scaled(3, -j - 6));
        let mut given = arguments("periodic", unit, &["--over", &over, "--json"]);
        let eps = given.iter().position(|word| word == "--eps").expect("an eps");
        given.drain(eps..eps + 2);
        let found = run(object, &given);
        let of_cycle = |cycle: &Value| {
            let lengths = ["points", "residual"].map(|name| of(&cycle[name], k));
            let others = ["period", "family", "multipliers"].map(|name| of(&cycle[name], 0));
            [lengths.concat(), others.concat(), of(&cycle["parameter"], j)].concat()
        };
        let points = found["branch"]["points"].as_array().expect("points").iter();
        [of_cycle(&found), points.flat_map(of_cycle).collect()].concat()
    };
    let ordinary = said([0, 0]);
    assert!(ordinary.len() > 50);
    for unit in UNITS {
        assert_eq!(said(unit), ordinary, "{unit:?}");
    }
}
