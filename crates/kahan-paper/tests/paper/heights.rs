//! Tests heights along the figures' orbits against exact values from an independent program.

use kahan_algebra::rational::Rational;
use kahan_paper::figures::Figure;
use kahan_runtime::heights::Growth;
use serde_json::Value;

use crate::paper;

/// For each system: the growth of heights h(n), and the limit of h(n+1)/h(n).
const GROWTH: [(&str, Growth, f64); 7] = [
    ("lv", Growth::Exponential, 2.0),
    ("e3", Growth::Linear, 1.0),
    ("e4", Growth::Quadratic, 1.0),
    ("e6", Growth::Quadratic, 1.0),
    ("e7", Growth::Linear, 1.0),
    ("e8", Growth::Linear, 1.0),
    ("e9", Growth::Exponential, 3.0),
];

fn expected() -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/data/heights.json");
    let text = std::fs::read_to_string(path).expect("the heights");
    serde_json::from_str(&text).expect("JSON")
}

fn texts(value: &Value) -> Vec<&str> {
    let values: Vec<&Value> = match value {
        Value::Object(entries) => entries.values().collect(),
        _ => value.as_array().into_iter().flatten().collect(),
    };
    values.into_iter().filter_map(Value::as_str).collect()
}

fn figure(system: &str, data: &Value) -> &'static Figure {
    let are = |numbers: &[(i64, i64)], texts: &[&str]| {
        let numbers = numbers.iter().map(|&(p, q)| Rational::new(p, q));
        numbers.eq(texts.iter().map(|text| Rational::parse(text).expect("a number")))
    };
    let has_data = |figure: &&Figure| {
        figure.system == system
            && Some(figure.steps) == data["iterates"].as_u64()
            && are(&[figure.eps], &[data["eps"].as_str().expect("eps")])
            && are(figure.parameters, &texts(&data["params"]))
            && are(figure.start, &texts(&data["x0"]))
    };
    Figure::all().find(has_data).unwrap_or_else(|| panic!("no figure has the data of {system}"))
}

fn fifteenth_digit(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { 10_f64.powi(value.abs().log10().floor() as i32 - 14) }
}

fn check(system: &str, data: &Value) {
    let figure = figure(system, data);
    let name = figure.name;
    let measurement = paper().measurement(figure).expect("it is one of all");
    let survey = &measurement.survey;
    assert_eq!(survey.heights.len() as u64, figure.steps + 1, "{name}");
    let mut compared = 0;
    for (component, variable) in measurement.variables.iter().enumerate() {
        let listed = data["n"].as_array().expect("indices").iter().filter_map(Value::as_u64);
        for (n, text) in listed.zip(texts(&data["h"][variable])) {
            let wanted: f64 = text.parse().expect("a number");
            let found = survey.heights[n as usize].logarithms[component];
            // Listed values have fifteen digits. Computed values may be wrong by one rounding.
            let tolerance = 0.5 * fifteenth_digit(wanted) + wanted * f64::EPSILON;
            assert!((found - wanted).abs() <= tolerance, "{name}: h({variable}_{n}) = {found:e}, not {text}");
            compared += 1;
        }
        let digits = data["decimal_digits_of_last_height"][variable].as_u64();
        assert_eq!(survey.heights.last().map(|last| last.digits[component]), digits, "{name}, {variable}");
    }
    assert_eq!(compared, data["n"].as_array().map_or(0, Vec::len) * measurement.variables.len());
    let (_, growth, factor) = GROWTH.iter().find(|(known, ..)| *known == system).expect("a figure's system");
    assert_eq!(survey.growth, *growth, "{name}");
    assert!((survey.entropy - factor.ln()).abs() < 1e-3, "{name}: entropy {}", survey.entropy);
}

#[test]
fn every_height_of_the_figures_agrees_to_fifteen_digits() {
    let data = expected();
    let systems = data["systems"].as_object().expect("systems");
    assert_eq!(systems.len(), GROWTH.len());
    for (system, data) in systems {
        check(system, data);
    }
}
