//! The systems of the paper, from the data of its figures.

use std::thread;

use kahan_runtime::heights::{Growth, Survey};
use serde_json::Value;

use crate::support::{catalog, orbit};

fn expected() -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/data/heights.json");
    let text = std::fs::read_to_string(path).expect("the heights");
    serde_json::from_str(&text).expect("JSON")
}

/// How the heights of the figures grow, and the factor by which each step multiplies them in the
/// end.
const GROWTH: [(&str, Growth, f64); 7] = [
    ("lv", Growth::Exponential, 2.0),
    ("e3", Growth::Linear, 1.0),
    ("e4", Growth::Quadratic, 1.0),
    ("e6", Growth::Quadratic, 1.0),
    ("e7", Growth::Linear, 1.0),
    ("e8", Growth::Linear, 1.0),
    ("e9", Growth::Exponential, 3.0),
];

fn texts(value: &Value) -> Vec<&str> {
    value.as_array().into_iter().flatten().filter_map(Value::as_str).collect()
}

/// One unit of the fifteenth significant digit of a decimal as it is written.
fn fifteenth_digit(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { 10_f64.powi(value.abs().log10().floor() as i32 - 14) }
}

/// Compares one system with the file: every height that is listed, and the digits of the last.
fn check(name: &str, data: &Value) {
    let parameters: Vec<&str> =
        data["params"].as_object().expect("parameters").values().filter_map(Value::as_str).collect();
    let eps = data["eps"].as_str().expect("eps");
    let system = catalog(name);
    let mut orbit = orbit(&system, &parameters.join(","), eps, &texts(&data["x0"]).join(","));
    let steps = data["iterates"].as_u64().expect("a number") as usize;
    let survey = Survey::of(&mut orbit, steps, |_| ());
    assert_eq!(survey.heights.len(), steps + 1, "{name}");
    let mut compared = 0;
    for (component, variable) in system.field.symbols.states.iter().enumerate() {
        let listed = data["n"].as_array().expect("indices").iter().filter_map(Value::as_u64);
        for (n, text) in listed.zip(texts(&data["h"][variable])) {
            let wanted: f64 = text.parse().expect("a number");
            let found = survey.heights[n as usize].logarithms[component];
            // Half a unit for the rounding of the file, and an ulp for that of the double.
            let tolerance = 0.5 * fifteenth_digit(wanted) + wanted * f64::EPSILON;
            assert!((found - wanted).abs() <= tolerance, "{name}: h({variable}_{n}) = {found:e}, not {text}");
            compared += 1;
        }
        let digits = data["decimal_digits_of_last_height"][variable].as_u64();
        assert_eq!(survey.heights.last().map(|last| last.digits[component]), digits, "{name}, {variable}");
    }
    assert_eq!(compared, data["n"].as_array().map_or(0, Vec::len) * system.field.dimension());
    let (_, growth, factor) = GROWTH.iter().find(|(known, ..)| *known == name).expect("a figure's system");
    assert_eq!(survey.growth, *growth, "{name}");
    assert!((survey.entropy - factor.ln()).abs() < 1e-3, "{name}: entropy {}", survey.entropy);
}

#[test]
fn every_height_of_the_figures_agrees_to_fifteen_digits() {
    let data = expected();
    let systems = data["systems"].as_object().expect("systems");
    assert_eq!(systems.len(), 7);
    thread::scope(|scope| {
        let checks: Vec<_> =
            systems.iter().map(|(name, data)| scope.spawn(move || check(name, data))).collect();
        for check in checks {
            check.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        }
    });
}

#[test]
fn the_other_systems_grow_as_the_paper_says() {
    let start = "3/7,11/13,23/47";
    let cases = [
        ("e1", "", Growth::Logarithmic),
        ("e2", "", Growth::Logarithmic),
        ("e5", "", Growth::Linear),
        ("euler", "1,2,-3", Growth::Quadratic),
        // Where E9 is E3 and E4, it grows as they do, though the factor that E3 loses stays.
        ("e9", "1", Growth::Linear),
        ("e9", "-1", Growth::Quadratic),
        ("e7", "1", Growth::Logarithmic),
    ];
    for (name, parameters, growth) in cases {
        let steps = if growth == Growth::Quadratic { 40 } else { 200 };
        let survey = Survey::of(&mut orbit(&catalog(name), parameters, "1/2", start), steps, |_| ());
        assert_eq!(survey.growth, growth, "{name} {parameters}");
        assert_eq!(survey.entropy, 0.0, "{name}");
        assert_eq!(survey.stopped, None);
    }
}
